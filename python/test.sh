#!/usr/bin/env bash
# Tests the Python package: installs it into a virtual environment under the target directory (python/environment.sh), checks
# its types and runs its tests there, among them those of the wheel, the source distribution, the guides and the notebooks.
#
# usage: python/test.sh [PYTEST-ARGUMENT ...]
#        python/test.sh --quick     parameters, models, bands and commands, without the packages that the others need
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

quick=(c_interface command_line docstrings export host_pages layers library loads materials microslip model params
    surface_file threads uncertainty)
if [ "${1:-}" = --quick ]; then
    environment="$(python/environment.sh quick)"
    set -- "${quick[@]/%/.py}"
    set -- "${@/#/tests/test_}"
    cd python
else
    environment="$(python/environment.sh)"
    cd python
    "$environment/bin/mypy" --cache-dir "$target/python-mypy" src tests examples ../docs/gallery
fi
# A file is one worker's: its pages build on each other, its wheel is built once and its figures drawn once.
"$environment/bin/pytest" -n auto --dist loadfile --basetemp "$target/python-tests" "$@"
cd ..

if [ -z "${ASPERITY_WRITE_PAGES:-}" ] && [ "$(git status --porcelain)" != "$before" ]; then
    echo "python/test.sh: the tests left files behind:" >&2
    git status --short >&2
    exit 1
fi
