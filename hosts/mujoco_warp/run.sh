#!/usr/bin/env bash
# Installs MuJoCo Warp, runs the ball with each input altered on the processor; the last line says PASS or FAIL. Compiling MuJoCo
# Warp's kernels takes a minute or two, once.
set -euo pipefail
cd "$(dirname "$0")/../.."

fail() {
    echo "mujoco_warp  FAIL  $*"
    exit 1
}
# shellcheck source=hosts/environment.sh
. hosts/environment.sh
library
packages mujoco_warp mujoco-warp==4.0.0
export WARP_CACHE_PATH=$target/hosts/mujoco_warp/kernels CUDA_VISIBLE_DEVICES=
run "$environment/bin/python" hosts/mujoco_warp/altered.py
