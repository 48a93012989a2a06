#!/usr/bin/env bash
# The same bits on every machine: builds the library for each target, runs same_bits.c with it there or in an emulator,
# and compares its list of answers with same_bits.txt; then tests/c/environments.c, but in WebAssembly, which has one.
#
# usage: tests/dist/same_bits.sh                the short form: every third surface, on this machine, and on x86-64 Linux
#                                               also with AVX2, with SSE, as 64-bit ARM and as Windows; installs what that takes
#        tests/dist/same_bits.sh all            every target
#        tests/dist/same_bits.sh TARGET...      Rust's names of targets
#        tests/dist/same_bits.sh --write        makes the list anew, after a change that is to change answers
#
# But for this machine's, targets take x86-64 Linux and what `tests/setup.sh dist` installs. With STAGE=FOLDER it builds
# nothing: the library of a target is FOLDER/TARGET/lib/libasperity.a.
set -euo pipefail
cd "$(dirname "$0")/../.."
. tests/dist/shared.sh

all="x86_64-unknown-linux-gnu x86_64-unknown-linux-musl aarch64-unknown-linux-gnu armv7-unknown-linux-gnueabihf
    i686-unknown-linux-gnu riscv64gc-unknown-linux-gnu powerpc64le-unknown-linux-gnu s390x-unknown-linux-gnu
    x86_64-pc-windows-gnu wasm32-unknown-unknown"
# Every third surface takes an emulator seconds; each distribution of heights but Johnson's is among them.
short_step=3
list=tests/dist/same_bits.txt
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
build=$target/same-bits
host=$(rustc -vV 2>/dev/null | sed -n 's/^host: //p')

# What a target needs: its compiler, and the command before a program of its.
describe() {
    case "$1" in
    "$host" | x86_64-unknown-linux-gnu) compiler=${CC:-cc} run=env ;;
    x86_64-unknown-linux-musl) compiler="musl-gcc -static -nodefaultlibs" run=env ;;
    aarch64-unknown-linux-gnu) compiler=aarch64-linux-gnu-gcc run=qemu-aarch64 ;;
    armv7-unknown-linux-gnueabihf) compiler=arm-linux-gnueabihf-gcc run=qemu-arm ;;
    # By the processor: qemu rounds what its x87 unit loads, which processors do not.
    i686-unknown-linux-gnu)
        compiler="i686-linux-gnu-gcc -msse2 -mfpmath=sse" run=/usr/i686-linux-gnu/lib/ld-linux.so.2 ;;
    riscv64gc-unknown-linux-gnu) compiler=riscv64-linux-gnu-gcc run=qemu-riscv64 ;;
    powerpc64le-unknown-linux-gnu) compiler=powerpc64le-linux-gnu-gcc run=qemu-ppc64le ;;
    s390x-unknown-linux-gnu) compiler=s390x-linux-gnu-gcc run=qemu-s390x ;;
    x86_64-pc-windows-gnu) compiler=x86_64-w64-mingw32-gcc run=$wine ;;
    wasm32-unknown-unknown) compiler="clang --target=wasm32-wasi -nodefaultlibs" run=node ;;
    *) fail "unknown target '$1'; known are all and:" $all ;;
    esac
}

missing() {
    fail "$1: $2 is missing: run tests/setup.sh dist"
}

# Whether everything is there, before anything is built.
check_tools() {
    describe "$1"
    [ "$1" = "$host" ] || [ "$(uname -sm)" = "Linux x86_64" ] || fail "$1 takes x86-64 Linux; of here is: $host"
    command -v "${compiler%% *}" >/dev/null || missing "$1" "${compiler%% *}"
    command -v "$run" >/dev/null || missing "$1" "$run"
    case "$1" in
    x86_64-unknown-linux-gnu)
        command -v qemu-x86_64 >/dev/null || missing "$1" qemu-x86_64 ;;
    wasm32-unknown-unknown)
        [ -e /usr/lib/wasm32-wasi/libc.a ] || missing "$1" wasi-libc
        command -v wasm-ld >/dev/null || missing "$1" wasm-ld ;;
    esac
    if [ -n "${STAGE:-}" ]; then
        [ -e "$STAGE/$1/lib/libasperity.a" ] || fail "$1: there is no $STAGE/$1/lib/libasperity.a"
    else
        [ -d "$(rustc --print target-libdir --target "$1")" ] || missing "$1" "Rust's library (rustup target add $1)"
    fi
}

# compile NAME SOURCE: for the target that `describe` was asked for
compile() {
    local libraries=(-lm) name=${1#environments-}
    case "$1" in
    *.exe) libraries+=(-lkernel32 -lntdll -luserenv -lws2_32 -ldbghelp) ;;
    *.wasm) libraries=(-lc) ;;
    # GCC's own part for unwinding is made for glibc.
    *-musl) libraries=("$(rustc --print target-libdir --target "$name")/self-contained/libunwind.a" -lc -lgcc) ;;
    esac
    # shellcheck disable=SC2086
    $compiler -std=c11 -O1 -ffp-contract=off -Wall -Wextra -Werror -Iinclude "$2" -o "$build/$1" "$library" \
        "${libraries[@]}" 2>"$build/log" || { cat "$build/log" >&2; fail "$1 cannot be built"; }
}

# The program of a target, where it runs.
execute() {
    case "$run" in
    qemu-*)
        local prefix=${compiler%% *}
        "$run" -L "/usr/${prefix%-gcc}" "$@" ;;
    */ld-linux.so.2) "$run" --library-path "${run%/*}" "$@" ;;
    node) node --no-warnings tests/dist/run_wasi.mjs "$@" ;;
    *) "$run" "$@" ;;
    esac
}

# compare NAME COMMAND...: the list that the command writes with that of the tree
compare() {
    local name=$1 answers="$build/${1//[^A-Za-z0-9_]/-}.txt" seconds=$SECONDS
    shift
    "$@" >"$answers.all" 2>"$build/log" || { cat "$build/log" >&2; fail "$name: $*"; }
    tr -d '\r' <"$answers.all" | grep -v '^same_bits:' >"$answers" || fail "$name: no list"
    diff "$expected" "$answers" || fail "$name has other bits than $list (<)"
    echo "$name: the same bits ($((SECONDS - seconds)) s)"
}

# Sets `library` to that of a target, and builds it.
build_library() {
    library=${STAGE:+$STAGE/$1/lib/libasperity.a}
    if [ -z "$library" ] && [ "$1" = "$host" ]; then
        # As every other test builds it.
        cargo build --release --locked --quiet
        library=$target/release/libasperity.a
    elif [ -z "$library" ]; then
        cargo rustc --release --locked --quiet --lib --crate-type staticlib --target "$1" -- -D warnings
        library=$target/$1/release/libasperity.a
    fi
}

one() {
    local suffix="" name
    describe "$1"
    case "$1" in
    *windows*) suffix=.exe ;;
    wasm32*) suffix=.wasm ;;
    esac
    build_library "$1"
    name=$1$suffix
    compile "$name" tests/dist/same_bits.c
    if [ -n "$write" ]; then
        "$build/$name" | grep -v '^same_bits:' >"$list"
        echo "$list: $(tail -n 1 "$list")"
    fi
    compare "$1" execute "$build/$name" $step
    if [ "$1" = x86_64-unknown-linux-gnu ]; then
        compare "$1, AVX2" qemu-x86_64 -cpu Haswell "$build/$name" $step
        compare "$1, SSE" qemu-x86_64 -cpu Nehalem "$build/$name" $step
        # Without the vectors of this machine's processor, as on any other kind.
        compile "environments-$name" tests/c/environments.c
        environments "$1, SSE" qemu-x86_64 -cpu Nehalem "$build/environments-$name"
    fi
    [ "$1" != wasm32-unknown-unknown ] && [ -z "$step" ] || return 0
    compile "environments-$name" tests/c/environments.c
    environments "$1" execute "$build/environments-$name"
}

# environments NAME COMMAND...
environments() {
    local name=$1
    shift
    "$@" >"$build/log" 2>&1 || { tail -n 20 "$build/log" >&2; fail "$name: environments.c"; }
    echo "$name: the same bits in every environment of the host"
}

write="" step="" expected=$list
targets=()
mkdir -p "$build"
case "${1:-}" in
--write)
    [ $# -eq 1 ] || fail "--write takes no target"
    write=yes
    set -- "$host" ;;
"")
    step=$short_step expected=$build/expected.txt
    # The lines of every third surface, by their first 36 characters; not the sum of all.
    awk -v step=$step '/ numbers / { exit } substr($0, 1, 36) != name { name = substr($0, 1, 36); n++ } (n - 1) % step == 0' \
        "$list" >"$expected"
    set -- "$host"
    if [ "$host" = x86_64-unknown-linux-gnu ]; then
        set -- "$host" aarch64-unknown-linux-gnu x86_64-pc-windows-gnu
        # Compilers and emulators are installed while cargo builds.
        tests/setup.sh bits &
        installing=$!
        ! command -v rustup >/dev/null || rustup -q target add "$@"
        for name in "$@"; do
            # What is missing is named below.
            [ ! -d "$(rustc --print target-libdir --target "$name")" ] || build_library "$name"
        done
        wait "$installing"
    fi ;;
esac
for name in "$@"; do
    case "$name" in
    all) targets+=($all) ;;
    *) describe "$name"; targets+=("$name") ;;
    esac
done
command -v cargo >/dev/null || [ -n "${STAGE:-}" ] || fail "cargo is missing: https://rustup.rs"
for name in "${targets[@]}"; do check_tools "$name"; done
for name in "${targets[@]}"; do one "$name"; done
echo "$list: $(tail -n 1 "$list"), ${step:+every third surface }on ${#targets[@]} targets"
