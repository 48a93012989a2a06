#!/usr/bin/env bash
# Builds and runs what users build against an installation of asperity, in C, C++ and Fortran, by pkg-config and CMake,
# shared and static. Runs in any system with the compilers; no Rust.
#
# usage: tests/dist/installed.sh WORK [PREFIX]    WORK is for what is built; PREFIX where the installation is, if not the system's
set -euo pipefail
cd "$(dirname "$0")/../.."
. tests/dist/shared.sh
work=$1 prefix=${2:-}
rm -rf "$work"
mkdir -p "$work"
if [ -n "$prefix" ]; then
    export PKG_CONFIG_PATH=$prefix/lib/pkgconfig CMAKE_PREFIX_PATH=$prefix
fi

for project in pkg-config pkg-config-static; do
    mkdir -p "$work/$project"
    quietly make -C "tests/consumers/$project" BUILD="$work/$project"
    quietly "$work/$project/consumer"
done
for project in find-package-shared find-package-static cpp; do
    wanted=
    [ $project != find-package-shared ] || wanted=-DASPERITY_WANTED=$(pkg-config --modversion asperity)
    quietly cmake -S "tests/consumers/$project" -B "$work/$project" $wanted
    quietly cmake --build "$work/$project"
    quietly "$work/$project/consumer"
done

# The module and a program that uses it.
source=$(pkg-config --variable=fortran_source asperity)
libdir=$(pkg-config --variable=libdir asperity)
quietly gfortran -J "$work" "$source" fortran/examples/minimal.f90 -o "$work/minimal" -L"$libdir" -lasperity -Wl,-rpath,"$libdir"
quietly "$work/minimal"
echo "C, C++ and Fortran, by pkg-config and CMake, shared and static: 6 programs run"
