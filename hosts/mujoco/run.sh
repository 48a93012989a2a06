#!/usr/bin/env bash
# Builds and runs the MuJoCo host, with MuJoCo from PyPI in target/mujoco-venv; the last line is the verdict.
set -euo pipefail
cd "$(dirname "$0")/../.."
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
build=$target/hosts/mujoco
venv=$target/mujoco-venv
version=4.0.0

fail() {
    echo "mujoco  FAIL  $*"
    exit 1
}
cmake/check_rust.sh || fail "the library does not build"

mujoco=$(ls -d "$venv"/lib/python3*/site-packages/mujoco 2>/dev/null) || mujoco=""
if [ ! -e "$mujoco/libmujoco.so.$version" ]; then
    python3 -m venv "$venv" || fail "no Python environment: apt-get install python3-venv"
    # mujoco-core holds the C library and its headers; the package mujoco adds the Python side.
    "$venv/bin/pip" install -q --disable-pip-version-check --no-deps "mujoco-core==$version" ||
        fail "MuJoCo $version is not to be had from PyPI"
    mujoco=$(ls -d "$venv"/lib/python3*/site-packages/mujoco)
fi
cargo build --quiet --release --locked -j1 || fail "the library does not build"
mkdir -p "$build"
# The wheel has no unversioned library name: link the versioned file.
gcc -std=c11 -O2 -Wall -Wextra -Werror -Iinclude -isystem "$mujoco/include" hosts/mujoco/slider.c -o "$build/slider" \
    -L"$target/release" -lasperity "$mujoco/libmujoco.so.$version" -Wl,-rpath,"$target/release:$mujoco" -lm ||
    fail "slider.c does not build"
status=0
model=$PWD/hosts/mujoco/slider.xml
cd "$build"   # MuJoCo writes its warnings to a file where it runs
./slider "$model" || status=$?
[ "$status" -le 1 ] || fail "slider ended with status $status"
exit "$status"
