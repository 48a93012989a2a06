#!/usr/bin/env bash
# Builds and runs the Siconos host; the last line is the verdict.
set -euo pipefail
cd "$(dirname "$0")/../.."

fail() {
    echo "siconos  FAIL  $*"
    exit 1
}
# shellcheck source=hosts/environment.sh
. hosts/environment.sh
library
build=$target/hosts/siconos
[ -e /usr/include/siconos/numerics/FrictionContactProblem.h ] ||
    fail "Siconos is missing: apt-get install libsiconos-numerics-dev"
mkdir -p "$build"
gcc -std=c11 -O2 -Wall -Wextra -Werror -Iinclude -isystem /usr/include/siconos \
    -isystem /usr/include/siconos/numerics hosts/siconos/brush.c -o "$build/brush" \
    -L"$target/release" -lasperity -Wl,-rpath,"$target/release" -lsiconos_numerics -lm || fail "brush.c does not build"
export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1
verdict "$build/brush"
