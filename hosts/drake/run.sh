#!/usr/bin/env bash
# Installs Drake, runs the sled; the last line says PASS or FAIL.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
example sled.py drake==1.51.1 numpy
