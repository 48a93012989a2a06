#!/usr/bin/env bash
# Builds and runs the Simbody slider against this library; the last line says PASS or FAIL.
set -euo pipefail
cd "$(dirname "$0")/../.."

fail() {
    echo "simbody  FAIL  $*"
    exit 1
}
# shellcheck source=hosts/environment.sh
. hosts/environment.sh
library
build=$target/hosts/simbody
pkg-config --exists simbody || fail "Simbody is missing: apt-get install libsimbody-dev"
mkdir -p "$build"
# shellcheck disable=SC2046
g++ -std=c++17 -O2 -Wall -Wextra -Iinclude -isystem /usr/include/simbody hosts/simbody/slider.cpp -o "$build/slider" \
    -L"$target/release" -lasperity -Wl,-rpath,"$target/release" $(pkg-config --libs simbody) || fail "slider.cpp does not build"
verdict "$build/slider"
