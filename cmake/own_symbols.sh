#!/bin/sh
# Makes of a static library of Rust one that links beside any other and by any linker. What it defines beside the functions of its
# header gets names of its own: every such library defines rust_eh_personality, and parts of the standard library. The bitcode that the
# standard library carries is left out: a linker that optimises reads it, and may be of another LLVM.
#
# usage: cmake/own_symbols.sh RUSTC FROM TO
#        needs nm and objcopy; LLVM's read the libraries of every system, and rustup has its objcopy
set -eu
rustc=$1 from=$2 to=$3
# Two installations may run at a time.
new=$to.$$.new names=$to.$$.names
sysroot=$("$rustc" --print sysroot)
host=$("$rustc" -vV | sed -n 's/^host: //p')
trap 'rm -f "$new" "$names"' EXIT

rust_objcopy() {
    LD_LIBRARY_PATH="$sysroot/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}" "$sysroot/lib/rustlib/$host/bin/rust-objcopy" "$@"
}

# Only the first pass shows nm all symbols: it takes a part with bitcode for one without.
# A line of `nm -P` is a name, a type and numbers; a capital that is not U is a symbol that others see.
rewrite() {
    "$1" --remove-section=.llvmbc --remove-section=.llvmcmd --remove-section=__LLVM,__bitcode --remove-section=__LLVM,__cmdline \
        "$from" "$new" || return
    for nm in llvm-nm nm; do
        "$nm" -gP "$new" | awk '$2 ~ /^[A-TV-Z]$/ && $1 !~ /^_?asperity_/ { print $1, "asperity_own_" $1 }' | sort -u >"$names"
        ! grep -q rust_eh_personality "$names" || break
    done
    "$1" --redefine-syms="$names" "$new" && grep -q rust_eh_personality "$names"
}

rewrite rust_objcopy 2>/dev/null || rewrite llvm-objcopy 2>/dev/null || rewrite objcopy 2>/dev/null || {
    echo "cmake/own_symbols.sh: no nm and objcopy here read $from: $to does not link beside another static library of Rust" >&2
    cp "$from" "$new"
}
# One that is the same keeps its date.
cmp -s "$new" "$to" || mv "$new" "$to"
