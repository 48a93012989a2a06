#!/usr/bin/env bash
# Builds and runs the box on an incline; the last line says PASS or FAIL.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
pkg-config --exists simbody || fail "Simbody is missing: apt-get install libsimbody-dev"
# shellcheck disable=SC2046
compile incline -isystem /usr/include/simbody $(pkg-config --libs simbody)
verdict "$build/incline"
