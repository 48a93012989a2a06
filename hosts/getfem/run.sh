#!/usr/bin/env bash
# Puts this library's Python package beside Debian's GetFEM, runs the block; the last line says PASS or FAIL.
# The picture goes to hosts/getfem/block.svg of the target directory.
#
# usage: hosts/getfem/run.sh [again]       again: with what the run before installed
set -euo pipefail
cd "$(dirname "$0")/../.."
target=${CARGO_TARGET_DIR:-target}
environment=$target/getfem-venv

fail() {
    echo "getfem  FAIL  $*"
    exit 1
}
cmake/check_rust.sh || fail "the library does not build"

# Debian's GetFEM belongs to Debian's Python, whichever python3 comes first in PATH.
/usr/bin/python3 -c "import getfem, matplotlib" ||
    fail "GetFEM or Matplotlib is missing: apt-get install python3-getfem python3-matplotlib"
if [ "${1:-}" != again ]; then
    /usr/bin/python3 -m venv --system-site-packages "$environment" ||
        fail "no virtual environment: apt-get install python3-venv"
    "$environment/bin/pip" install --quiet --disable-pip-version-check ./python ||
        fail "the asperity package does not install"
fi
mkdir -p "$target/hosts/getfem"
status=0
"$environment/bin/python" hosts/getfem/block.py "$target/hosts/getfem/block.svg" || status=$?
[ "$status" -le 1 ] || fail "the block ended with status $status"
exit "$status"
