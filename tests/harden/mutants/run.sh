#!/usr/bin/env bash
# Every mutant of the physics and the C interface against the tests: tests/harden/mutants/run.py with what it needs.
#
# usage: tests/harden/mutants/run.sh [options of run.py]
set -euo pipefail
cd "$(dirname "$0")/../../.."

for tool in cargo cc python3 qemu-x86_64 cargo-mutants; do
    command -v "$tool" >/dev/null ||
        { echo "tests/harden/mutants/run.sh: $tool is missing: run tests/setup.sh core harden" >&2; exit 1; }
done
folder=$(realpath -m "${CARGO_TARGET_DIR:-target}")/mutants-planted
mkdir -p "$folder"
python=$folder/venv/bin/python
[ -x "$python" ] || python3 -m venv "$folder/venv"
"$python" -m pip install --quiet --disable-pip-version-check -r tests/harden/mutants/requirements.txt
"$python" tests/harden/mutants/run.py "$folder" "$@"
