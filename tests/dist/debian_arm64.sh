#!/usr/bin/env bash
# Unpacks the Debian packages for 64-bit ARM in dist/, compiles C programs with what is in them, shared and static, and runs them in
# qemu. Nothing is installed: that takes a system of that architecture.
#
# usage: tests/dist/debian_arm64.sh WORK      needs what tests/setup.sh dist installs
set -euo pipefail
cd "$(dirname "$0")/../.."
. tests/dist/shared.sh
work=$1
rm -rf "$work"
mkdir -p "$work"
version=$(version_of_tree)
for package in libasperity0 libasperity-dev python3-asperity; do
    file=dist/${package}_$version-1_arm64.deb
    [ "$(dpkg-deb -f "$file" Architecture)" = arm64 ] || fail "$file is not for arm64"
    dpkg-deb -x "$file" "$work/root"
done
dpkg-deb -f "dist/libasperity0_$version-1_arm64.deb" Depends | grep -qx 'libc6:arm64 (>= [0-9.]*)' ||
    fail "libasperity0 does not depend on the C library of arm64 alone"

libraries=$work/root/usr/lib/aarch64-linux-gnu
asked() {
    PKG_CONFIG_LIBDIR=$libraries/pkgconfig pkg-config "$@" asperity
}
# shellcheck disable=SC2046
quietly aarch64-linux-gnu-gcc -std=c11 tests/consumers/greenwood_williamson.c $(asked --cflags --libs) -lm -o "$work/shared"
# shellcheck disable=SC2046
quietly aarch64-linux-gnu-gcc -std=c11 -static tests/consumers/greenwood_williamson.c $(asked --static --cflags --libs) -lm \
    -o "$work/static"
quietly qemu-aarch64 -L /usr/aarch64-linux-gnu -E LD_LIBRARY_PATH="$libraries" "$work/shared"
quietly qemu-aarch64 "$work/static"
python=$work/root/usr/lib/python3/dist-packages/asperity
for file in libasperity.so asperity.h; do
    [ -f "$python/$file" ] || fail "python3-asperity: $file leads nowhere"
done
echo "unpacked; a C program with the shared and with the static library, run in qemu"
