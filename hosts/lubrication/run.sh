#!/usr/bin/env bash
# Runs a lubricated pad whose summits touch; the last line says PASS or FAIL.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
example pad.py numpy
