#!/usr/bin/env bash
# All of asperity.hpp is tested by wrapper.cpp: every function of asperity.h is reached, and every function of asperity.hpp
# is called. That its promises are kept is for cargo test (tests/c_api/programs.rs).
#
# usage: tests/cpp/called.sh      needs cargo, g++ with gcov, nm, python3; builds in $CARGO_TARGET_DIR or target
set -euo pipefail
cd "$(dirname "$0")/../.."

for tool in cargo g++ gcov nm python3; do
    command -v "$tool" >/dev/null || { echo "tests/cpp/called.sh: $tool is missing; run tests/setup.sh core" >&2; exit 1; }
done
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
build=$target/tests-cpp
mkdir -p "$build"
cargo build --release --locked --quiet
link=(-L"$target/release" -Wl,-rpath,"$target/release" -lasperity -pthread)

grep -oE '\basperity_[a-z_]+\(' include/asperity.h | tr -d '(' | sort -u >"$build/declared"
g++ -std=c++17 -O2 -Iinclude -c tests/cpp/wrapper.cpp -o "$build/wrapper.o"
nm -u "$build/wrapper.o" | grep -oE 'asperity_[a-z_]+$' | sort -u >"$build/reached"
diff "$build/declared" "$build/reached" ||
    { echo "tests/cpp/called.sh: asperity.hpp does not reach these functions of asperity.h" >&2; exit 1; }
echo "all $(wc -l <"$build/declared") functions of asperity.h are reached from C++"

rm -f "$build"/*.gcda "$build"/*.gcno
g++ -std=c++17 -O0 --coverage -fkeep-inline-functions -Iinclude -c tests/cpp/wrapper.cpp -o "$build/covered.o"
g++ --coverage "$build/covered.o" -o "$build/covered" "${link[@]}"
"$build/covered"
gcov --json-format --stdout "$build/covered.gcda" | python3 tests/cpp/called.py include/asperity.hpp
