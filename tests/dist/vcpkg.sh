#!/usr/bin/env bash
# Installs this checkout by its vcpkg port, and builds and runs CMake projects that find the library through vcpkg. In folders of
# its own: the user's vcpkg is left as it is.
#
# usage: tests/dist/vcpkg.sh      needs vcpkg: VCPKG_ROOT names its folder; VCPKG the program, if it is not in there
set -euo pipefail
cd "$(dirname "$0")/../.."
. tests/dist/shared.sh
[ -n "${VCPKG_ROOT:-}" ] || fail "VCPKG_ROOT names no folder of vcpkg: https://learn.microsoft.com/vcpkg has how to install it"
vcpkg=${VCPKG:-$VCPKG_ROOT/vcpkg}
command -v "$vcpkg" >/dev/null ||
    fail "$vcpkg is missing: run bootstrap-vcpkg.sh in $VCPKG_ROOT, or name it: VCPKG=/folder/vcpkg $0"
work=$(realpath -m "${CARGO_TARGET_DIR:-target}")/dist/vcpkg
rm -rf "$work"
mkdir -p "$work"
unset CARGO_TARGET_DIR

quietly "$vcpkg" install asperity --overlay-ports=packaging/vcpkg --binarysource=clear --x-install-root="$work/installed" \
    --x-buildtrees-root="$work/build" --x-packages-root="$work/packages" --downloads-root="$work/downloads"
for project in find-package-shared find-package-static; do
    quietly cmake -S "tests/consumers/$project" -B "$work/$project" -DASPERITY_WANTED="$(version_of_tree)" \
        -DCMAKE_TOOLCHAIN_FILE="$VCPKG_ROOT/scripts/buildsystems/vcpkg.cmake" -DVCPKG_INSTALLED_DIR="$work/installed"
    quietly cmake --build "$work/$project"
    quietly "$work/$project/consumer"
done
echo "tests/dist/vcpkg.sh: vcpkg builds and installs the library; programs with the shared and the static one run"
