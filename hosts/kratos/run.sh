#!/usr/bin/env bash
# Installs Kratos and its contact application, runs the block; the last line says PASS or FAIL.
set -euo pipefail
cd "$(dirname "$0")/../.."

fail() {
    echo "kratos  FAIL  $*"
    exit 1
}
# shellcheck source=hosts/environment.sh
. hosts/environment.sh
library
packages kratos KratosContactStructuralMechanicsApplication==10.4.4 numpy
# Kratos' threads wait for each other in turns: many times slower where others use the cores.
export OMP_NUM_THREADS=1
run "$environment/bin/python" hosts/kratos/block.py
