#!/usr/bin/env bash
# Builds and runs the Siconos host; the last line is the verdict.
set -euo pipefail
cd "$(dirname "$0")/../.."
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
build=$target/hosts/siconos

fail() {
    echo "siconos  FAIL  $*"
    exit 1
}
cmake/check_rust.sh || fail "the library does not build"

[ -e /usr/include/siconos/numerics/FrictionContactProblem.h ] ||
    fail "Siconos is missing: apt-get install libsiconos-numerics-dev"
cargo build --quiet --release --locked -j1 || fail "the library does not build"
mkdir -p "$build"
gcc -std=c11 -O2 -Wall -Wextra -Werror -Iinclude -isystem /usr/include/siconos \
    -isystem /usr/include/siconos/numerics hosts/siconos/brush.c -o "$build/brush" \
    -L"$target/release" -lasperity -Wl,-rpath,"$target/release" -lsiconos_numerics -lm || fail "brush.c does not build"
export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1
status=0
"$build/brush" || status=$?
[ "$status" -le 1 ] || fail "brush ended with status $status"
exit "$status"
