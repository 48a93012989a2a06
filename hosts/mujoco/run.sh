#!/usr/bin/env bash
# Installs MuJoCo, builds the plugin for C, runs what hops and bounces with each input altered, the bodies that stick and the slider; the last line says PASS or FAIL.
set -euo pipefail
cd "$(dirname "$0")/../.."

fail() {
    echo "mujoco  FAIL  $*"
    exit 1
}
# shellcheck source=hosts/environment.sh
. hosts/environment.sh
library
packages mujoco mujoco==4.0.0
build=$target/hosts/mujoco
mkdir -p "$build"
hosts/mujoco/build.sh "$(echo "$environment"/lib/python3*/site-packages/mujoco)" "$build/libasperity_mujoco.so" ||
    fail "the plugin does not build"

# MuJoCo writes its messages to a file where it runs; the plugin that Python makes is kept with them.
export XDG_CACHE_HOME=$build
cd "$build"
for program in altered hold slider; do
    run "$environment/bin/python" "$root/hosts/mujoco/$program.py" "$build/libasperity_mujoco.so"
done
