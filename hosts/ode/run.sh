#!/usr/bin/env bash
# Builds and runs the ODE host: an arm on a belt (is a lagged force stable?), then a sled; the last line is the verdict.
# The figure of the arm is left in target/hosts/ode/lag.svg.
set -euo pipefail
cd "$(dirname "$0")/../.."
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
build=$target/hosts/ode

fail() {
    echo "ode  FAIL  $*"
    exit 1
}
cmake/check_rust.sh || fail "the library does not build"

# What a program printed last is its verdict, unless it was killed.
run() {
    local status=0
    "$@" || status=$?
    [ "$status" -le 1 ] || fail "$(basename "$1") ended with status $status"
    [ "$status" -eq 0 ] || exit 1
}

pkg-config --exists ode || fail "ODE is missing: apt-get install libode-dev pkg-config"
cargo build --quiet --release --locked -j1 || fail "the library does not build"
mkdir -p "$build"
for program in arm sled; do
    # shellcheck disable=SC2046
    gcc -std=c11 -O2 -Wall -Wextra -Werror -Iinclude $(pkg-config --cflags ode | sed 's/-I/-isystem /g') \
        "hosts/ode/$program.c" hosts/ode/law_step.c -o "$build/$program" \
        -L"$target/release" -lasperity -Wl,-rpath,"$target/release" $(pkg-config --libs ode) -lm ||
        fail "$program.c does not build"
done
run "$build/arm" "$build/lag.svg"
run "$build/sled"
