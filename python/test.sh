#!/usr/bin/env bash
# Tests the Python package: installs it into a fresh virtual environment under the target directory, checks its types
# and runs its tests there, among them those of the wheel, the source distribution and the guide.
#
# usage: python/test.sh [PYTEST-ARGUMENT ...]
# PYTHON names the interpreter (python3), 3.10 or later for SurfaceTopography; CARGO_TARGET_DIR is honoured. Needs cargo,
# a C compiler and, for pip, PyPI.
set -euo pipefail
cd "$(dirname "$0")/.."

target="${CARGO_TARGET_DIR:-target}"
mkdir -p "$target"
target="$(cd "$target" && pwd)"
export CARGO_TARGET_DIR="$target" PYTHONDONTWRITEBYTECODE=1
unset ASPERITY_LIBRARY PYTHONPATH

for tool in "${PYTHON:-python3}" cargo cc; do
    command -v "$tool" >/dev/null || { echo "python/test.sh: needs $tool; see tests/setup.sh" >&2; exit 1; }
done
before="$(git status --porcelain)"

rm -rf "$target/python-venv"
"${PYTHON:-python3}" -m venv "$target/python-venv"
"$target/python-venv/bin/pip" install --quiet --disable-pip-version-check './python[fit,jax,plot,test,topography,warp]'
cd python
"$target/python-venv/bin/mypy" --cache-dir "$target/python-mypy" src tests examples
"$target/python-venv/bin/pytest" --basetemp "$target/python-tests" "$@"
cd ..

if [ "$(git status --porcelain)" != "$before" ]; then
    echo "python/test.sh: the tests left files behind:" >&2
    git status --short >&2
    exit 1
fi
