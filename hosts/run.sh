#!/usr/bin/env bash
# Runs the law inside real solvers, two at a time, and prints one line for each; fails if one fails.
#
# usage: hosts/run.sh [HOST...]        all hosts/*/run.sh when none is named
# The packages are those of `tests/setup.sh hosts`; what a host printed is left in target/hosts/HOST.log, and its page is held to it.
set -uo pipefail
cd "$(dirname "$0")/.."
logs=$(realpath -m "${CARGO_TARGET_DIR:-target}")/hosts
mkdir -p "$logs"

hosts=("$@")
if [ $# -eq 0 ]; then
    for script in hosts/*/run.sh; do
        hosts+=("$(basename "$(dirname "$script")")")
    done
fi

echo "building the library"
cmake/check_rust.sh && cargo build --quiet --release --locked -j1 || exit 1
release=$(realpath -m "${CARGO_TARGET_DIR:-target}")/release
"${CC:-cc}" -std=c11 -O2 -Wall -Wextra -Werror -Iinclude hosts/surface_test.c -o "$logs/surface_test" \
    -L"$release" -lasperity -Wl,-rpath,"$release" && "$logs/surface_test" ||
    { echo "hosts/run.sh: the check of the surfaces (hosts/surface.h) does not do what it must"; exit 1; }

# Two hosts run at a time, where there are two cores. What they cost is not told: hosts/costs.sh runs them one at a time.
run_host() {
    local host=$1 start=$SECONDS status=0
    if [ ! -x "hosts/$host/run.sh" ]; then
        echo "$host  FAIL  no hosts/$host/run.sh" >"$logs/$host.log"
        status=1
    else
        "hosts/$host/run.sh" >"$logs/$host.log" 2>&1 || status=$?
        [ "$status" -ne 0 ] || python3 hosts/page_numbers.py "$host" "$logs/$host.log" >>"$logs/$host.log" || status=$?
    fi
    echo "$status $((SECONDS - start))" >"$logs/$host.ended"
}
at_once=$(nproc)
[ "$at_once" -le 2 ] || at_once=2
begin=$SECONDS
for host in "${hosts[@]}"; do rm -f "$logs/$host.ended"; done
{
    for host in "${hosts[@]}"; do
        [ "$(jobs -pr | wc -l)" -lt "$at_once" ] || wait -n
        run_host "$host" &
    done
    wait
} &
scheduler=$!

verdicts="" failed=0 number=0
for host in "${hosts[@]}"; do
    number=$((number + 1))
    printf '[%d/%d] %s ... ' "$number" "${#hosts[@]}" "$host"
    until [ -s "$logs/$host.ended" ] || ! kill -0 "$scheduler" 2>/dev/null; do sleep 0.1; done
    read -r status seconds <"$logs/$host.ended" || status=1
    verdict=$(grep -E "^$host +(PASS|FAIL)( |$)" "$logs/$host.log" | tail -n 1)
    # Both the status and the verdict must say so: a script that dies early has neither.
    if [ "$status" -eq 0 ] && [[ "$verdict" =~ ^$host\ +PASS ]]; then
        echo "passed in $seconds s"
    else
        failed=$((failed + 1))
        [[ "$verdict" =~ ^$host\ +FAIL ]] || verdict="$host  FAIL  ended with status $status without a verdict"
        echo "FAILED; the end of $logs/$host.log:"
        tail -n 15 "$logs/$host.log" | sed 's/^/    /'
    fi
    verdicts+=$verdict$'\n'
done

if [ $# -eq 0 ]; then
    number=$((number + 1))
    python3 hosts/page_numbers.py solvers "$logs"/*.log || failed=$((failed + 1))
fi

echo
printf '%s' "$verdicts" |
    awk '{ name = $1; word = $2; sub(/^[^ ]+ +[^ ]+ +/, ""); printf "%-10s %-5s %s\n", name, word, $0 }'
echo "$((number - failed)) of $number hosts passed in $((SECONDS - begin)) s"
[ "$failed" -eq 0 ]
