#!/usr/bin/env bash
# All of asperity.hpp is tested by wrapper.cpp: every function of asperity.h is reached, and every function of asperity.hpp
# is called. That its promises are kept is for cargo test (tests/c_api/programs.rs).
#
# A status of a batch call that nobody looks at does not compile where warnings are errors.
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

# [[nodiscard]]: the same line compiles once the status is checked, and not before.
for call in 'friction_at_load(loads, out)' 'friction_force_at_load(loads, out)' 'tangential_stiffness_at_load(loads, out)'; do
    for form in "asperity::check(model.$call)" "model.$call"; do
        printf '#include <asperity.hpp>\nvoid ask(const asperity::Model &model, std::vector<double> &loads, std::vector<double> &out)\n{ %s; }\n' \
            "$form" >"$build/status.cpp"
        refused=0
        g++ -std=c++17 -Wall -Wextra -Werror -Iinclude -c "$build/status.cpp" -o "$build/status.o" 2>"$build/status.txt" || refused=1
        case $form in model*) expected=1 ;; *) expected=0 ;; esac
        if [ $refused != $expected ] || { [ $refused = 1 ] && ! grep -q unused-result "$build/status.txt"; }; then
            echo "tests/cpp/called.sh: '$form' compiles or does not, against what asperity.hpp says:" >&2
            cat "$build/status.txt" >&2
            exit 1
        fi
    done
done
echo "a status of a batch call cannot be overlooked"

rm -f "$build"/*.gcda "$build"/*.gcno
g++ -std=c++17 -O0 --coverage -fkeep-inline-functions -Iinclude -c tests/cpp/wrapper.cpp -o "$build/covered.o"
g++ --coverage "$build/covered.o" -o "$build/covered" "${link[@]}"
"$build/covered"
gcov --json-format --stdout "$build/covered.gcda" | python3 tests/cpp/called.py include/asperity.hpp
