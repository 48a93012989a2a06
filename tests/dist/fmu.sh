#!/usr/bin/env bash
# Makes mock-up units of FMI 2.0 and 3.0 for Linux and Windows, and compares the bits of their answers natively and in Wine, where
# the program is in another folder than the unit and its library.
#
# usage: tests/dist/fmu.sh WORK PYTHON LIBRARY   PYTHON has asperity; LIBRARY is asperity.dll, or the wheel for Windows
# Needs gcc, gcc-mingw-w64-x86-64 and wine64: tests/setup.sh dist.
set -euo pipefail
cd "$(dirname "$0")/../.."
. tests/dist/shared.sh
work=$1 python=$2 library=$3
rm -rf "$work"
mkdir -p "$work"
for tool in cc x86_64-w64-mingw32-gcc "$wine"; do
    command -v "$tool" >/dev/null || fail "$tool is missing: run tests/setup.sh dist"
done

cc -std=c11 -Wall -Wextra -Werror tests/dist/fmu_answers.c -o "$work/answers" -ldl
x86_64-w64-mingw32-gcc -std=c11 -Wall -Wextra -Werror tests/dist/fmu_answers.c -o "$work/answers.exe"

# in_wine VERSION FOLDER: the answers of the unit in the folder, to a program in another.
in_wine() {
    local path
    path="Z:$(realpath "$2/pad.dll" | tr / '\\')"
    (cd / && "$wine" "$work/answers.exe" "$1" "$path" "$guid" "$reference")
}

for version in 2 3; do
    unit=$work/unit$version linux=linux64 windows=win64
    [ $version = 2 ] || linux=x86_64-linux windows=x86_64-windows
    "$python" -m asperity fmu hosts/surface.toml -o "$work/pad.fmu" --fmi $version.0 --platform linux64,win64 \
        --library "win64=$library" 2>"$work/log" || { cat "$work/log" >&2; fail "no unit was made"; }
    "$python" -m zipfile -e "$work/pad.fmu" "$unit"
    guid=$(sed -n 's/.* \(guid\|instantiationToken\)="\([^"]*\)".*/\2/p' "$unit/modelDescription.xml")
    reference=$(sed -n 's/.*name="height_std" valueReference="\([0-9]*\)".*/\1/p' "$unit/modelDescription.xml")
    "$work/answers" $version "$unit/binaries/$linux/pad.so" "$guid" "$reference" >"$work/linux$version.txt" ||
        fail "the unit of FMI $version.0 fails in Linux"
    in_wine $version "$unit/binaries/$windows" | tr -d '\r' >"$work/windows$version.txt" ||
        fail "the unit of FMI $version.0 fails in Windows"
    [ "$(grep -c '^force' "$work/linux$version.txt")" -gt 200 ] || fail "answers are missing"
    cmp "$work/linux$version.txt" "$work/windows$version.txt" || fail "Windows answers otherwise than Linux"

    # Without its library the unit says so, and is not made.
    rm "$unit/binaries/$windows/asperity.dll"
    if in_wine $version "$unit/binaries/$windows" >"$work/alone.txt" 2>/dev/null; then
        fail "a unit without its library is made"
    fi
    grep -q 'log: 3 logStatusError asperity.dll beside the unit.s DLL is missing' "$work/alone.txt" ||
        fail "a missing library is not named"
done
sed -i s/fmi3/fmi2/ "$work/linux3.txt" # names of functions in messages
cmp "$work/linux2.txt" "$work/linux3.txt" || fail "FMI 3.0 answers otherwise than FMI 2.0"
echo "$(grep -c . "$work/linux2.txt") answers of units of FMI 2.0 and 3.0, the same bits in Linux and Windows"
