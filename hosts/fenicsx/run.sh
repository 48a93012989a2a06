#!/usr/bin/env bash
# Runs the pushed block with Debian's FEniCSx, which compiles its forms once; the last line says PASS or FAIL.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
# Debian's FEniCSx belongs to Debian's Python, whichever python3 comes first in PATH.
/usr/bin/python3 -c "import dolfinx" || fail "FEniCSx is missing: apt-get install python3-dolfinx-real"
export XDG_CACHE_HOME=$build OMP_NUM_THREADS=1
run /usr/bin/python3 hosts/fenicsx/block.py
