#!/usr/bin/env bash
# What the law costs in each host: the time of its run with the law over that with a constant coefficient. Prints the
# median of some runs of the host's program, with the least and the greatest: rows for the table of docs/dev/reliability.md.
#
# usage: hosts/costs.sh [HOST...]        all that tell a cost when none is named; RUNS=5
set -euo pipefail
cd "$(dirname "$0")/.."
runs=${RUNS:-5}
log=$(realpath -m "${CARGO_TARGET_DIR:-target}")/hosts/costs.txt
mkdir -p "$(dirname "$log")"
[ $# -gt 0 ] || set -- mujoco lammps

echo "$(date -u +%Y-%m-%d), $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores," \
    "load average $(cut -d' ' -f1 /proc/loadavg); medians of $runs runs (least to greatest)"
for host in "$@"; do
    : >"$log"
    # What would take too long in a test has a script of its own.
    script=hosts/$host/cost.sh
    [ -x "$script" ] || script=hosts/$host/run.sh
    for run in $(seq "$runs"); do
        # A cost.sh need not install and build again what its first run did; a run.sh takes no argument.
        again=""
        [ "$run" = 1 ] || [ "${script##*/}" = run.sh ] || again=again
        # shellcheck disable=SC2086
        "$script" $again >"$log.run" 2>&1 || { tail -n 5 "$log.run" >&2; exit 1; }
        # "constant mu 1.2 s; the law at the lagged force x 1.02, at the current force x 1.85" has two costs.
        sed -nE "s/^$host +cost +//p" "$log.run" | grep -oE '(at the [a-z]+ force )?x [0-9.]+' >>"$log" ||
            { echo "hosts/costs.sh: $host tells no cost" >&2; exit 1; }
    done
    sed -E 's/^(at the ([a-z]+) force )?x /\2 /' "$log" | sort -k1,1 -k2,2n | awk -v host="$host" '
        function row() {
            middle = int((n + 1) / 2)
            median = n % 2 ? value[middle] : (value[middle] + value[middle + 1]) / 2
            printf "| %s%s | %.2f (%.2f to %.2f) |\n", host, kind, median, value[1], value[n]
        }
        { name = NF == 2 ? ", " $1 " force" : ""; cost = $NF }
        NR > 1 && name != kind { row(); n = 0 }
        { kind = name; value[++n] = cost }
        END { row() }'
done
