#!/usr/bin/env bash
# Builds the JavaScript package and the explorer in js/dist, with the packages of package-lock.json.
#
# usage: js/build.sh      needs cargo with the target wasm32-unknown-unknown, node and npm: tests/setup.sh web
set -euo pipefail
cd "$(dirname "$0")"

for tool in cargo node npm; do
    command -v "$tool" >/dev/null || { echo "js/build.sh: $tool is missing; run tests/setup.sh web" >&2; exit 1; }
done
# npm ci begins with nothing: once for each list of packages.
if ! cmp -s package-lock.json node_modules/installed-lock.json; then
    npm ci --no-audit --no-fund --loglevel=error
    cp package-lock.json node_modules/installed-lock.json
fi
node tools/build.mjs
