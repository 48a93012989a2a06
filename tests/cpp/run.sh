#!/usr/bin/env bash
# asperity.hpp: free of warnings with g++ and clang++ as C++17 and C++20, keeps its promises with each (wrapper.cpp),
# and all of it is tested: every function of asperity.h is reached and every function of asperity.hpp is called.
#
# usage: tests/cpp/run.sh      needs cargo, g++ with gcov, clang++, nm, python3; builds in $CARGO_TARGET_DIR or target
set -euo pipefail
cd "$(dirname "$0")/../.."

for tool in cargo g++ gcov clang++ nm python3; do
    command -v "$tool" >/dev/null || { echo "tests/cpp/run.sh: $tool is missing; run tests/setup.sh core" >&2; exit 1; }
done
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
build=$target/tests-cpp
mkdir -p "$build"
cargo build --release --locked --quiet
link=(-L"$target/release" -Wl,-rpath,"$target/release" -lasperity -pthread)
warnings=(-Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Werror)

for compiler in g++ clang++; do
    for standard in c++17 c++20; do
        "$compiler" -std=$standard -O2 "${warnings[@]}" -Iinclude -c tests/cpp/wrapper.cpp -o "$build/wrapper.o"
        "$compiler" "$build/wrapper.o" -o "$build/wrapper" "${link[@]}"
        "$build/wrapper"
        echo "$compiler $standard: passed"
    done
done

grep -oE '\basperity_[a-z_]+\(' include/asperity.h | tr -d '(' | sort -u >"$build/declared"
nm -u "$build/wrapper.o" | grep -oE 'asperity_[a-z_]+$' | sort -u >"$build/reached"
diff "$build/declared" "$build/reached" ||
    { echo "tests/cpp/run.sh: asperity.hpp does not reach these functions of asperity.h" >&2; exit 1; }
echo "all $(wc -l <"$build/declared") functions of asperity.h are reached from C++"

rm -f "$build"/*.gcda "$build"/*.gcno
g++ -std=c++17 -O0 --coverage -fkeep-inline-functions -Iinclude -c tests/cpp/wrapper.cpp -o "$build/covered.o"
g++ --coverage "$build/covered.o" -o "$build/covered" "${link[@]}"
"$build/covered"
gcov --json-format --stdout "$build/covered.gcda" | python3 tests/cpp/called.py include/asperity.hpp
