#!/usr/bin/env bash
# Installs DART, runs the box on an incline; the last line says PASS or FAIL.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
example incline.py dartpy==6.20.0 numpy
