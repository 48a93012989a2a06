#!/usr/bin/env bash
# Changes the sources, one operator or one function's answer at a time, and prints which changes no test notices: all are tried
# by the unit tests, in seconds each; what these miss is tried by the groups `law` and `physics` too, in minutes each.
#
# usage: tests/harden/mutants.sh FOLDER [OPTION...]      results are in FOLDER/mutants.out; options are those of cargo-mutants:
#            --re '^src/law/'   those of a folder or file        --shard 0/8   a part of them
set -euo pipefail

folder=$1
shift
cd "$(dirname "$0")/../.."
if ! cargo mutants --version >/dev/null 2>&1; then
    echo "tests/harden/mutants.sh: cargo-mutants is missing: tests/setup.sh harden installs it" >&2
    exit 1
fi
mkdir -p "$folder"
rm -rf "$folder/mutants.out"

# What is missed (2) or never ends (3) is a result.
tried() {
    local status=0
    cargo mutants --output "$folder" --no-shuffle "$@" || status=$?
    [[ $status == [023] ]] || exit "$status"
}

echo "== the unit tests"
tried "$@" --timeout 10 --cargo-arg=--lib
# A change after which a test never ends is noticed.
cat "$folder/mutants.out/timeout.txt" >> "$folder/mutants.out/caught.txt"
if [ -s "$folder/mutants.out/missed.txt" ]; then
    echo "== what they missed, by the groups law and physics"
    tried "$@" --iterate --timeout 600 --cargo-arg={--lib,--test=law,--test=physics}
fi
echo "$(wc -l < "$folder/mutants.out/missed.txt") changes that no test notices, in $folder/mutants.out/missed.txt"
