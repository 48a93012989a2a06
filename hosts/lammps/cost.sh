#!/usr/bin/env bash
# What the law costs in LAMMPS: 32,000 grains on a moving belt with the law, with a constant coefficient in the same style, and
# in LAMMPS' own gran/hertz/history with as stiff springs. hosts/costs.sh repeats it and takes medians.
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
[ "${1:-}" = again ] || { install_lammps && settle; }

# Processor time of the loop. Short runs in turn, of which the fastest counts, since other programs slow each of them.
seconds() {
    lammps 1 "$here/pack.in" cost.log -var data "$build/settled.data" -var copies 80 -var steps 60 -var style "$1"
    awk '/^Loop time/ { wall = $4 } / CPU use / { print wall * $1 / 100 }' "$build/cost.log"
}
declare -A least=([law]=1e9 [constant]=1e9 [builtin]=1e9)
for _ in 1 2 3 4 5; do
    for style in law constant builtin; do
        least[$style]=$(awk -v a="${least[$style]}" -v b="$(seconds "$style")" 'BEGIN { print a < b ? a : b }')
    done
done
awk -v law="${least[law]}" -v constant="${least[constant]}" -v builtin="${least[builtin]}" 'BEGIN {
    printf "lammps  cost  constant mu %.2f s; the law x %.2f\n", constant, law / constant
    printf "lammps  gran/hertz/history %.2f s; the law takes %.2f times as long\n", builtin, law / builtin }'
