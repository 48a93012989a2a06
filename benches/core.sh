#!/usr/bin/env bash
# Prints what the numerical core costs: its lines of code and constants, the instructions of a model and of an exact state, and
# the memory of models.
#
# usage: benches/core.sh PROGRAM      (make core builds the program and calls this)
set -euo pipefail

program=$1
cd "$(dirname "$0")/.."
folders="src/population src/equilibrium src/law src/distribution"

if ! command -v valgrind >/dev/null; then
    echo "benches/core.sh: valgrind is missing: tests/setup.sh installs it" >&2
    exit 1
fi

# Sources without comments, blank lines and tests, which are the end of a file or a file of their own.
code() {
    find "$@" -name '*.rs' ! -name 'tests.rs' -print0 | sort -z | while IFS= read -r -d '' file; do
        awk '/^#\[cfg\(test\)\]/ { exit } !/^[ \t]*(\/\/|$)/' "$file"
    done
}

collected() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$program" "$@" 2>&1 | awk '/Collected/ { print $NF }'
}

# Millions of instructions for one, as what more of them add to a run.
millions() {
    local what=$1 surface=$2 times=$3 one several
    one=$(collected "$what" "$surface" 1)
    several=$(collected "$what" "$surface" $((times + 1)))
    awk -v count=$((several - one)) -v times="$times" 'BEGIN { printf "%.2f", count / times / 1e6 }'
}

echo "| | |"
echo "|---|---|"
echo "| lines of code of $folders, no comments, no tests | $(code $folders | wc -l) |"
echo "| scalar constants in them | $(code $folders | grep -cE '^ *(pub(\([a-z]+\))? )?const [A-Z_0-9]+: (f64|[ui](8|16|32|64|size))\b') |"
echo "| lines of src/, all | $(find src -name '*.rs' -exec cat {} + | wc -l) |"
for surface in "default" "skew 1" "epsilon .5" "spectral moments" "histogram"; do
    echo "| million instructions of a model: $surface | $(millions make "$surface" 1) |"
done
for surface in "default" "epsilon .5"; do
    echo "| million instructions of an exact state at a load: $surface | $(millions state "$surface" 10) |"
done
dumps=$(mktemp -d)
trap 'rm -rf "$dumps"' EXIT
valgrind --tool=callgrind --callgrind-out-file="$dumps/calls" "$program" calls 2>/dev/null
# Each dump but the last names its surface, kind of load and call; ordinary loads come first.
cat "$dumps"/calls.* | awk -F ': |[|]' '
    /^desc: Trigger: Client Request/ { surface = $4; kind = $5; call = $6 }
    /^(summary|totals)/ && kind != "" {
        if (kind == "ordinary") ordinary[surface call] = $2
        count[surface "," kind "," call] = $2; key[surface "," kind "," call] = surface call; kind = "" }
    END {
        for (name in count) {
            ratio = count[name] / ordinary[key[name]]
            if (ratio > most) { most = ratio; dearest = name }
        }
        printf "| instructions of the dearest load of a solver, in ordinary ones (at most 3): %s | %.2f%s |\n", dearest, most,
            (most > 3 ? " **MISSED**" : "") }'
"$program" memory | while IFS=$'\t' read -r surface size; do
    echo "| KiB of a model: $surface | $size |"
done
