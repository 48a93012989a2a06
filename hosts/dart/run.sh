#!/usr/bin/env bash
# Installs DART, runs the sled; the last line says PASS or FAIL.
set -euo pipefail
cd "$(dirname "$0")/../.."

fail() {
    echo "dart  FAIL  $*"
    exit 1
}
# shellcheck source=hosts/environment.sh
. hosts/environment.sh
library
packages dart dartpy==6.20.0 numpy
run "$environment/bin/python" hosts/dart/sled.py
