#!/usr/bin/env bash
# Runs the blocks with a rough interface and the sheared block with Debian's GetFEM; the last line says PASS or FAIL. The picture
# goes to hosts/getfem/block.svg of the target directory.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
# Debian's GetFEM belongs to Debian's Python, whichever python3 comes first in PATH.
/usr/bin/python3 -c "import getfem, matplotlib" ||
    fail "GetFEM or Matplotlib is missing: apt-get install python3-getfem python3-matplotlib"
run /usr/bin/python3 hosts/getfem/gap.py
run /usr/bin/python3 hosts/getfem/block.py "$build/block.svg"
