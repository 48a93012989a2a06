#!/usr/bin/env bash
# Installs what the demo and the tests need beside cargo, a C compiler and make.
#
# usage: tests/setup.sh [core] [hosts] [harden] [validation]     (core when no group is named)
# As root on Debian or Ubuntu it installs what is missing; otherwise it prints the one command that would, and fails.
set -euo pipefail

core="g++ gfortran clang cmake pkg-config python3 python3-venv libgsl-dev valgrind"
hosts="libode-dev libsiconos-numerics-dev libsimbody-dev python3-getfem python3-matplotlib pkg-config
    python3-venv"
harden="valgrind qemu-user gcc-aarch64-linux-gnu libc6-dev-arm64-cross llvm-22"
# Of crates.io, at the versions that were tried; fetched and built by cargo.
harden_tools="cargo-deny@0.20.2 cargo-fuzz@0.13.2 cargo-mutants@27.1.0"

# Of PyPI, at the versions that were tried, in an environment of their own under the target directory.
validation_packages="tamaas==2.9.0 Adhesion==0.93 mpmath>=1.3 matplotlib>=3.5 scipy>=1.9 pytest>=7"

packages="" tools=""
for group in "${@:-core}"; do
    case "$group" in
    core) packages+=" $core" ;;
    hosts) packages+=" $hosts" ;;
    harden) packages+=" $harden" tools+=" $harden_tools" ;;
    validation) packages+=" python3 python3-venv" ;;
    *) echo "tests/setup.sh: unknown group '$group': core, hosts, harden or validation" >&2; exit 2 ;;
    esac
done

for tool in $tools; do
    command -v "${tool%@*}" >/dev/null || cargo install --locked --quiet "$tool"
done

# Miri, and the sources from which it and a sanitizer build the standard library.
if [[ " $* " == *" harden "* ]] && command -v rustup >/dev/null; then
    rustup component add --toolchain nightly rust-src miri >/dev/null 2>&1 ||
        rustup toolchain install nightly --profile minimal --component rust-src,miri
    # For 64-bit ARM, which qemu-user emulates.
    rustup target add aarch64-unknown-linux-gnu >/dev/null 2>&1
fi

groups=" $* "
validation_environment() {
    [[ "$groups" == *" validation "* ]] || return 0
    local venv="${CARGO_TARGET_DIR:-target}/validation-venv"
    # The list of packages stands in it once they are installed.
    [ "$(cat "$venv/packages" 2>/dev/null)" = "$validation_packages" ] && return 0
    echo "installing in $venv: $validation_packages"
    mkdir -p "$(dirname "$venv")"
    "${PYTHON:-python3}" -m venv --clear "$venv"
    # shellcheck disable=SC2086
    "$venv/bin/pip" install --quiet --disable-pip-version-check $validation_packages
    echo "$validation_packages" >"$venv/packages"
}

if ! command -v dpkg-query >/dev/null; then
    echo "tests/setup.sh: not a Debian system; install the equivalents of:$packages" >&2
    exit 1
fi
missing=""
for package in $packages; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=" $package"
done
[ -n "$missing" ] || { validation_environment; exit 0; }

if [ "$(id -u)" != 0 ]; then
    echo "Some packages that the tests need are missing. Install them with:" >&2
    echo "    sudo apt-get install -y --no-install-recommends$missing" >&2
    exit 1
fi
echo "installing:$missing"
export DEBIAN_FRONTEND=noninteractive LC_ALL=C
# Another process may hold the package manager's locks, as the one that updates a new machine does. `install` waits for
# them if told to; `update` has a lock of its own, for which it never waits.
update_lists() {
    local message
    until message=$(apt-get update -qq 2>&1); do
        [[ "$message" == *"Could not get lock"* && $SECONDS -lt 600 ]] || { echo "$message" >&2; return 1; }
        sleep 2
    done
}
install_missing() {
    # shellcheck disable=SC2086
    apt-get install -y -qq --no-install-recommends -o DPkg::Lock::Timeout=600 $missing >/dev/null
}
install_missing 2>/dev/null || { update_lists && install_missing; }
validation_environment
