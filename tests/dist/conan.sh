#!/usr/bin/env bash
# Builds the Conan package from source, static and shared, each with its test program. CONAN_HOME is honoured.
#
# usage: tests/dist/conan.sh WORK CONAN
set -euo pipefail
cd "$(dirname "$0")/../.."
. tests/dist/shared.sh
work=$1 conan=$2
mkdir -p "$work"
"$conan" profile detect --exist-ok >/dev/null 2>&1
for shared in False True; do
    "$conan" create packaging/conan -o "&:shared=$shared" --test-folder=test_package >"$work/log" 2>&1 ||
        { tail -n 60 "$work/log" >&2; fail "failed with shared=$shared"; }
    grep -q "^asperity .*: friction " "$work/log" || fail "the test program did not run"
done
