#!/usr/bin/env bash
# Builds and runs the ODE host: an arm on a belt (is a lagged force stable?), then a sled; the last line is the verdict.
# The figure of the arm is left in target/hosts/ode/lag.svg.
set -euo pipefail
cd "$(dirname "$0")/../.."

fail() {
    echo "ode  FAIL  $*"
    exit 1
}
# shellcheck source=hosts/environment.sh
. hosts/environment.sh
library
build=$target/hosts/ode
pkg-config --exists ode || fail "ODE is missing: apt-get install libode-dev pkg-config"
mkdir -p "$build"
for program in arm sled; do
    # shellcheck disable=SC2046
    gcc -std=c11 -O2 -Wall -Wextra -Werror -Iinclude $(pkg-config --cflags ode | sed 's/-I/-isystem /g') \
        "hosts/ode/$program.c" hosts/ode/law_step.c -o "$build/$program" \
        -L"$target/release" -lasperity -Wl,-rpath,"$target/release" $(pkg-config --libs ode) -lm ||
        fail "$program.c does not build"
done
verdict "$build/arm" "$build/lag.svg"
verdict "$build/sled"
