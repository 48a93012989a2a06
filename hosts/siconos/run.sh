#!/usr/bin/env bash
# Builds and runs the box on an incline; the last line says PASS or FAIL.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
[ -e /usr/include/siconos/numerics/FrictionContactProblem.h ] || fail "Siconos is missing: apt-get install libsiconos-numerics-dev"
export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1
compile incline -isystem /usr/include/siconos -isystem /usr/include/siconos/numerics -lsiconos_numerics
verdict "$build/incline"
