#!/usr/bin/env bash
# Builds and runs the Simbody slider against this library; the last line says PASS or FAIL.
set -euo pipefail
cd "$(dirname "$0")/../.."
target=${CARGO_TARGET_DIR:-target}
build=$target/hosts/simbody

fail() {
    echo "simbody  FAIL  $*"
    exit 1
}
cmake/check_rust.sh || fail "the library does not build"

pkg-config --exists simbody || fail "Simbody is missing: apt-get install libsimbody-dev"
cargo build --quiet --release --locked -j1 || fail "the library does not build"
library=$(realpath "$target/release")
mkdir -p "$build"
# shellcheck disable=SC2046
g++ -std=c++17 -O2 -Wall -Wextra -Iinclude -isystem /usr/include/simbody hosts/simbody/slider.cpp -o "$build/slider" \
    -L"$library" -lasperity -Wl,-rpath,"$library" $(pkg-config --libs simbody) || fail "slider.cpp does not build"
status=0
"$build/slider" || status=$?
[ "$status" -le 1 ] || fail "the slider ended with status $status"
exit "$status"
