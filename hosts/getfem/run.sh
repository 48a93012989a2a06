#!/usr/bin/env bash
# Runs the blocks with a rough interface and the sheared block with Debian's GetFEM; the last line says PASS or FAIL.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
# Debian's GetFEM belongs to Debian's Python, whichever python3 comes first in PATH.
/usr/bin/python3 -c "import getfem" ||
    fail "GetFEM is missing: apt-get install python3-getfem"
run /usr/bin/python3 hosts/getfem/gap.py
run /usr/bin/python3 hosts/getfem/block.py
