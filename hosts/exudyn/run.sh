#!/usr/bin/env bash
# Installs Exudyn, runs the box on an incline; the last line says PASS or FAIL.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
example incline.py exudyn==1.13.6 numpy
