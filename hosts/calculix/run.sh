#!/usr/bin/env bash
# Runs Debian's CalculiX on a block with the exported contact; the last line says PASS or FAIL.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
command -v ccx >/dev/null || fail "CalculiX is missing: apt-get install calculix-ccx"
library
packages calculix numpy
rm -rf "$target/hosts/calculix"
OMP_NUM_THREADS=1 run "$environment/bin/python" hosts/calculix/block.py "$target/hosts/calculix"
