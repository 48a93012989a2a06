#!/usr/bin/env bash
# Tests the JavaScript package and the explorer: types, every function, the numbers of the Python package of the source
# tree, layouts against a C compiler, copied programs, and the page in Chromium.
#
# usage: js/test.sh [--quick]     --quick: the package alone, without the explorer
# CARGO_TARGET_DIR is honoured, CHROMIUM names the browser; FIREFOX=/usr/bin/firefox-esr has the page tried in Firefox in its
# place, all but the picture and accessibility. tests/setup.sh validation web installs what it needs; the
# versions of packages from npm are those of package-lock.json.
set -euo pipefail
cd "$(dirname "$0")/.."

if [ "${1:-}" = --quick ]; then
    tests/setup.sh node
    tests=(test/package.test.mjs test/smoke.test.mjs test/guide.test.mjs test/layout.test.mjs)
else
    tests/setup.sh validation web
    cd js && tests=(test/*.test.mjs) && cd ..
fi
CARGO_TARGET_DIR=$(realpath -m "${CARGO_TARGET_DIR:-target}")
export CARGO_TARGET_DIR
for tool in cargo cc c++ gfortran clang; do
    command -v "$tool" >/dev/null || { echo "js/test.sh: $tool is missing; run tests/setup.sh core web" >&2; exit 1; }
done

cargo build --release --locked --quiet
js/build.sh
cd js
node_modules/.bin/tsc --noEmit --strict --target es2022 --module nodenext test/types.ts
mkdir -p "$CARGO_TARGET_DIR/js-tests"
node --test --test-reporter=spec "${tests[@]}" >"$CARGO_TARGET_DIR/js-tests/report.txt" ||
    { cat "$CARGO_TARGET_DIR/js-tests/report.txt" >&2; exit 1; }
grep -E '^. (tests|pass|fail) ' "$CARGO_TARGET_DIR/js-tests/report.txt"
