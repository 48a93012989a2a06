#!/usr/bin/env bash
# Installs PyBullet and this library's Python package into an environment, runs the box on an incline; the last line
# says PASS or FAIL.
#
# usage: hosts/bullet/run.sh [again]       again: with what the run before installed
set -euo pipefail
cd "$(dirname "$0")/../.."
environment=${CARGO_TARGET_DIR:-target}/bullet-venv

fail() {
    echo "bullet  FAIL  $*"
    exit 1
}
cmake/check_rust.sh || fail "the library does not build"

if [ "${1:-}" != again ]; then
    python3 -m venv "$environment" || fail "no virtual environment: apt-get install python3-venv"
    # Where PyPI has no wheel for this Python, it would be compiled, for half an hour.
    "$environment/bin/pip" install --quiet --no-compile --disable-pip-version-check --only-binary pybullet \
        pybullet==3.2.7 || fail "PyPI has no wheel of PyBullet 3.2.7 for $(python3 --version)"
    "$environment/bin/pip" install --quiet --no-compile --disable-pip-version-check ./python ||
        fail "the asperity package does not install"
fi
status=0
"$environment/bin/python" hosts/bullet/incline.py || status=$?
[ "$status" -le 1 ] || fail "the box ended with status $status"
exit "$status"
