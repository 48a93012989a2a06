#!/usr/bin/env bash
# Builds libasperity_mujoco.so for MuJoCo in C and C++ and for its program `simulate`, with the library inside: copy it
# into the folder mujoco_plugin beside `simulate`, or load it with mj_loadPluginLibrary. Python needs none of this: there
# `import asperity.mujoco` does the same.
#
# usage: hosts/mujoco/build.sh [PREFIX]
# PREFIX: where the library is installed (PREFIX/lib/pkgconfig/asperity.pc); no cargo is needed.
# Without it cargo builds the library.
# MUJOCO=DIR has include/mujoco and the library, in it or in lib/, as MuJoCo's archives do; that of python3 unless given.
# OUTPUT=FILE: libasperity_mujoco.so here with PREFIX, in target/release without.
set -euo pipefail
fail() {
    echo "hosts/mujoco/build.sh: $*" >&2
    exit 1
}
case "${1-}" in -*) sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2 ;; esac
root=$(realpath "$(dirname "$0")/../..")
target=$(realpath -m "${CARGO_TARGET_DIR:-$root/target}")
mujoco=${MUJOCO:-$(python3 -c 'import importlib.util as u; print(u.find_spec("mujoco").submodule_search_locations[0])' 2>/dev/null)} ||
    fail "python3 has no MuJoCo: set MUJOCO to its folder, or pip install mujoco"
mujoco=$(realpath "$mujoco")
# The wheel has no unversioned library name: the versioned file is linked.
engine=$(find "$mujoco" -maxdepth 2 -name 'libmujoco.so*' | sort | tail -n 1)
[ -n "$engine" ] && [ -e "$mujoco/include/mujoco/mujoco.h" ] || fail "$mujoco lacks libmujoco.so or include/mujoco/mujoco.h"

if [ $# -gt 0 ]; then
    prefix=$(realpath "$1")
    description=$(find "$prefix" -maxdepth 4 -name asperity.pc | head -n 1)
    [ -n "$description" ] || fail "no library in $prefix: make install PREFIX=$prefix"
    export PKG_CONFIG_PATH=${description%/*}
    flags=$(pkg-config --cflags asperity)
    library=$(pkg-config --variable=libdir asperity)/libasperity.a
    libraries=$(pkg-config --static --libs-only-l asperity | sed 's/-lasperity//')
    plugin=$(realpath -m "${OUTPUT:-libasperity_mujoco.so}")
else
    flags=-Iinclude library=$target/release/libasperity.a libraries="-lm -lpthread -ldl"
    plugin=$(realpath -m "${OUTPUT:-$target/release/libasperity_mujoco.so}")
fi
cd "$root"
[ $# -gt 0 ] || { cmake/check_rust.sh && cargo build --quiet --release --locked -j1; }
# shellcheck disable=SC2086
"${CC:-cc}" -std=c11 -O2 -Wall -Wextra -Werror -shared -fPIC -fexceptions -Wl,--no-undefined -Wl,--exclude-libs,ALL \
    $flags -isystem "$mujoco/include" hosts/mujoco/plugin.c -o "$plugin" "$library" "$engine" \
    -Wl,-rpath,"$(dirname "$engine")" $libraries
echo "built $plugin"
