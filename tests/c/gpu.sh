#!/usr/bin/env bash
# asperity_eval.h as device code, bit for bit as the library (eval.c): compiled where nvcc or hipcc is on PATH, run where
# there is a GPU too. Processors are for cargo test (tests/c_api/programs.rs).
#
# usage: tests/c/gpu.sh      needs cargo; builds in $CARGO_TARGET_DIR or target
set -euo pipefail
cd "$(dirname "$0")/../.."

fail() {
    echo "tests/c/gpu.sh: $1" >&2
    exit 1
}

command -v cargo >/dev/null || fail "cargo is missing"
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
build=$target/tests-c-gpu
mkdir -p "$build"
cargo build --release --locked --quiet
link=(-L"$target/release" -lasperity -lm)
export LD_LIBRARY_PATH=$target/release${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
source=tests/c/eval.c

if command -v nvcc >/dev/null; then
    echo "CUDA: found $(command -v nvcc)"
    nvcc -std=c++17 -O3 -x cu -Iinclude "$source" -o "$build/eval" "${link[@]}"
    "$build/eval" || fail "failed as CUDA"
    nvcc -std=c++17 -O3 -x cu -Iinclude -ptx "$source" -o "$build/eval.ptx"
    grep -q 'mul.rn.f64' "$build/eval.ptx" || fail "nvcc: no kernel"
    if grep 'fma' "$build/eval.ptx"; then fail "nvcc contracts what asperity_eval.h multiplies and adds"; fi
    nvcc -std=c++17 -O3 --use_fast_math -x cu -Iinclude -ptx "$source" -o "$build/fast.ptx"
    cmp "$build/eval.ptx" "$build/fast.ptx" || fail "--use_fast_math makes another kernel of doubles"
    echo "nvcc: the kernel has no fused multiply-add, and --use_fast_math makes the same"
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
