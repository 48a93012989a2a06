#!/usr/bin/env bash
# Prints what the numerical core costs: its lines of code and constants, the instructions of what pages say the cost of, and the
# memory of models; fails where instructions are beyond a limit of benches/costs.hpp, or ten thousand models from Sq and Sdq without
# adhesion take more than half a GiB.
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

dumps=$(mktemp -d)
trap 'rm -rf "$dumps"' EXIT
counted() { valgrind --tool=callgrind --callgrind-out-file="$dumps/$1" "$program" "$1" 2>"$dumps/log" || { cat "$dumps/log" >&2; return 1; }; }

echo "| | |"
echo "|---|---|"
echo "| lines of code of $folders, no comments, no tests | $(code $folders | wc -l) |"
echo "| scalar constants in them | $(code $folders | grep -cE '^ *(pub(\([a-z]+\))? )?const [A-Z_0-9]+: (f64|[ui](8|16|32|64|size))\b') |"
echo "| lines of src/, all | $(find src -name '*.rs' -exec cat {} + | wc -l) |"
counted costs
"$program" limits >"$dumps/limits"
awk -F '\t' '
    NR == FNR { limit[$1] = $2; unit[$1] = $3; size[$1] = $4; order[++count] = $1; next }
    /^desc: Trigger: Client Request: / { name = substr($0, 32) }
    /^(summary|totals): / && name != "" { split($0, words, " "); found[name] = words[2]; name = "" }
    END {
        for (i = 1; i <= count; ++i) {
            name = order[i]
            one = found[name] / size[name] / (unit[name] == "million" ? 1e6 : 1)
            missed = !(name in found) || one > limit[name]
            printf "| %sinstructions of %s (at most %s) | %.4g%s |\n", unit[name] (unit[name] == "" ? "" : " "), name, limit[name], one, missed ? " **MISSED**" : ""
        }
    }' "$dumps/limits" "$dumps"/costs.* >"$dumps/costs"
cat "$dumps/costs"
counted kinds
# Each dump but the last names its surface, kind of load and call; ordinary loads come first.
cat "$dumps"/kinds.* | awk -F ': |[|]' '
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
            (most > 3 ? " **MISSED**" : "") }' | tee -a "$dumps/costs"
# Ten thousand models from Sq and Sdq take half a GiB at most; of surfaces that adhere a few per cent more.
"$program" memory | awk -F '\t' '{
    is_measured = $1 ~ /^Sq and Sdq, (elastic|plastic)/
    printf "| KiB of a model: %s%s | %.0f%s |\n", $1, (is_measured ? " (at most 52.4)" : ""), $2,
        (is_measured && $2 > 52.4 ? " **MISSED**" : "") }' | tee -a "$dumps/costs"
! grep -q MISSED "$dumps/costs"
