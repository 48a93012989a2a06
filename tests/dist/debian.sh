#!/usr/bin/env bash
# Installs the Debian packages for amd64 of dist/ in a Debian 12 that has compilers and no Rust, and uses them from C, C++, Fortran and
# Python. The system is made once, in ROOT; each run lays its changes over it and forgets them.
#
# usage: tests/dist/debian.sh ROOT      as root; needs debootstrap
set -euo pipefail
cd "$(dirname "$0")/../.."
. tests/dist/shared.sh
root=$1
[ "$(id -u)" = 0 ] || fail "only root can make and enter another system: sudo make dist-test"

if [ ! -f "$root/made" ]; then
    rm -rf --one-file-system "$root"
    mkdir -p "$root"
    unshare -m --propagation private debootstrap --variant=minbase \
        --include=g++,gfortran,make,cmake,pkg-config,python3,python3-numpy bookworm "$root/system" >"$root/log" ||
        { tail -n 20 "$root/log" >&2; fail "debootstrap failed"; }
    touch "$root/made"
fi
# In mount and network name spaces of its own, as above: nothing stays mounted, whatever ends this, and nothing is fetched.
SYSTEM=$root/system CHANGES=$root/changes VERSION=$(version_of_tree) unshare -m -n --propagation private bash -euo pipefail -c '
    rm -rf "$CHANGES"
    mkdir -p "$CHANGES"
    mount -t tmpfs tmpfs "$CHANGES"
    mkdir "$CHANGES/upper" "$CHANGES/work" "$CHANGES/root"
    mount -t overlay overlay -o "lowerdir=$SYSTEM,upperdir=$CHANGES/upper,workdir=$CHANGES/work" "$CHANGES/root"
    root=$CHANGES/root
    mkdir "$root/packages" "$root/source"
    cp dist/*_amd64.deb "$root/packages"
    git archive HEAD tests/consumers tests/dist fortran | tar -x -C "$root/source"
    mount -t proc proc "$root/proc"
    chroot "$root" sh -euc "
        if command -v cargo rustc; then echo there is Rust; exit 1; fi
        dpkg -i /packages/*.deb >/dev/null
        /source/tests/dist/installed.sh /tmp/work
        python3 /source/tests/dist/python_check.py \$1
        dpkg --purge python3-asperity libasperity-dev libasperity0 >/dev/null
        if find / -xdev -path /source -prune -o -path /packages -prune -o -path /tmp -prune -o -path /proc -prune \
            -o -name \"*asperity*\" -print | grep .; then echo left behind by the packages; exit 1; fi
    " sh "$VERSION"
'
