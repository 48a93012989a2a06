#!/usr/bin/env bash
# Runs a command at the root of this tree in a new Debian 12, as root, with a Rust of this machine's rustup. CI systems run another
# Linux; in this one the files of a release are made. It is a folder that is entered: no container, so that tests may enter one too.
#
# usage: tests/in_debian.sh RUST COMMAND [ARGUMENT...]     the command is bash's, with the arguments as $1 and so on
#        RUST: a toolchain as rustup names it; `release`: that by which releases are built
#        needs rustup, and root or sudo on Debian or Ubuntu
set -euo pipefail
cd "$(dirname "$0")/.."
rust=$1
shift
[ "$rust" != release ] || rust=$(sed -n 's/^rust = "\([^"]*\)".*/\1/p' Cargo.toml)
sudo=$([ "$(id -u)" = 0 ] || echo sudo)

rustup toolchain install "$rust" --profile minimal --component clippy --component rustfmt
$sudo apt-get update -qq
$sudo apt-get install -y -qq --no-install-recommends debootstrap debian-archive-keyring >/dev/null
system=$(mktemp -d /var/tmp/debian.XXXXXX)
chmod 755 "$system"
trap '$sudo rm -rf --one-file-system "$system" "$system.log"' EXIT
# In mount name spaces of their own, both: what is mounted is gone with them, whatever ends them.
$sudo unshare -m --propagation private \
    debootstrap --variant=minbase --keyring=/usr/share/keyrings/debian-archive-keyring.gpg --force-check-gpg \
    --include=build-essential,ca-certificates,git bookworm "$system" >"$system.log" || { tail -n 20 "$system.log" >&2; exit 1; }

# Git reads a tree of another user, whose checkout it is, only if told to.
$sudo env SYSTEM="$system" TREE="$PWD" RUSTUP_HOME="${RUSTUP_HOME:-$HOME/.rustup}" CARGO_HOME="${CARGO_HOME:-$HOME/.cargo}" \
    RUSTUP_TOOLCHAIN="$rust" HOME=/root DEBIAN_FRONTEND=noninteractive \
    GIT_CONFIG_COUNT=1 GIT_CONFIG_KEY_0=safe.directory GIT_CONFIG_VALUE_0='*' \
    unshare -m --propagation private bash -euo pipefail -c '
        mount --bind "$SYSTEM" "$SYSTEM"
        for folder in "$TREE" "$RUSTUP_HOME" "$CARGO_HOME" /dev /proc /sys; do
            mkdir -p "$SYSTEM$folder"
            mount --rbind "$folder" "$SYSTEM$folder"
        done
        export PATH=$CARGO_HOME/bin:/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin
        # Not by chroot, in which the kernel makes no user its own name space.
        cd "$SYSTEM"
        pivot_root . mnt
        umount -l /mnt
        exec bash -euc "cd \"\$TREE\"; $1" "$@"
    ' bash "$@"
