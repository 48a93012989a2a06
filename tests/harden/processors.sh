#!/usr/bin/env bash
# The same bits on other processors, emulated: with AVX2 but not AVX-512, with neither and without FMA.
#
# usage: tests/harden/processors.sh      needs qemu-x86_64 (Debian: qemu-user)
set -euo pipefail
cd "$(dirname "$0")/../.."

for tool in cargo cc qemu-x86_64; do
    command -v "$tool" >/dev/null ||
        { echo "tests/harden/processors.sh: $tool is missing: run tests/setup.sh harden" >&2; exit 1; }
done
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
build=$target/tests-harden
mkdir -p "$build"
cargo build --release --locked --quiet
cc -std=c11 -O1 -Wall -Wextra -Werror -Iinclude tests/harden/processors.c -o "$build/processors" \
    -L"$target/release" -Wl,-rpath,"$target/release" -lasperity -lm
"$build/processors" write "$build/answers.bin"
for cpu in Haswell Nehalem; do
    echo "$cpu:"
    qemu-x86_64 -cpu "$cpu" "$build/processors" compare "$build/answers.bin"
done

# The flags of the vectors that this processor may not take.
tests=$(cargo test --release --locked --test c_api --no-run 2>&1 | sed -n 's/.*(\(.*\/c_api-[0-9a-f]*\)).*/\1/p')
qemu-x86_64 -cpu Haswell "$tests" batch::no_load 2>/dev/null | tail -2
