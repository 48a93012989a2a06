#!/usr/bin/env bash
# Builds the model for Debian's LIGGGHTS, and moves grains; the last line says PASS or FAIL.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
[ -d /usr/include/liggghts ] || fail "LIGGGHTS is missing: apt-get install --no-install-recommends liggghts libliggghts-dev mpi-default-dev"
OUTPUT=$build/libasperity_liggghts.so hosts/liggghts/build.sh || fail "the model does not build"
packages "$host" numpy
run "$environment/bin/python" hosts/liggghts/altered.py "$build/libasperity_liggghts.so" "$build/altered"
