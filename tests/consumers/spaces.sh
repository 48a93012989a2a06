#!/usr/bin/env bash
# Folders with spaces: the checkout, what cargo builds, the prefix. Installs from there, builds a program with pkg-config, moves the
# prefix and builds it again, and takes all of it away.
#
# usage: tests/consumers/spaces.sh FOLDER      needs git, cargo, make, cc, pkg-config
set -euo pipefail
cd "$(dirname "$0")/../.."
work=$1
rm -rf "$work"
mkdir -p "$work/a target"
git clone --quiet . "$work/a checkout"
# With what is not committed.
git diff HEAD --binary | git -C "$work/a checkout" apply --allow-empty --whitespace=nowarn
cd "$work/a checkout"

fail() {
    cat "$work/log" >&2
    echo "tests/consumers/spaces.sh: $1" >&2
    exit 1
}

program() {
    local prefix=$1
    export PKG_CONFIG_PATH=$prefix/lib/pkgconfig
    # What pkg-config says is quoted for a shell.
    eval "cc c_examples/friction_curve.c $(pkg-config --cflags --libs asperity) -lm -o '$work/a program'" >"$work/log" 2>&1 ||
        fail "no program with '$prefix'"
    LD_LIBRARY_PATH=$prefix/lib "$work/a program" "$work/a curve.svg" >"$work/log" || fail "the program fails"
}

unset CARGO_TARGET_DIR
for target in "$work/a target" "a target"; do
    # The second has nothing to build, with a path that is not absolute.
    [ "$target" != "a target" ] || mv "$work/a target" "a target"
    make install "CARGO_TARGET_DIR=$target" "PREFIX=$work/a prefix" >"$work/log" 2>&1 || fail "make install fails"
    ! grep -q Compiling "$work/log" || [ "$target" != "a target" ] || fail "builds once more"
done
program "$work/a prefix"
mv "$work/a prefix" "$work/moved on"
program "$work/moved on"
mv "$work/moved on" "$work/a prefix"
: >"$work/a prefix/lib/of somebody else"
make install "CARGO_TARGET_DIR=a target" "PREFIX=$work/a prefix" "LIBDIR=$work/own libraries" >"$work/log" 2>&1 || fail "no LIBDIR"
grep -qxF "prefix=${work// /\\ }/a\\ prefix" "$work/own libraries/pkgconfig/asperity.pc" || fail "asperity.pc in LIBDIR has another prefix"
make uninstall "CARGO_TARGET_DIR=a target" "PREFIX=$work/a prefix" "LIBDIR=$work/own libraries" >"$work/log" 2>&1 || fail "no uninstall"
make install DESTDIR="$work/a stage" "CARGO_TARGET_DIR=a target" "PREFIX=/a prefix" >"$work/log" 2>&1 || fail "no stage"
for prefix in "PREFIX=$work/a prefix" "DESTDIR=$work/a stage PREFIX=/a prefix"; do
    if [ "${prefix#DESTDIR}" = "$prefix" ]; then
        make uninstall "$prefix" >"$work/log" 2>&1
    else
        make uninstall DESTDIR="$work/a stage" "PREFIX=/a prefix" >"$work/log" 2>&1
    fi || fail "make uninstall fails"
done
left=$(find "$work/a prefix" "$work/a stage" "$work/own libraries" -not -type d)
[ "$left" = "$work/a prefix/lib/of somebody else" ] || fail "make uninstall leaves: $left"
echo "folders with spaces: installed, linked, moved and taken away"
