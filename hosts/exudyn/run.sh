#!/usr/bin/env bash
# Installs Exudyn, runs the stick-slip oscillator; the last line says PASS or FAIL.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
example stick_slip.py exudyn==1.13.6 scipy
