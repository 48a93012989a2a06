#!/bin/sh
# Says in one line, before cargo says it in another way, that Rust is missing or too old. The version is that of
# Cargo.toml; cmake/cargo.cmake and python/setup.py say the same.
#
# usage: cmake/check_rust.sh [CARGO [RUSTC]]     the commands, `cargo` and `rustc` by default
set -u
needed=$(sed -n 's/^rust-version = "\(.*\)"/\1/p' "$(dirname "$0")/../Cargo.toml")

# "1.63" of what a command says of itself; nothing where there is no such command.
version_of() { "$@" --version 2>/dev/null | sed -n '1s/^[a-z]* \([0-9]*\.[0-9]*\).*/\1/p'; }

# CARGO may have words after it, as in "cargo +nightly".
# shellcheck disable=SC2086
for found in "$(version_of ${1:-cargo})" "$(version_of ${2:-${RUSTC:-rustc}})"; do
    if [ "${found%%.*}" -lt "${needed%%.*}" ] 2>/dev/null || [ -z "$found" ] ||
        { [ "${found%%.*}" -eq "${needed%%.*}" ] && [ "${found#*.}" -lt "${needed#*.}" ]; }; then
        echo "asperity needs Rust $needed or later (found ${found:-none}): https://rustup.rs" >&2
        exit 1
    fi
done
