#!/usr/bin/env bash
# Validation: one summit against Maugis to 50 digits and against the package Adhesion, the population against boundary
# elements (tamaas), limits in closed form, measured friction. docs/validation.md has the figures.
#
# usage: tests/validation/run.sh [long]
#   long    computes the frozen files anew as well and compares them, and fits the asperities: two hours or so
# `tests/setup.sh validation` makes the environment. CARGO_TARGET_DIR is honoured. Needs cargo.
set -euo pipefail
cd "$(dirname "$0")/../.."

target="$(realpath -m "${CARGO_TARGET_DIR:-target}")"
venv="$target/validation-venv"
export CARGO_TARGET_DIR="$target" PYTHONDONTWRITEBYTECODE=1 OMP_NUM_THREADS="${OMP_NUM_THREADS:-2}"
export PYTHONPATH="$PWD/docs"
unset ASPERITY_LIBRARY
length="${1:-short}"
[[ "$length" =~ ^(short|long)$ ]] || { echo "usage: tests/validation/run.sh [long]" >&2; exit 2; }

[ -x "$venv/bin/pytest" ] && "$venv/bin/python" -c 'import Adhesion, matplotlib, mpmath, tamaas' 2>/dev/null ||
    { echo "tests/validation/run.sh: needs tamaas and Adhesion; run tests/setup.sh validation" >&2; exit 1; }
"$venv/bin/pip" install --quiet --disable-pip-version-check --no-deps --force-reinstall ./python
"$venv/bin/pytest" -q -ra -p no:cacheprovider tests/validation

if [ "$length" = long ]; then
    mkdir -p "$target/validation"
    for pair in yielding:yielding joints:joints sticky:adhesion shaped:shaped elastic:boundary_elements; do
        name="${pair#*:}"
        "$venv/bin/python" "tests/validation/$name.py" "$target/validation/$name.csv"
        "$venv/bin/python" tests/validation/compare_frozen.py "${pair%:*}" "$target/validation/$name.csv"
    done
    "$venv/bin/python" tests/validation/fit_asperities.py
fi
