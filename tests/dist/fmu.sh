#!/usr/bin/env bash
# Makes a mock-up unit for Linux and Windows, and compares the bits of its answers natively and in Wine, where the program is
# in another folder than the unit and its library.
#
# usage: tests/dist/fmu.sh WORK PYTHON LIBRARY   PYTHON has asperity; LIBRARY is asperity.dll, or the wheel for Windows
# Needs gcc, gcc-mingw-w64-x86-64 and wine64: tests/setup.sh dist.
set -euo pipefail
cd "$(dirname "$0")/../.."
. tests/dist/shared.sh
work=$1 python=$2 library=$3
rm -rf "$work"
mkdir -p "$work/unit"
for tool in cc x86_64-w64-mingw32-gcc "$wine"; do
    command -v "$tool" >/dev/null || fail "$tool is missing: run tests/setup.sh dist"
done

"$python" -m asperity fmu hosts/kratos/surface.toml -o "$work/pad.fmu" --platform linux64,win64 --library "win64=$library" \
    2>"$work/log" || { cat "$work/log" >&2; fail "no unit was made"; }
"$python" -m zipfile -e "$work/pad.fmu" "$work/unit"
guid=$(sed -n 's/.* guid="\([^"]*\)".*/\1/p' "$work/unit/modelDescription.xml")
reference=$(sed -n 's/.*name="height_std" valueReference="\([0-9]*\)".*/\1/p' "$work/unit/modelDescription.xml")

cc -std=c11 -Wall -Wextra -Werror tests/dist/fmu_answers.c -o "$work/answers" -ldl
x86_64-w64-mingw32-gcc -std=c11 -Wall -Wextra -Werror tests/dist/fmu_answers.c -o "$work/answers.exe"
unit=$work/unit/binaries
"$work/answers" "$unit/linux64/pad.so" "$guid" "$reference" >"$work/linux64.txt" || fail "the unit fails in Linux"
windows_path="Z:$(realpath "$unit/win64/pad.dll" | tr / '\\')"
(cd / && "$wine" "$work/answers.exe" "$windows_path" "$guid" "$reference") |
    tr -d '\r' >"$work/win64.txt" || fail "the unit fails in Windows"
[ "$(grep -c '^force' "$work/linux64.txt")" -gt 200 ] || fail "answers are missing"
cmp "$work/linux64.txt" "$work/win64.txt" || fail "Windows answers otherwise than Linux"

# Without its library the unit says so, and is not made.
rm "$unit/win64/asperity.dll"
if (cd / && "$wine" "$work/answers.exe" "$windows_path" "$guid" \
    "$reference") >"$work/alone.txt" 2>/dev/null; then fail "a unit without its library is made"; fi
grep -q 'log of pad: 3 logStatusError asperity.dll beside the unit.s DLL is missing' "$work/alone.txt" || fail "a missing library is not named"
echo "$(grep -c . "$work/linux64.txt") answers of a unit of FMI 2.0, the same bits in Linux and Windows"
