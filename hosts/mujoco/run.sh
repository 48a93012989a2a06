#!/usr/bin/env bash
# Installs MuJoCo, builds the plugin for C, runs what hops and bounces with each input altered, the bodies that stick and the slider; the last line says PASS or FAIL.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
packages mujoco mujoco==4.0.0
MUJOCO=$(echo "$environment"/lib/python3*/site-packages/mujoco)
export MUJOCO
OUTPUT=$build/libasperity_mujoco.so hosts/mujoco/build.sh || fail "the plugin does not build"
# On a cluster: an installed library, and neither cargo nor a variable that names its folder.
make install PREFIX="$build/prefix" >"$build/install.log" 2>&1 || fail "make install: $build/install.log"
(cd "$build" && env -i PATH=/usr/bin:/bin MUJOCO="$MUJOCO" OUTPUT=installed.so "$root/hosts/mujoco/build.sh" prefix) ||
    fail "the plugin does not build against an installed library"

# The page's program and what it prints, in the order of the page.
python3 -c 'import re, sys; print(*re.findall(r"^```(?:python|text)\n(.*?)^```$", sys.stdin.read(), re.S | re.M), sep="", end="")' \
    <hosts/mujoco/README.md >"$build/page.txt"

# MuJoCo writes its messages to a file where it runs; the plugin that Python makes is kept with them.
export XDG_CACHE_HOME=$build
cd "$build"
{ cat "$root/hosts/mujoco/gripper.py"; run "$environment/bin/python" "$root/hosts/mujoco/gripper.py"; } | diff page.txt - || fail "the page's gripper"
tail -n 3 page.txt
for program in altered hold slider; do
    run "$environment/bin/python" "$root/hosts/mujoco/$program.py" "$build/libasperity_mujoco.so" "$build/installed.so"
done
