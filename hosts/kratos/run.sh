#!/usr/bin/env bash
# Installs Kratos and its contact application, runs the block; the last line says PASS or FAIL.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
packages kratos KratosContactStructuralMechanicsApplication==10.4.4 numpy
# Kratos' threads wait for each other in turns: many times slower where others use the cores.
export OMP_NUM_THREADS=1
run "$environment/bin/python" hosts/kratos/block.py
