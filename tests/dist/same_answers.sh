#!/usr/bin/env bash
# Platforms agree to 1e-12 on the hundred answers of same_answers.txt: runs same_answers.c with the library of each target, there
# or in an emulator.
#
# usage: tests/dist/same_answers.sh              on this machine, on x86-64 Linux also without vectors where qemu is there
#        tests/dist/same_answers.sh TARGET...    Rust's names of targets; the library of each is $STAGE/TARGET/lib/libasperity.a
#        tests/dist/same_answers.sh --write      makes the list anew, after a change that is to change answers
set -euo pipefail
cd "$(dirname "$0")/../.."
. tests/dist/shared.sh

list=tests/dist/same_answers.txt
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
work=$target/same-answers
mkdir -p "$work"

# compare NAME COMMAND...: the rows that the command writes with those of the list
compare() {
    local name=$1
    shift
    "$@" >"$work/answers" || fail "$name: $*"
    tr -d '\r' <"$work/answers" | paste -d: - "$list" | awk -F: '
        { difference = $2 - $4; size = $4 < 0 ? -$4 : $4 }
        NF != 4 || $1 != $3 || difference > 1e-12 * size || difference < -1e-12 * size { print; wrong = 1 }
        END { exit wrong }' >&2 || fail "$name has other answers than $list"
    echo "$name: the same answers"
}

# compile PROGRAM LIBRARY COMPILER [ARGUMENT...]
compile() {
    local program=$work/$1 library=$2
    shift 2
    quietly "$1" -std=c11 -O1 -Wall -Wextra -Werror -Iinclude tests/dist/same_answers.c -o "$program" "$library" "${@:2}"
}

here() {
    cargo build --release --locked --quiet
    compile here "$target/release/libasperity.a" "${CC:-cc}" -lm -lpthread -ldl
}

staged() {
    local library=$STAGE/$1/lib/libasperity.a run program=$work/$1
    [ -e "$library" ] || fail "there is no $library"
    case "$1" in
    x86_64-unknown-linux-gnu) compile "$1" "$library" "${CC:-cc}" -lm -lpthread -ldl; run=() ;;
    # GCC's own part for unwinding is made for glibc.
    x86_64-unknown-linux-musl)
        compile "$1" "$library" musl-gcc -static -nodefaultlibs \
            "$(rustc --print target-libdir --target "$1")/self-contained/libunwind.a" -lc -lgcc
        run=() ;;
    aarch64-unknown-linux-gnu)
        compile "$1" "$library" aarch64-linux-gnu-gcc -lm
        run=(qemu-aarch64 -L /usr/aarch64-linux-gnu) ;;
    x86_64-pc-windows-gnu)
        compile "$1.exe" "$library" x86_64-w64-mingw32-gcc -lm -lkernel32 -lntdll -luserenv -lws2_32 -ldbghelp
        run=("$wine") program=$program.exe ;;
    wasm32-unknown-unknown)
        compile "$1" "$library" clang --target=wasm32-wasi -nodefaultlibs -lc
        run=(node --no-warnings tests/dist/run_wasi.mjs) ;;
    *) fail "unknown target '$1'" ;;
    esac
    compare "$1" "${run[@]}" "$program"
}

case "${1:-}" in
--write)
    here
    "$work/here" >"$list" ;;
"")
    here
    compare "this machine" "$work/here"
    if [ "$(uname -sm)" = "Linux x86_64" ] && command -v qemu-x86_64 >/dev/null; then
        compare "x86-64 without vectors" qemu-x86_64 -cpu Nehalem "$work/here"
    fi ;;
*) for name in "$@"; do staged "$name"; done ;;
esac
