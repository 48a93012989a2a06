#!/usr/bin/env bash
# Measures, counts instructions, and puts the results between marks in docs/dev/performance.md, with date and machine, and the
# most important of them at its top.
#
# usage: benches/report.sh PROGRAM      (make bench builds the program and calls this)
set -euo pipefail

program=$1
cd "$(dirname "$0")/.."
work=$(dirname "$program")

if ! command -v valgrind >/dev/null; then
    echo "benches/report.sh: valgrind is missing: tests/setup.sh installs it" >&2
    exit 1
fi

collected() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$program" --only "$1" "$2" >"$work/callgrind.log" 2>&1 ||
        { cat "$work/callgrind.log" >&2; return 1; }
    awk '/Collected/ { print $NF }' "$work/callgrind.log"
}

# Instructions per call: what more passes add to one.
instructions() {
    local name=$1 calls_per_pass=$2 more=$3 one several
    one=$(collected "$name" 1)
    several=$(collected "$name" $((1 + more)))
    awk -v count=$((several - one)) -v calls=$((more * calls_per_pass)) 'BEGIN { printf "%.0f", count / calls }'
}

of_processor() { awk -F'[ \t]*: *' -v key="$1" '$1 == key { print $2; exit }' /proc/cpuinfo; }

vectors() { grep -qw avx2 /proc/cpuinfo && echo AVX2 || echo "no AVX2"; }

results=$work/results.md
"$program" --list >"$work/calls.txt"
{
    echo "Measured $(date -u '+%Y-%m-%d %H:%M') UTC by \`make bench\` on $(nproc) cores of" \
        "$(of_processor 'model name') (family $(of_processor 'cpu family'), model $(of_processor model), $(vectors));" \
        "load average at the start $(cut -d' ' -f1 /proc/loadavg)." \
        "$("${CXX:-c++}" --version | head -1), $(rustc --version), $(getconf GNU_LIBC_VERSION)."
    echo
    "$program" docs/performance.svg
    echo
    echo "### Instructions"
    echo
    echo "Counted by $(valgrind --version)'s callgrind, per contact for batch calls, loop included."
    echo
    echo "| call | instructions |"
    echo "|---|---|"
    while IFS='|' read -r name calls_per_pass more; do
        count=$(instructions "$name" "$calls_per_pass" "$more")
        echo "| $name | $count |"
    done <"$work/calls.txt"
} >"$results"

summary=$work/summary.md
awk -f benches/summary.awk "$results" >"$summary"

# between_marks MARK FILE: FILE takes the place of what stands between these marks in the page.
page=docs/dev/performance.md
between_marks() {
    awk -v begin="^<!-- $1: begin" -v end="^<!-- $1: end" -v results="$2" '
        $0 ~ begin { print; print ""; while ((getline line < results) > 0) print line; skip = 1; begun = 1 }
        $0 ~ end { print ""; skip = 0; ended = 1 }
        !skip { print }
        END { exit !(begun && ended) }' "$page" >"$work/document.md" ||
        { echo "benches/report.sh: $page has lost its marks" >&2; exit 1; }
    cp "$work/document.md" "$page"
}
between_marks results "$results"
between_marks summary "$summary"
if grep -q MISSED "$results"; then grep MISSED "$results"; else echo "all limits met"; fi
