#!/usr/bin/env bash
# Runs the block on an incline with Debian's YADE; the last line says PASS or FAIL.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
command -v yade >/dev/null || fail "YADE is missing: apt-get install --no-install-recommends yade"
# YADE does not look for modules beside a program.
export PYTHONPATH=$root/hosts:$root/python/src ASPERITY_LIBRARY=$target/release/libasperity.so PYTHONPYCACHEPREFIX=$target/pycache
verdict yade -nx -j1 -x hosts/yade/incline.py
