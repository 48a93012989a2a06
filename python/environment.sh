#!/usr/bin/env bash
# Makes the virtual environment of the tests and figures, or brings it up to date, and prints where it is. It is kept as
# long as pyproject.toml and the interpreter stay; the package itself is installed anew each time.
#
# usage: python/environment.sh [quick]     quick: with SciPy and Matplotlib, in an environment of its own
# PYTHON names the interpreter (python3), 3.10 or later for SurfaceTopography; CARGO_TARGET_DIR is honoured. Needs cargo
# and, for pip, PyPI.
set -euo pipefail
cd "$(dirname "$0")/.."

target="${CARGO_TARGET_DIR:-target}"
mkdir -p "$target"
target="$(cd "$target" && pwd)"
environment="$target/python-venv" what=('./python[fit,jax,plot,study,test,topography,warp]')
if [ "${1:-}" = quick ]; then
    environment="$target/python-quick-venv" what=('./python[fit,plot]' 'pytest>=7' 'pytest-xdist>=3')
fi
unset ASPERITY_LIBRARY PYTHONPATH

made_from="$("${PYTHON:-python3}" -VV; cat python/pyproject.toml)"
if [ "$(cat "$environment/made_from" 2>/dev/null)" != "$made_from" ]; then
    rm -rf "$environment"
    "${PYTHON:-python3}" -m venv "$environment"
fi
# Only what is imported is compiled, into PYTHONPYCACHEPREFIX.
CARGO_TARGET_DIR="$target" "$environment/bin/pip" --quiet --disable-pip-version-check install --no-compile "${what[@]}" >&2
printf '%s\n' "$made_from" >"$environment/made_from"
echo "$environment"
