#!/usr/bin/env bash
# The same example in C, C++, Fortran and Python prints the same summary; and the same text has the same estimate in
# these languages, at the command line and in JavaScript.
#
# usage: tests/examples/run.sh      needs cargo, cc, g++, gfortran, python3 with venv; fetches NumPy from PyPI. JavaScript is compared
#                                   where js/build.sh has built it
set -euo pipefail
cd "$(dirname "$0")/../.."

for tool in cargo cc g++ gfortran python3; do
    command -v "$tool" >/dev/null ||
        { echo "tests/examples/run.sh: $tool is missing; run tests/setup.sh core" >&2; exit 1; }
done
CARGO_TARGET_DIR=$(realpath -m "${CARGO_TARGET_DIR:-target}")
export CARGO_TARGET_DIR
build=$CARGO_TARGET_DIR/tests-examples
mkdir -p "$build/modules"
cargo build --release --locked --quiet
link=(-L"$CARGO_TARGET_DIR/release" -Wl,-rpath,"$CARGO_TARGET_DIR/release" -lasperity -lm)

cc -std=c11 -Wall -Wextra -Wpedantic -Werror -Iinclude c_examples/friction_curve.c -o "$build/c" "${link[@]}"
g++ -std=c++17 -Wall -Wextra -Wpedantic -Wconversion -Werror -Iinclude c_examples/friction_curve.cpp -o "$build/cpp" \
    "${link[@]}"
gfortran -std=f2018 -Wall -Wextra -J "$build/modules" fortran/asperity.f90 fortran/examples/friction_curve.f90 \
    -o "$build/fortran" "${link[@]}"

# A host may trap floating-point exceptions; examples are written as users write programs, and know nothing of that.
cc -shared -fPIC -x c tests/c/traps_on.h -o "$build/traps_on.so" -lm

# The Python package as it is in the source tree, with the library just built.
python=$build/venv/bin/python
[ -x "$python" ] || python3 -m venv "$build/venv"
"$python" -c "import numpy" 2>/dev/null || "$python" -m pip --quiet --disable-pip-version-check install "numpy>=1.22"
export PYTHONPATH=python/src PYTHONDONTWRITEBYTECODE=1 ASPERITY_LIBRARY=$CARGO_TARGET_DIR/release/libasperity.so

# Of numbers only the value is compared: Fortran writes 0.0100 for 0.01.
summary() { grep -E '^ +[0-9l]' | awk '/load/ {print; next} {print $1 + 0, $2, $3, $4, $5}'; }
env LD_PRELOAD="$build/traps_on.so" "$build/c" | summary >"$build/c.txt"
[ "$(wc -l <"$build/c.txt")" = 6 ] || { echo "tests/examples/run.sh: friction_curve.c does not print five loads" >&2; exit 1; }
alike() {
    local language=$1
    shift
    "$@" | summary | diff "$build/c.txt" - ||
        { echo "tests/examples/run.sh: the summary of $language differs from that of C" >&2; exit 1; }
}
alike C++ env LD_PRELOAD="$build/traps_on.so" "$build/cpp"
alike Fortran env LD_PRELOAD="$build/traps_on.so" "$build/fortran"
alike Python "$python" python/examples/friction_curve.py
echo "friction_curve: four languages, one summary"

# One text, one estimate.
cc -std=c11 -Wall -Wextra -Wpedantic -Werror -Iinclude tests/examples/estimate.c -o "$build/estimate_c" "${link[@]}"
g++ -std=c++17 -Wall -Wextra -Wpedantic -Wconversion -Werror -Iinclude tests/examples/estimate.cpp -o "$build/estimate_cpp" "${link[@]}"
gfortran -std=f2018 -Wall -Wextra -J "$build/modules" fortran/asperity.f90 tests/examples/estimate.f90 -o "$build/estimate_fortran" \
    "${link[@]}"
surface=tests/examples/ground.toml
env LD_PRELOAD="$build/traps_on.so" "$build/estimate_c" <"$surface" >"$build/estimate.txt"
languages="C"
same() {
    local language=$1
    shift
    "$@" <"$surface" | diff "$build/estimate.txt" - ||
        { echo "tests/examples/run.sh: the estimate of $language differs from that of C" >&2; exit 1; }
    languages="$languages, $language"
}
same C++ env LD_PRELOAD="$build/traps_on.so" "$build/estimate_cpp"
same Fortran env LD_PRELOAD="$build/traps_on.so" "$build/estimate_fortran"
same Python "$python" tests/examples/estimate.py
[ ! -f js/dist/asperity.wasm ] || same JavaScript node tests/examples/estimate.mjs
"$python" -m asperity friction --surface "$surface" --load 0 1 100 | diff <(grep -v '^[0-9]' "$build/estimate.txt") - ||
    { echo "tests/examples/run.sh: the command line differs from C" >&2; exit 1; }
echo "one text, one estimate: $languages and the command line"
