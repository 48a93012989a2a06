#!/usr/bin/env bash
# Installs PyBullet, runs the box on an incline; the last line says PASS or FAIL.
set -euo pipefail
cd "$(dirname "$0")/../.."

fail() {
    echo "bullet  FAIL  $*"
    exit 1
}
# shellcheck source=hosts/environment.sh
. hosts/environment.sh
library
packages bullet pybullet==3.2.7 numpy
run "$environment/bin/python" hosts/bullet/incline.py
