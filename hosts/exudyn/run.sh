#!/usr/bin/env bash
# Installs Exudyn, runs the stick-slip oscillator; the last line says PASS or FAIL.
set -euo pipefail
cd "$(dirname "$0")/../.."

fail() {
    echo "exudyn  FAIL  $*"
    exit 1
}
# shellcheck source=hosts/environment.sh
. hosts/environment.sh
library
packages exudyn exudyn==1.13.6 scipy
run "$environment/bin/python" hosts/exudyn/stick_slip.py
