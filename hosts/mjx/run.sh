#!/usr/bin/env bash
# Installs MuJoCo XLA, runs the ball with each input altered on the processor. Compiling a step takes some seconds for each; they are kept. The last line says PASS or FAIL.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
# The plugin that Python makes is kept beside what XLA compiles.
export XDG_CACHE_HOME=$build JAX_COMPILATION_CACHE_DIR=$build/compiled JAX_PLATFORMS=cpu
example altered.py mujoco-mjx==3.17.0
