#!/usr/bin/env bash
# asperity_eval.h: free of warnings and bit for bit as the library (eval.c) as C99 and C++17, by GCC and Clang, also
# vectorised for this processor; as device code where nvcc or hipcc is on PATH, run where there is a GPU too.
#
# usage: tests/c/eval.sh      needs cargo, gcc, g++, clang, clang++; builds in $CARGO_TARGET_DIR or target
set -euo pipefail
cd "$(dirname "$0")/../.."

fail() {
    echo "tests/c/eval.sh: $1" >&2
    exit 1
}

for tool in cargo gcc g++ clang clang++; do
    command -v "$tool" >/dev/null || fail "$tool is missing; run tests/setup.sh core"
done
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
build=$target/tests-c-eval
mkdir -p "$build"
cargo build --release --locked --quiet
link=(-L"$target/release" -lasperity -lm)
export LD_LIBRARY_PATH=$target/release${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
source=tests/c/eval.c

# run COMPILER OPTION...: builds the program with them, and runs it.
run() {
    echo "$*"
    rm -f "$build/eval"
    "$@" -Iinclude "$source" -o "$build/eval" "${link[@]}"
    "$build/eval" || fail "failed: $*"
}

# passes COMPILER OPTION...: free of warnings, too.
passes() {
    run "$@" -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Werror
}

# What the header says of contraction: -std=c99 and -ffp-contract=off prevent it in GCC, the header itself in Clang.
passes gcc -std=c99 -O2
passes gcc -std=c99 -O3 -march=native
passes gcc -std=c11 -O3 -march=native -ffp-contract=off
passes clang -std=c99 -O2
passes clang -std=c99 -O3 -march=native
link=(-x none "${link[@]}")
passes g++ -std=c++17 -O3 -march=native -ffp-contract=off -x c++
passes clang++ -std=c++17 -O3 -march=native -x c++
link=("${link[@]:2}")

# ---- GPUs: their compilers are not part of Debian's core, nor are GPUs of every machine ----
if command -v nvcc >/dev/null; then
    echo "CUDA: found $(command -v nvcc)"
    run nvcc -std=c++17 -O3 -x cu
    nvcc -std=c++17 -O3 -x cu -Iinclude -ptx "$source" -o "$build/eval.ptx"
    grep -q 'mul.rn.f64' "$build/eval.ptx" || fail "nvcc: no kernel"
    if grep 'fma' "$build/eval.ptx"; then fail "nvcc contracts what asperity_eval.h multiplies and adds"; fi
    echo "nvcc: the kernel has no fused multiply-add"
else
    echo "CUDA: no nvcc on PATH, so not compiled as CUDA"
fi

if command -v hipcc >/dev/null; then
    echo "HIP: found $(command -v hipcc)"
    export HIP_PLATFORM=amd
    hip=(hipcc -std=c++17 -O3 -x hip -Wall -Wextra -Werror -Wno-unused-command-line-argument -Iinclude "$source")
    "${hip[@]}" --offload-arch=gfx90a --cuda-device-only -S -emit-llvm -o "$build/eval.ll"
    grep -q 'fmul double' "$build/eval.ll" || fail "hipcc: no kernel"
    if grep -E '(fmul|fadd|fsub) .*contract|llvm\.fma' "$build/eval.ll"; then
        fail "hipcc may contract what asperity_eval.h multiplies and adds"
    fi
    echo "hipcc: nothing in the kernel may be contracted"
    if [ -e /dev/kfd ]; then
        "${hip[@]}" -x none "${link[@]}" -o "$build/eval"
        "$build/eval" || fail "failed as HIP"
    else
        "${hip[@]}" --offload-arch=gfx90a -c -o "$build/eval.o"
        echo "HIP: no AMD GPU, so compiled and not run"
    fi
else
    echo "HIP: no hipcc on PATH, so not compiled as HIP"
fi
