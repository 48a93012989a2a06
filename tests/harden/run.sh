#!/usr/bin/env bash
# Faults a host may bring on the library: a C program against the release build.
#
# usage: tests/harden/run.sh
set -euo pipefail
cd "$(dirname "$0")/../.."

cc=${CC:-cc}
command -v "$cc" >/dev/null || { echo "tests/harden/run.sh: $cc is missing: run tests/setup.sh core" >&2; exit 1; }
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
cargo build --release --locked --quiet
"$cc" -std=c11 -O1 -Wall -Wextra -Wpedantic -Werror -Iinclude tests/harden/faults.c -o "$target/faults" \
    -L"$target/release" -Wl,-rpath,"$target/release" -lasperity -lm -lpthread
"$target/faults"
