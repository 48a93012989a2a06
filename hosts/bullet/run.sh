#!/usr/bin/env bash
# Installs PyBullet, runs the box on an incline; the last line says PASS or FAIL.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
example incline.py pybullet==3.2.7 numpy
