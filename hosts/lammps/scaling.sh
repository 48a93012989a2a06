#!/usr/bin/env bash
# How the cost of the plugin grows with the number of ranks: 8,000 grains a rank (weak), and 32,000 grains in all (strong).
# Prints the rows of hosts/lammps/README.md.
#
# usage: hosts/lammps/scaling.sh [RANKS...]       1 2 4 when none is given
set -euo pipefail
cd "$(dirname "$0")/../.."

fail() {
    echo "hosts/lammps/scaling.sh: $*" >&2
    exit 1
}
# shellcheck source=hosts/lammps/environment.sh
. hosts/lammps/environment.sh
[ $# -gt 0 ] || set -- 1 2 4
install_lammps
settle

# Time of a step in milliseconds, in the fastest of five runs: other programs slow each of them.
step_time() {
    local ranks=$1 copies=$2
    for _ in 1 2 3 4 5; do
        lammps "$ranks" "$here/pack.in" scaling.log -var data "$build/settled.data" -var copies "$copies" -var steps 50 \
            -var style law
        awk '/^Loop time/ { print 1000 * $4 / 50 }' "$build/scaling.log"
    done | sort -g | head -n 1
}
echo "$(date -u +%Y-%m-%d), $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc --all) cores," \
    "load average $(cut -d' ' -f1 /proc/loadavg)"
echo "| ranks | grains, 8,000 a rank | ms a step | 32,000 grains, ms a step |"
echo "|---|---|---|---|"
for ranks in "$@"; do
    printf '| %d | %d | %.1f | %.1f |\n' "$ranks" $((8000 * ranks)) "$(step_time "$ranks" $((20 * ranks)))" "$(step_time "$ranks" 80)"
done
