#!/usr/bin/env bash
# Installs MuJoCo and this library's Python package into an environment, builds the plugin for C too, runs the slider
# and the box on an incline; the last line says PASS or FAIL.
#
# usage: hosts/mujoco/run.sh [again]       again: with what the run before installed
set -euo pipefail
cd "$(dirname "$0")/../.."
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
build=$target/hosts/mujoco
environment=$target/mujoco-venv
version=4.0.0

fail() {
    echo "mujoco  FAIL  $*"
    exit 1
}
cmake/check_rust.sh || fail "the library does not build"

if [ "${1:-}" != again ]; then
    python3 -m venv "$environment" || fail "no virtual environment: apt-get install python3-venv"
    "$environment/bin/pip" install --quiet --no-compile --disable-pip-version-check "mujoco==$version" ./python ||
        fail "MuJoCo $version or the asperity package does not install"
fi
mkdir -p "$build"
mujoco=$(echo "$environment"/lib/python3*/site-packages/mujoco)
hosts/mujoco/build.sh "$mujoco" "$build/libasperity_mujoco.so" || fail "the plugin does not build"

# MuJoCo writes its messages to a file where it runs; the plugin that Python makes is kept with them.
export XDG_CACHE_HOME=$build
hosts=$PWD/hosts
cd "$build"
for program in incline slider; do
    status=0
    "$environment/bin/python" "$hosts/mujoco/$program.py" "$build/libasperity_mujoco.so" || status=$?
    [ "$status" -le 1 ] || fail "$program.py ended with status $status"
    [ "$status" -eq 0 ] || exit 1
done
