#!/usr/bin/env bash
# Builds libasperity_mujoco.so for MuJoCo in C and C++ and for its program `simulate`, with the library inside: copy it
# into the folder mujoco_plugin beside `simulate`, or load it with mj_loadPluginLibrary. Python needs none of this: there
# `import asperity.mujoco` does the same.
#
# usage: hosts/mujoco/build.sh MUJOCO [FILE]
# MUJOCO has include/mujoco and the library, in it or in lib/, as MuJoCo's archives and the package `mujoco` of PyPI do.
# FILE: target/release/libasperity_mujoco.so.
set -euo pipefail
[ $# -ge 1 ] || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
mujoco=$(realpath "$1") || exit 2
file=$(realpath -m "${2:-${CARGO_TARGET_DIR:-target}/release/libasperity_mujoco.so}")
cd "$(dirname "$0")/../.."
release=$(realpath -m "${CARGO_TARGET_DIR:-target}")/release
# The wheel has no unversioned library name: the versioned file is linked.
library=$(find "$mujoco" -maxdepth 2 -name 'libmujoco.so*' | sort | tail -n 1)
[ -n "$library" ] && [ -e "$mujoco/include/mujoco/mujoco.h" ] ||
    { echo "hosts/mujoco/build.sh: $mujoco lacks libmujoco.so or include/mujoco/mujoco.h" >&2; exit 1; }

cmake/check_rust.sh && cargo build --quiet --release --locked -j1
"${CC:-cc}" -std=c11 -O2 -Wall -Wextra -Werror -shared -fPIC -fexceptions -Wl,--no-undefined -Wl,--exclude-libs,ALL \
    -Iinclude -isystem "$mujoco/include" hosts/mujoco/plugin.c -o "$file" "$release/libasperity.a" "$library" \
    -Wl,-rpath,"$(dirname "$library")" -lm -lpthread -ldl
echo "built $file"
