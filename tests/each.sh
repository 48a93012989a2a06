#!/usr/bin/env bash
# Runs commands one after another, up to the first that fails, and says how long each took.
#
# usage: tests/each.sh NAME COMMANDS     COMMANDS: one on each line
set -uo pipefail
name=$1
begin=$SECONDS times=""
while read -r command; do
    echo "== $command"
    start=$SECONDS
    # shellcheck disable=SC2086
    $command </dev/null || {
        echo "== failed: $command" >&2
        full=$(df -Ph . /tmp | awk 'NR > 1 && $4 ~ /^[0-9.]+[KM]?$/ {print $6 " has " $4 "B left"}' | sort -u)
        [ -z "$full" ] || echo "   the disk is full, or nearly so: $full; make test-all takes 8 GB" >&2
        exit 1
    }
    times+=$(printf '%6d s  %s' "$((SECONDS - start))" "$command")$'\n'
done <<<"$2"
printf '== %s passed in %d s\n%s' "$name" "$((SECONDS - begin))" "$times"
