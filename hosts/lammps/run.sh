#!/usr/bin/env bash
# Builds the LAMMPS host and runs it on one rank, on two, and with a constant mu; the last line is the verdict.
set -euo pipefail
cd "$(dirname "$0")/../.."
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
build=$target/hosts/lammps

fail() {
    echo "lammps  FAIL  $*"
    exit 1
}
cmake/check_rust.sh || fail "the library does not build"

if ! [ -e /usr/include/lammps/library.h ] || ! command -v mpicc mpirun >/dev/null; then
    fail "LAMMPS is missing: apt-get install liblammps-dev"
fi
cargo build --quiet --release --locked -j1 || fail "the library does not build"
mkdir -p "$build"
mpicc -std=c11 -O2 -Wall -Wextra -Werror -Iinclude hosts/lammps/column.c -o "$build/column" \
    -L"$target/release" -lasperity -Wl,-rpath,"$target/release" -llammps -lm || fail "column.c does not build"

# Containers run as root and may have fewer cores than ranks; OpenMPI minds both, unless told.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMP_NUM_THREADS=1
column() {
    local ranks=$1
    shift
    mpirun --oversubscribe -np "$ranks" "$build/column" "$@" || fail "column ended with status $? on $ranks ranks"
}
rm -f "$build"/*.txt
column 1 "$build/one.txt"
column 2 "$build/two.txt"
column 1 "$build/constant.txt" 0.3
exec "$build/column" compare "$build/one.txt" "$build/two.txt" "$build/constant.txt"
