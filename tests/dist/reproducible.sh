#!/usr/bin/env bash
# Builds a part of dist/ again, in another checkout of the commit with another target directory: every file must have the
# sum that it has in dist/SHA256SUMS. Later runs find Rust's standard library in that directory, built by the first one.
#
# usage: tests/dist/reproducible.sh WORK [NAME...]     after make dist; NAME as for packaging/dist.py
set -euo pipefail
cd "$(dirname "$0")/../.."
. tests/dist/shared.sh
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
root=$PWD work=$1
shift
rm -rf "$work/checkout"
mkdir -p "$work/built"
copy_commit "$work/checkout"
ln -sfn "$target/dist-venv" "$work/built/dist-venv"
cd "$work/checkout"
CARGO_TARGET_DIR=$work/built python3 packaging/dist.py "$@" >"$work/log" 2>&1 ||
    { cat "$work/log" >&2; fail "the second build failed"; }
same=0
while read -r sum file; do
    if [ "$(grep "  $file\$" "$root/dist/SHA256SUMS")" != "$sum  $file" ]; then
        fail "$file differs from that in dist/ (is dist/ of this commit?): $PWD/dist/$file"
    fi
    same=$((same + 1))
done <dist/SHA256SUMS
[ "$same" != 0 ] || fail "nothing was built"
cd "$root"
rm -rf "$work/checkout"
echo "$same files, built again elsewhere: the same bytes"
