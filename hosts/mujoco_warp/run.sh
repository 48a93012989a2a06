#!/usr/bin/env bash
# Installs MuJoCo Warp, runs the ball with each input altered on the processor. Compiling its kernels takes a minute or two, once; the last line says PASS or FAIL.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
export WARP_CACHE_PATH=$target/hosts/mujoco_warp/kernels CUDA_VISIBLE_DEVICES=
example altered.py mujoco-warp==4.0.0
