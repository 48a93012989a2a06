#!/usr/bin/env bash
# Installs this checkout by its Spack recipe, with the system's Rust and compiler, and runs a program that finds the library
# with pkg-config. In folders of its own: the user's Spack is left as it is.
#
# usage: tests/dist/spack.sh      needs Spack 1.0 or later: SPACK names the program if it is not `spack`; where Spack cannot
#                                 clone its recipes from the network, SPACK_BUILTIN is their folder, .../spack_repo/builtin
set -euo pipefail
cd "$(dirname "$0")/../.."
. tests/dist/shared.sh
spack=${SPACK:-spack}
command -v "$spack" >/dev/null || fail "$spack is missing: https://spack.io, or name it: SPACK=/folder/bin/spack $0"
work=$(realpath -m "${CARGO_TARGET_DIR:-target}")/dist/spack
rm -rf "$work"
mkdir -p "$work/settings"
cat >"$work/settings/config.yaml" <<YAML
config:
  install_tree: {root: $work/installed}
  build_stage: [$work/build]
  develop_stage_link: $work/link
YAML
cat >"$work/settings/repos.yaml" <<YAML
repos:
  asperity: $PWD/packaging/spack/spack_repo/asperity
${SPACK_BUILTIN:+  builtin: $SPACK_BUILTIN}
YAML
export SPACK_USER_CONFIG_PATH=$work/settings CARGO_TARGET_DIR=$work/cargo

quietly "$spack" external find --not-buildable rust gmake
quietly "$spack" dev-build --quiet --source-path "$PWD" "asperity@$(version_of_tree)"
prefix=$("$spack" location --install-dir asperity)
mkdir "$work/consumer"
PKG_CONFIG_PATH=$prefix/lib/pkgconfig quietly make -C tests/consumers/pkg-config BUILD="$work/consumer"
quietly "$work/consumer/consumer"
echo "tests/dist/spack.sh: Spack $("$spack" --version) builds and installs the library; a C program runs with it"
