#!/usr/bin/env bash
# The same bits on other processors, emulated: x86-64 with AVX2 but not AVX-512, with neither and without FMA; 64-bit ARM.
# One list of answers, whose hash is printed.
#
# usage: tests/harden/processors.sh      on x86-64; needs qemu-user, Debian's cross compiler for ARM and Rust's library for it
set -euo pipefail
cd "$(dirname "$0")/../.."

arm=aarch64-unknown-linux-gnu
export CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER=aarch64-linux-gnu-gcc
fails() {
    echo "tests/harden/processors.sh: $*" >&2
    exit 1
}
for tool in cargo cc qemu-x86_64 qemu-aarch64 aarch64-linux-gnu-gcc; do
    command -v "$tool" >/dev/null || fails "$tool is missing: run tests/setup.sh harden"
done
[ -d "$(rustc --print target-libdir --target $arm)" ] ||
    fails "Rust has no library for $arm: run tests/setup.sh harden (rustup target add $arm)"
[ "$(uname -m)" = x86_64 ] || fails "this processor is not x86-64, whose vectors are to be compared"

target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
build=$target/tests-harden
mkdir -p "$build"
cargo build --release --locked --quiet
cargo build --release --locked --quiet --target $arm
# The program's own arithmetic, too, without fused operations.
flags=(-std=c11 -O1 -ffp-contract=off -Wall -Wextra -Werror -Iinclude tests/harden/processors.c)
cc "${flags[@]}" -o "$build/processors" -L"$target/release" -Wl,-rpath,"$target/release" -lasperity -lm
aarch64-linux-gnu-gcc "${flags[@]}" -o "$build/processors-arm" -L"$target/$arm/release" \
    -Wl,-rpath,"$target/$arm/release" -lasperity -lm

# answers NAME COMMAND...: the list that the command writes, as $build/NAME.txt
answers() {
    local name=$1
    shift
    "$@" >"$build/$name.txt" || fails "$name: $*"
}
answers here "$build/processors"
answers Haswell qemu-x86_64 -cpu Haswell "$build/processors"
answers Nehalem qemu-x86_64 -cpu Nehalem "$build/processors"
answers ARM qemu-aarch64 -L /usr/aarch64-linux-gnu "$build/processors-arm"
for name in Haswell Nehalem ARM; do
    diff "$build/here.txt" "$build/$name.txt" || fails "$name has other bits than this processor"
    echo "$name: the same bits as on this processor"
done
echo "all answers: $(sha256sum <"$build/here.txt" | cut -c 1-16)"

# The flags of the vectors that this processor may not take.
tests=$(cargo test --release --locked --test c_api --no-run 2>&1 | sed -n 's/.*(\(.*\/c_api-[0-9a-f]*\)).*/\1/p')
qemu-x86_64 -cpu Haswell "$tests" batch::no_load 2>/dev/null | tail -2
