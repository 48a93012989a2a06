#!/usr/bin/env bash
# Installs Exudyn and this library's Python package into an environment, runs the stick-slip oscillator; the last line
# says PASS or FAIL.
#
# usage: hosts/exudyn/run.sh [again]       again: with what the run before installed
set -euo pipefail
cd "$(dirname "$0")/../.."
environment=${CARGO_TARGET_DIR:-target}/exudyn-venv

fail() {
    echo "exudyn  FAIL  $*"
    exit 1
}
cmake/check_rust.sh || fail "the library does not build"

if [ "${1:-}" != again ]; then
    python3 -m venv "$environment" || fail "no virtual environment: apt-get install python3-venv"
    "$environment/bin/pip" install --quiet --disable-pip-version-check exudyn==1.13.6 scipy ||
        fail "pip cannot install exudyn and scipy"
    "$environment/bin/pip" install --quiet --disable-pip-version-check ./python ||
        fail "the asperity package does not install"
fi
status=0
"$environment/bin/python" hosts/exudyn/stick_slip.py || status=$?
[ "$status" -le 1 ] || fail "the oscillator ended with status $status"
exit "$status"
