#!/usr/bin/env bash
# Faults a host may bring on the library, and soak: C programs against the release build.
#
# usage: tests/harden/run.sh [quick|long]      quick by default: seconds; long: 10^5 cycles, 10^9 calls
set -euo pipefail
cd "$(dirname "$0")/../.."

case "${1:-quick}" in
quick) cycles=200 reloads=20 scalar=20000000 batch=8000000 ;;
long) cycles=100000 reloads=1000 scalar=1000000000 batch=100000000 ;;
*) echo "usage: tests/harden/run.sh [quick|long]" >&2; exit 2 ;;
esac

cc=${CC:-cc}
command -v "$cc" >/dev/null || { echo "tests/harden/run.sh: $cc is missing: run tests/setup.sh core" >&2; exit 1; }
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
build=$target/tests-harden
mkdir -p "$build"
cargo build --release --locked --quiet

# compile NAME [LINK...]
compile() {
    local name=$1
    shift
    "$cc" -std=c11 -O1 -Wall -Wextra -Wpedantic -Werror -Iinclude "tests/harden/$name.c" -o "$build/$name" "$@"
}

library=(-L"$target/release" -Wl,-rpath,"$target/release" -lasperity -lm -lpthread)
compile faults "${library[@]}"
compile out_of_memory "${library[@]}" -ldl
compile reload -ldl -lm -lpthread
compile soak "${library[@]}"
"$cc" -std=c11 -O1 -Wall -Wextra -Werror -shared -fPIC tests/harden/failing_malloc.c -o "$build/failing_malloc.so"

"$build/faults" "$cycles"
LD_PRELOAD=$build/failing_malloc.so "$build/out_of_memory"
"$build/reload" "$target/release/libasperity.so" "$reloads"
"$build/soak" "$scalar" "$batch"
