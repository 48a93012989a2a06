#!/usr/bin/env bash
# What the law costs in LAMMPS: 32,000 grains on a moving belt with the law, with microslip, with a constant coefficient in the
# same style, and in LAMMPS' own gran/hertz/history with as stiff springs. hosts/costs.sh repeats it and takes medians.
#
# usage: hosts/lammps/cost.sh [again]       again: with what the run before installed and settled
set -euo pipefail
cd "$(dirname "$0")/../.."

fail() {
    echo "hosts/lammps/cost.sh: $*" >&2
    exit 1
}
# shellcheck source=hosts/lammps/environment.sh
. hosts/lammps/environment.sh
if [ "${1:-}" = again ]; then get_lammps; else install_lammps && settle; fi

# The styles in turn move the same grains, in one process; of each the fastest run counts, since other programs slow them.
styles=()
for _ in $(seq 20); do styles+=(law microslip constant builtin); done
lammps 1 "$here/pack.in" cost.log -var data "$build/settled.data" -var copies 80 -var steps 20 -var style "${styles[@]}"
awk '/^style / { style = $2 }
    /^Loop time/ { wall = $4 }
    / CPU use / { spent = wall * $1 / 100; if (!least[style] || spent < least[style]) least[style] = spent; runs++ }
    END {
        if (runs != 80) { print runs " of 80 runs in " FILENAME; exit 1 }
        law = least["law"]; microslip = least["microslip"]; constant = least["constant"]; builtin = least["builtin"]
        printf "lammps  cost  constant mu %.4f s; the law x %.2f\n", constant, law / constant
        printf "lammps  microslip %.4f s; it takes %.2f times as long as the law with one spring, by the page %.1f\n", microslip, microslip / law, told
        printf "lammps  gran/hertz/history %.4f s; the law takes %.2f times as long\n", builtin, law / builtin
        exit !(microslip / law < 1.25 * told)
    }' told="$(sed -nE 's/.*A step takes ([0-9.]+) times as long as with one spring.*/\1/p' hosts/lammps/README.md)" "$build/cost.log"
