#!/usr/bin/env bash
# Changes the sources, one operator or one function's answer at a time, and prints which changes no test notices: all are tried
# by the unit tests, in seconds each; what these miss is tried by the groups `law` and `physics` too, in minutes each. Fails where
# more are missed in a function than tests/harden/survivors.txt explains.
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
missed=$folder/mutants.out/missed.txt
echo "$(wc -l <"$missed") changes that no test notices, in $missed"
# A change is `FILE:LINE:COLUMN: WHAT in FUNCTION`, or `...: replace FUNCTION -> TYPE with VALUE`, or of a constant.
unexplained=$(awk '
    FNR == NR && !/^#/ && NF { split($0, part, " [|] "); split(part[1], count, " "); known[count[2] " | " part[2]] = count[1] }
    FNR == NR { next }
    {
        file = $0; sub(/:.*/, "", file)
        place = $0
        if (!sub(/.* in /, "", place) && !(sub(/^[^ ]* replace /, "", place) && sub(/ -> .*| with [^ ]*$/, "", place) && place ~ /[a-z]/))
            place = "constants"
        missed[file " | " place]++
    }
    END { for (key in missed) if (missed[key] > known[key]) print missed[key] + 0, "(" known[key] + 0 " explained)", key }
' tests/harden/survivors.txt "$missed" | sort -k4)
if [ -n "$unexplained" ]; then
    printf '== more than tests/harden/survivors.txt explains: write a test that notices them, or a line there\n%s\n' "$unexplained" >&2
    exit 1
fi
