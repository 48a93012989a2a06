#!/usr/bin/env bash
# What a user's build consists of: the lock file is whole and committed, the dependencies are those that docs/dev/reliability.md
# explains, no build script of theirs reaches the network, the stated oldest Rust is not newer than this one.
#
# usage: tests/harden/supply_chain.sh      (exported symbols: tests/consumers/run.sh)
set -euo pipefail
cd "$(dirname "$0")/../.."

fail() {
    echo "tests/harden/supply_chain.sh: $*" >&2
    exit 1
}

command -v cargo >/dev/null || fail "cargo is missing"
cargo metadata --locked --format-version 1 >/dev/null || fail "Cargo.lock is not that of Cargo.toml"
[ -z "$(git ls-files --others --exclude-standard Cargo.lock)" ] || fail "Cargo.lock is not committed"

# What is linked or runs during a user's build; named in the document.
dependencies=$(cargo tree --locked --edges normal,build --prefix none --format '{p}' | awk '{ print $1 }' | sort -u |
    grep -vx asperity)
for name in $dependencies; do
    grep -q "^| \`$name\` |" docs/dev/reliability.md || fail "$name is a dependency that docs/dev/reliability.md does not explain"
done
registry=${CARGO_HOME:-$HOME/.cargo}/registry/src
for package in $(cargo tree --locked --edges normal,build --prefix none --format '{p}' | awk 'NF > 1 { print $1 "-" substr($2, 2) }' | sort -u); do
    for script in "$registry"/*/"$package"/build.rs; do
        [ -e "$script" ] || continue
        ! grep -nE 'TcpStream|UdpSocket|reqwest|ureq|curl|https?_get|wget' "$script" ||
            fail "$package: its build script names the network"
    done
done
stated=$(sed -n 's/^rust-version = "\(.*\)"/\1/p' Cargo.toml)
here=$(rustc --version | awk '{ print $2 }')
[ "$(printf '%s\n' "$stated" "$here" | sort -V | head -1)" = "$stated" ] || fail "Rust $here is older than $stated"
echo "supply chain: $(wc -w <<<"$dependencies") crates beside ours in a user's build, all explained; Rust $stated or later"
