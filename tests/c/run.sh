#!/usr/bin/env bash
# The C interface as a C program sees it: header and shared library of the release build.
#
# usage: tests/c/run.sh      (CC, CXX and CARGO_TARGET_DIR are honoured)
set -euo pipefail
cd "$(dirname "$0")/../.."

cc=${CC:-cc}
cxx=${CXX:-c++}
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
release=$target/release
build=$target/tests-c
warnings="-Wall -Wextra -Wpedantic -Werror"

for tool in cargo make "$cc" "$cxx" pkg-config python3 valgrind; do
    command -v "$tool" >/dev/null ||
        { echo "tests/c/run.sh: $tool is missing; tests/setup.sh core installs what is needed" >&2; exit 1; }
done
cargo build --release --locked --quiet
rm -rf "$build"
mkdir -p "$build"

# compile NAME SOURCE [FLAGS...]: a C11 program against header and shared library.
compile() {
    local name=$1 source=$2
    shift 2
    # shellcheck disable=SC2086
    "$cc" -std=c11 -O1 $warnings "$@" -Iinclude "$source" -o "$build/$name" \
        -L"$release" -Wl,-rpath,"$release" -lasperity -lm -lpthread
}

# expect STATUS TEXT COMMAND...: the command exits with STATUS, and says TEXT on standard error.
expect() {
    local status=$1 text=$2 got=0
    shift 2
    "$@" >"$build/stdout" 2>"$build/stderr" || got=$?
    if [ "$got" != "$status" ] || ! grep -qF -- "$text" "$build/stderr"; then
        echo "tests/c/run.sh: '$*' exits $got, not $status, or does not say '$text':" >&2
        cat "$build/stderr" >&2
        exit 1
    fi
}

echo "-- the header alone, in every dialect"
for standard in c99 c11 c17; do
    # shellcheck disable=SC2086
    echo '#include <asperity.h>' | "$cc" -std=$standard $warnings -Iinclude -fsyntax-only -x c -
done
for standard in c++98 c++11 c++17 c++20; do
    # C++98 has no long long of its own, which the system's stdint.h uses.
    # shellcheck disable=SC2086
    echo '#include <asperity.h>' | "$cxx" -std=$standard $warnings -Wno-long-long -Iinclude -fsyntax-only -x c++ -
done

echo "-- contract, threads"
compile contract tests/c/contract.c
compile threads tests/c/threads.c
"$build/contract" >"$build/contract.out" || { cat "$build/contract.out"; exit 1; }
tail -1 "$build/contract.out"
"$build/threads"

echo "-- floating-point traps"
compile traps tests/c/traps.c
timeout 300 "$build/traps"

echo "-- valgrind: no invalid access, no leak"
compile old_caller tests/c/old_caller.c
compile tables tests/c/tables.c
for program in threads old_caller tables; do
    valgrind --quiet --error-exitcode=1 --leak-check=full --show-leak-kinds=all "$build/$program"
done

echo "-- the example, and its command line"
compile friction_curve c_examples/friction_curve.c
example=$build/friction_curve
"$example" "$build/curve.svg" >"$build/curve.txt"
python3 tests/c/check_curve.py "$build/curve.txt" "$build/curve.svg"
python3 tests/c/check_curve.py "$build/curve.txt" docs/friction_curve.svg
"$example" - 5 1e-6 1e-2 >"$build/five.txt"
[ "$(grep -vc '^#' "$build/five.txt")" = 5 ] || { echo "tests/c/run.sh: not five loads" >&2; exit 1; }
expect 2 "LOADS = 1: must be a whole number" "$example" - 1
expect 2 "LOADS = 2.5: must be a whole number" "$example" - 2.5
expect 2 "LOADS = 'many': must be a finite number" "$example" - many
expect 2 "LOWEST = 0 N: must be > 0" "$example" - 5 0
expect 2 "LOWEST = 'nan': must be a finite number" "$example" - 5 nan
expect 2 "HIGHEST = 1 N: must be above LOWEST = 1 N" "$example" - 5 1 1
expect 2 "usage: friction_curve" "$example" - 5 1 2 3
expect 1 "asperity_state_at_load: load = 1e200: " "$example" - 2 1 1e200
expect 1 "cannot write $build/none/curve.svg: No such file" "$example" "$build/none/curve.svg"
expect 1 "cannot write the table" bash -c "'$example' >/dev/full"

echo "-- the program in README.md, installed as docs/c.md says"
sed -n '/^```c$/,/^```$/{/^```/d;p}' README.md >"$build/readme.c"
sed -n 's/^It prints `\(.*\)`\. .*/\1/p' README.md >"$build/readme.expected"
[ -s "$build/readme.c" ] && [ -s "$build/readme.expected" ] ||
    { echo "tests/c/run.sh: README.md has no C program, or does not say what it prints" >&2; exit 1; }
prefix=$build/prefix
make --silent install PREFIX="$prefix" >"$build/install.log" 2>&1 || { cat "$build/install.log" >&2; exit 1; }
# shellcheck disable=SC2046,SC2086
"$cc" -std=c11 $warnings "$build/readme.c" $(PKG_CONFIG_PATH=$prefix/lib/pkgconfig pkg-config --cflags --libs asperity) \
    -Wl,-rpath,"$prefix/lib" -o "$build/readme-shared"
# shellcheck disable=SC2086
"$cc" -std=c11 $warnings "$build/readme.c" -I"$prefix/include" "$prefix/lib/libasperity.a" -lm -lpthread -ldl \
    -o "$build/readme-static"
for linking in shared static; do
    "$build/readme-$linking" >"$build/readme.out"
    diff "$build/readme.expected" "$build/readme.out" ||
        { echo "tests/c/run.sh: README.md tells another output than its program gives ($linking)" >&2; exit 1; }
done
