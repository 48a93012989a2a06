#!/usr/bin/env bash
# Tests the Python package: installs it into a virtual environment under the target directory, checks its types and runs
# its tests there, among them those of the wheel, the source distribution and the guide. The environment is kept as long as
# pyproject.toml and the interpreter stay; the package itself is installed anew each time.
#
# usage: python/test.sh [PYTEST-ARGUMENT ...]
# PYTHON names the interpreter (python3), 3.10 or later for SurfaceTopography; CARGO_TARGET_DIR is honoured. Needs cargo,
# a C compiler and, for pip, PyPI.
set -euo pipefail
cd "$(dirname "$0")/.."

target="${CARGO_TARGET_DIR:-target}"
mkdir -p "$target"
target="$(cd "$target" && pwd)"
# Compiled once for all processes, outside of the checkout; only what is imported.
export CARGO_TARGET_DIR="$target" PYTHONPYCACHEPREFIX="$target/python-cache"
unset ASPERITY_LIBRARY PYTHONPATH

for tool in "${PYTHON:-python3}" cargo cc; do
    command -v "$tool" >/dev/null || { echo "python/test.sh: needs $tool; see tests/setup.sh" >&2; exit 1; }
done
before="$(git status --porcelain)"

made_from="$("${PYTHON:-python3}" -VV; cat python/pyproject.toml)"
if [ "$(cat "$target/python-venv/made_from" 2>/dev/null)" != "$made_from" ]; then
    rm -rf "$target/python-venv"
    "${PYTHON:-python3}" -m venv "$target/python-venv"
fi
pip() { "$target/python-venv/bin/pip" --quiet --disable-pip-version-check install --no-compile "$@"; }
pip './python[fit,plot,test,topography]'
printf '%s\n' "$made_from" >"$target/python-venv/made_from"

cd python
"$target/python-venv/bin/mypy" --cache-dir "$target/python-mypy" src tests examples
"$target/python-venv/bin/pytest" -n auto --basetemp "$target/python-tests" "$@"
cd ..

if [ "$(git status --porcelain)" != "$before" ]; then
    echo "python/test.sh: the tests left files behind:" >&2
    git status --short >&2
    exit 1
fi
