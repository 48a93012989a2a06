# What scripts of tests/dist have in common: sourced by them, at the root of the tree. Before `quietly`, $work is a folder.
# shellcheck shell=bash disable=SC2034

wine=$(command -v wine64 || echo /usr/lib/wine/wine64)
# Wine's files are made once for all tests, without the parts for .NET and HTML.
WINEPREFIX=$(realpath -m "${CARGO_TARGET_DIR:-target}")/wine
export WINEPREFIX WINEDEBUG=-all WINEDLLOVERRIDES="mscoree,mshtml="

# A command that fails without a word is named.
set -E
trap 'echo "tests/dist/${0##*/}: line $LINENO: failed: $BASH_COMMAND" >&2' ERR

fail() {
    echo "tests/dist/${0##*/}: $*" >&2
    exit 1
}

# quietly COMMAND...: what it prints is shown if it fails.
quietly() {
    "$@" >"$work/log" 2>&1 || { cat "$work/log" >&2; fail "failed: $*"; }
}

# copy_commit FOLDER: a checkout of the commit; git's advice about one that is on no branch, as that of a tag is, is left out.
copy_commit() {
    git -c advice.detachedHead=false -c init.defaultBranch=main clone --quiet --local . "$1"
}

# The version in Cargo.toml.
version_of_tree() {
    sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml
}
