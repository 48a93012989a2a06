#!/usr/bin/env bash
# Builds and runs the pushed block with Debian's deal.II; the last line says PASS or FAIL.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
[ -d /usr/include/deal.II ] || fail "deal.II is missing: apt-get install --no-install-recommends libdeal.ii-dev"
# What Debian's deal.II was built with is in its headers, and behind its library.
# shellcheck disable=SC2046
compile block -isystem /usr/include/deal.II $(printf ' -isystem /usr/%s' include/suitesparse include/trilinos lib/petscdir/petsc-real/include \
    lib/slepcdir/slepc-real/include) $(mpicxx --showme:compile | sed 's/-I/-isystem /g') -Wl,--copy-dt-needed-entries -ldeal.ii
export OMP_NUM_THREADS=1 DEAL_II_NUM_THREADS=1
packages "$host" numpy
run "$environment/bin/python" hosts/dealii/block.py "$build/block"
