#!/usr/bin/env bash
# Every way to build must say in one line that Rust is missing or too old; CMake must build for the machine of a cross
# compiler, or ask for it; tests/setup.sh must wait for the package manager's locks. Stand-ins on PATH play an old
# cargo, none, cross compilers, and an apt-get whose locks are held.
#
# usage: tests/build_checks.sh      needs make, cmake, cc, python3 with venv
set -euo pipefail
cd "$(dirname "$0")/.."
work=$(realpath -m "${CARGO_TARGET_DIR:-target}")/build-checks
rm -rf "$work"
mkdir -p "$work/bin" "$work/apt"
needed=$(sed -n 's/^rust-version = "\(.*\)"/\1/p' Cargo.toml)

fail() {
    echo "tests/build_checks.sh: $1" >&2
    exit 1
}

# cargo and rustc that say this version and do nothing else; without a version they are as if not there.
stand_in() {
    local tool
    for tool in cargo rustc; do
        if [ -n "$1" ]; then
            printf '#!/bin/sh\n[ "$1" = --version ] && echo "%s %s (stand-in)" && exit\necho "%s ran: $*"\nexit 1\n' \
                "$tool" "$1" "$tool" >"$work/bin/$tool"
        else
            printf '#!/bin/sh\nexit 127\n' >"$work/bin/$tool"
        fi
        chmod +x "$work/bin/$tool"
    done
}

# Runs a build that must fail and say the line: as the first of all that make and the hosts' scripts say.
says() {
    local where=$1 line="asperity needs Rust $needed or later (found $found): https://rustup.rs"
    shift
    if PATH="$work/bin:$PATH" CARGO_TARGET_DIR="$work/target" "$@" >"$work/log" 2>&1; then
        fail "succeeded with Rust $found: $*"
    fi
    if [ "$where" = first ]; then
        [ "$(head -n 1 "$work/log")" = "$line" ] || { cat "$work/log" >&2; fail "'$*' does not begin with: $line"; }
    else
        grep -qF "$line" "$work/log" || { cat "$work/log" >&2; fail "'$*' does not say: $line"; }
    fi
    if grep -q "ran: " "$work/log"; then fail "'$*' goes on after it"; fi
}

python3 -m venv "$work/venv"
for version in 1.63.0 ""; do
    stand_in "$version"
    found=${version%.0}
    found=${found:-none}
    for goal in all demo test install package; do says first make --no-print-directory "$goal"; done
    says first make --no-print-directory -f cmake/install.mk install
    says somewhere cmake -S . -B "$work/cmake-$found" -DASPERITY_CARGO="$work/bin/cargo" \
        -DASPERITY_RUSTC="$work/bin/rustc"
    says somewhere "$work/venv/bin/pip" install --disable-pip-version-check --no-deps ./python
    for host in hosts/*/run.sh; do says first "$host"; done
done
stand_in "$needed.0"
PATH="$work/bin:$PATH" cmake/check_rust.sh || fail "Rust $needed is refused"
stand_in 2.0.0
PATH="$work/bin:$PATH" cmake/check_rust.sh || fail "Rust 2.0 is refused"

# The Rust target that CMake takes for the machine of a compiler; what it says where it takes none.
target_for() {
    local compiler="$work/bin/cross-cc"
    printf '#!/bin/sh\n[ "$*" = -dumpmachine ] && echo %s && exit\nexec "%s" "$@"\n' "$1" "${CC:-cc}" >"$compiler"
    chmod +x "$compiler"
    rm -rf "$work/cross"
    env -u CARGO_BUILD_TARGET cmake -S . -B "$work/cross" -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_C_COMPILER="$compiler" \
        -DASPERITY_RUSTC="$work/bin/rustc" >"$work/log" 2>&1 || true
    sed -n 's/^ASPERITY_RUST_TARGET:STRING=//p' "$work/cross/CMakeCache.txt"
}
stand_in 2.0.0
for pair in x86_64-w64-mingw32=x86_64-pc-windows-gnu aarch64-linux-gnu=aarch64-unknown-linux-gnu \
    riscv64-linux-gnu=riscv64gc-unknown-linux-gnu x86_64-alpine-linux-musl=x86_64-unknown-linux-musl \
    arm-linux-gnueabihf=; do
    found=$(target_for "${pair%=*}")
    [ "$found" = "${pair#*=}" ] || fail "CMake takes '$found' for ${pair%=*}"
done
# CMake breaks its lines where they become long, which depends on the paths in them.
tr -s '\n ' ' ' <"$work/log" | grep -q "Set ASPERITY_RUST_TARGET" || fail "CMake does not ask for the target of a machine it does not know"

# An apt-get that has no lists at first, finds their lock held twice, and must be told to wait for that of dpkg.
cat >"$work/apt/apt-get" <<'END'
#!/bin/sh
echo "$*" >>"${0%/*}/calls"
case "$*" in
*update*)
    [ "$(grep -c update "${0%/*}/calls")" -gt 2 ] && exit 0
    echo "E: Could not get lock /var/lib/apt/lists/lock. It is held by process 1 (apt-get)"
    exit 100 ;;
*install*DPkg::Lock::Timeout=600*) [ "$(grep -c update "${0%/*}/calls")" -gt 2 ] ;;
*) exit 100 ;;
esac
END
printf '#!/bin/sh\nexit 1\n' >"$work/apt/dpkg-query"
printf '#!/bin/sh\necho 0\n' >"$work/apt/id"
chmod +x "$work"/apt/*
PATH="$work/apt:$PATH" tests/setup.sh core >/dev/null || fail "setup.sh does not wait for the package manager's locks"

echo "tests/build_checks.sh: an old Rust, none, cross compilers and held locks are met as they should be"
