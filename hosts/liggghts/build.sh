#!/usr/bin/env bash
# Builds libasperity_liggghts.so for Debian's LIGGGHTS; OUTPUT names the file.
set -euo pipefail
output=$(realpath -m "${OUTPUT:-libasperity_liggghts.so}")
cd "$(dirname "$0")/../.."
target=${CARGO_TARGET_DIR:-target}
cargo build --quiet --release --locked
# Debian has no style_*.h, of which LIGGGHTS knows its models: here they are those of the plugin.
styles=$(mktemp -d)
trap 'rm -r "$styles"' EXIT
touch "$styles"/style_{tangential,cohesion,contact}_model.h
echo '#include "surface_model_default.h"' >"$styles/style_surface_model.h"
echo '#include "normal_model_asperity.h"' >"$styles/style_normal_model.h"
printf '#include "rolling_model_%s.h"\n' cdt epsd2 >"$styles/style_rolling_model.h"
mpicxx -std=c++17 -O2 -ffp-contract=off -fno-math-errno -Wall -Wextra -Werror -fPIC -shared -fvisibility=hidden -Iinclude -Ihosts/liggghts \
    -Ihosts/lammps -isystem "$styles" -isystem /usr/include/liggghts hosts/liggghts/plugin.cpp hosts/lammps/{law,beads,microslip}.cpp \
    -o "$output" "$target/release/libasperity.a" -lliggghts -lpthread -ldl -lm -Wl,--exclude-libs,ALL
