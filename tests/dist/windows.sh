#!/usr/bin/env bash
# Links programs with the DLL for Windows in the ways that users do, and runs them in Wine.
#
# usage: tests/dist/windows.sh WORK PREFIX      needs gcc-mingw-w64-x86-64, cmake, wine64
set -euo pipefail
cd "$(dirname "$0")/../.."
. tests/dist/shared.sh
work=$1 prefix=$2
rm -rf "$work"
mkdir -p "$work"

for project in find-package-shared find-package-static; do
    quietly cmake -S "tests/consumers/$project" -B "$work/$project" -DCMAKE_SYSTEM_NAME=Windows \
        -DCMAKE_C_COMPILER=x86_64-w64-mingw32-gcc -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_FIND_ROOT_PATH="$prefix" \
        -DASPERITY_WANTED=0
    quietly cmake --build "$work/$project"
    cp "$prefix/bin/asperity.dll" "$work/$project"
    quietly "$wine" "$work/$project/consumer.exe"
done
# The import library for Microsoft's linker, alone in a folder so that no other can be taken.
mkdir "$work/msvc"
cp "$prefix/lib/asperity.dll.lib" "$prefix/bin/asperity.dll" "$work/msvc"
quietly x86_64-w64-mingw32-gcc -std=c11 -I"$prefix/include" tests/consumers/greenwood_williamson.c -o "$work/msvc/consumer.exe" \
    "$work/msvc/asperity.dll.lib"
quietly "$wine" "$work/msvc/consumer.exe"
# Which of the two the CMake package takes where the compiler is Microsoft's: asked without one.
mkdir "$work/choice"
cat >"$work/choice/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.18)
project(choice LANGUAGES NONE)
set(MSVC 1)
find_package(asperity CONFIG REQUIRED)
get_target_property(library asperity::asperity IMPORTED_IMPLIB)
if(NOT library MATCHES "/lib/asperity\\.dll\\.lib$" OR NOT EXISTS "${library}")
  message(FATAL_ERROR "links ${library}")
endif()
END
quietly cmake -S "$work/choice" -B "$work/choice/build" -DCMAKE_PREFIX_PATH="$prefix"
