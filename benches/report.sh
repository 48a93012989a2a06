#!/usr/bin/env bash
# Measures, and puts the results between marks in docs/dev/performance.md, with date and machine.
#
# usage: benches/report.sh PROGRAM      (make bench builds the program and calls this)
set -euo pipefail

program=$1
cd "$(dirname "$0")/.."
page=docs/dev/performance.md
results=$program.md

of_processor() { awk -F'[ \t]*: *' -v key="$1" '$1 == key { print $2; exit }' /proc/cpuinfo; }
{
    echo "Measured $(date -u '+%Y-%m-%d %H:%M') UTC on $(nproc) cores of $(of_processor 'model name') (family $(of_processor 'cpu family')," \
        "model $(of_processor model), $(grep -qw avx2 /proc/cpuinfo && echo AVX2 || echo "no AVX2")), with $("${CXX:-c++}" --version | head -1)," \
        "$(rustc --version) and $(getconf GNU_LIBC_VERSION); load average at the start $(cut -d' ' -f1 /proc/loadavg)."
    echo
    "$program"
} >"$results"
awk -v results="$results" '
    /^<!-- results: begin/ { print; print ""; while ((getline line < results) > 0) print line; skip = begun = 1 }
    /^<!-- results: end/ { print ""; skip = 0; ended = 1 }
    !skip { print }
    END { exit !(begun && ended) }' "$page" >"$program.page" || { echo "benches/report.sh: $page has lost its marks" >&2; exit 1; }
cp "$program.page" "$page"
