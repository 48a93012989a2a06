#!/usr/bin/env bash
# Measures, counts instructions, and puts the results between the marks in docs/performance.md, with date and machine.
#
# usage: benches/report.sh PROGRAM      (make bench builds the program and calls this)
set -euo pipefail

program=$1
cd "$(dirname "$0")/.."
work=$(dirname "$program")
document=docs/performance.md

command -v valgrind >/dev/null || { echo "benches/report.sh: valgrind is missing: tests/setup.sh installs it" >&2; exit 1; }

# Instructions of a call per contact: what two more passes over the loads add.
instructions() {
    local passes count=() loads
    loads=$("$program" --loads)
    for passes in 1 3; do
        valgrind --tool=callgrind --callgrind-out-file=/dev/null "$program" --only "$1" "$passes" >"$work/callgrind.log" 2>&1 ||
            { cat "$work/callgrind.log" >&2; return 1; }
        count+=("$(awk '/Collected/ { print $NF }' "$work/callgrind.log")")
    done
    awk -v a="${count[0]}" -v b="${count[1]}" -v n="$loads" 'BEGIN { printf "%.1f", (b - a) / (2 * n) }'
}

results=$work/results.md
{
    echo "Measured $(date -u '+%Y-%m-%d %H:%M') UTC by \`make bench\` on $(nproc) cores of" \
        "$(awk -F': *' '/model name/ { print $2; exit }' /proc/cpuinfo)" \
        "(family $(awk -F': *' '/cpu family/ { print $2; exit }' /proc/cpuinfo)," \
        "model $(awk -F': *' '/^model\t/ { print $2; exit }' /proc/cpuinfo)," \
        "$(grep -qw avx512dq /proc/cpuinfo && echo AVX-512 || { grep -qw avx2 /proc/cpuinfo && echo AVX2 || echo 'no AVX2'; }));" \
        "load average at the start $(cut -d' ' -f1 /proc/loadavg)." \
        "$("${CXX:-c++}" --version | head -1), $(rustc --version), glibc $(getconf GNU_LIBC_VERSION | cut -d' ' -f2)."
    echo
    "$program" docs/performance.svg
    echo
    echo "### Instructions"
    echo
    echo "Counted by $(valgrind --version)'s callgrind per contact, loop included."
    echo
    echo "| call | instructions per contact |"
    echo "|---|---|"
    for call in exp "scalar mu" "scalar F" "batch mu" "batch F" "batch F and dF/dP"; do
        count=$(instructions "$call")
        echo "| $call | $count |"
    done
} >"$results"

awk -v results="$results" '
    /^<!-- measured: begin/ { print; print ""; while ((getline line < results) > 0) print line; skip = 1; begun = 1 }
    /^<!-- measured: end/ { print ""; skip = 0; ended = 1 }
    !skip { print }
    END { exit !(begun && ended) }' "$document" >"$work/performance.md" ||
    { echo "benches/report.sh: $document has lost its marks" >&2; exit 1; }
cp "$work/performance.md" "$document"
if grep -q MISSED "$results"; then grep MISSED "$results"; else echo "all limits met"; fi
