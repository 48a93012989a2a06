#!/usr/bin/env bash
# Installs what the demo and the tests need beside cargo, a C compiler and make.
#
# usage: tests/setup.sh [core] [node] [ode] [hosts] [harden] [validation] [deny] [dist] [web]     (core when no group is named)
# As root on Debian or Ubuntu it installs what is missing; otherwise it prints the one command that would, and fails.
set -euo pipefail

core="g++ gfortran clang cmake pkg-config python3 python3-venv valgrind"
hosts="calculix-ccx libdeal.ii-dev libliggghts-dev libode-dev libsiconos-numerics-dev libsimbody-dev liggghts mpi-default-dev
    python3-dolfinx-real python3-getfem pkg-config yade python3-venv"
harden="valgrind"
# Node and npm may come from elsewhere than Debian, whose npm then does not go with them.
node=""
command -v node >/dev/null || node+=" nodejs"
command -v npm >/dev/null || node+=" npm"
web="chromium fonts-dejavu-core python3 python3-venv $node"
# Of crates.io, at the versions that were tried; fetched and built by cargo.
deny_tools="cargo-deny@0.20.2"
harden_tools="$deny_tools cargo-fuzz@0.13.2"

# What make dist and make dist-test need beside the tools that come from PyPI.
dist="cmake debhelper debootstrap dh-python dpkg-dev gfortran lintian llvm pkg-config python3 python3-venv xz-utils zstd"
dist_targets="x86_64-unknown-linux-gnu aarch64-unknown-linux-gnu x86_64-unknown-linux-musl x86_64-pc-windows-gnu
    aarch64-apple-darwin x86_64-apple-darwin wasm32-unknown-unknown"

# The compilers of other machines for tests/dist/same_answers.sh, and what runs their programs.
machines="qemu-user gcc-aarch64-linux-gnu libc6-dev-arm64-cross gcc-mingw-w64-x86-64-win32 wine64 musl-tools clang lld
    wasi-libc nodejs"

# Of PyPI, at the versions that were tried, in environments of their own under the target directory.
dist_packages="ziglang==0.17.1 cargo-zigbuild==0.24.0 build==1.6.1 setuptools==84.2.1 wheel==0.48.0 twine==7.0.0
    conan==2.34.0 py-rattler==0.28.0 check-jsonschema==0.39.0"
validation_packages="tamaas==2.9.0 Adhesion==0.93 mpmath>=1.3 matplotlib>=3.5 scipy>=1.9 pytest>=7"

groups=${*:-core} packages="" tools=""
for group in $groups; do
    case "$group" in
    core) packages+=" $core" ;;
    node) packages+=" $node" ;;
    ode) packages+=" libode-dev" ;;
    hosts) packages+=" $hosts" ;;
    harden) packages+=" $harden" tools+=" $harden_tools" ;;
    validation) packages+=" python3 python3-venv" ;;
    deny) tools+=" $deny_tools" ;;
    dist) packages+=" $dist $machines" ;;
    web) packages+=" $web" ;;
    *) echo "tests/setup.sh: unknown group '$group': core, node, ode, hosts, harden, validation, deny, dist or web" >&2; exit 2 ;;
    esac
done

for tool in $tools; do
    command -v "${tool%@*}" >/dev/null || cargo install --locked --quiet "$tool"
done

# Miri, and the sources from which it and a sanitizer build the standard library.
if [[ " $* " == *" harden "* ]] && command -v rustup >/dev/null; then
    rustup component add --toolchain nightly rust-src miri >/dev/null 2>&1 ||
        rustup toolchain install nightly --profile minimal --component rust-src,miri
fi

if [[ " $* " == *" dist "* ]] && command -v rustup >/dev/null; then
    # shellcheck disable=SC2086
    rustup -q target add $dist_targets
    rustup -q component add rust-src
fi

# target GROUP NAME: Rust's standard library for a target, where the group is asked for.
target() {
    [[ " $groups " == *" $1 "* ]] && command -v rustup >/dev/null || return 0
    rustup target list --installed | grep -qx "$2" || rustup target add "$2"
}
target node wasm32-unknown-unknown
target web wasm32-unknown-unknown

# environment GROUP PACKAGES: a virtual environment with the packages, where the group is asked for.
environment() {
    [[ " $groups " == *" $1 "* ]] || return 0
    local venv="${CARGO_TARGET_DIR:-target}/$1-venv"
    # The list of packages stands in it once they are installed.
    [ "$(cat "$venv/packages" 2>/dev/null)" = "$2" ] && return 0
    echo "installing in $venv:" $2
    mkdir -p "$(dirname "$venv")"
    "${PYTHON:-python3}" -m venv --clear "$venv"
    # shellcheck disable=SC2086
    "$venv/bin/pip" install --quiet --disable-pip-version-check $2
    echo "$2" >"$venv/packages"
}
environments() {
    environment validation "$validation_packages"
    environment dist "$dist_packages"
}

if ! command -v dpkg-query >/dev/null; then
    echo "tests/setup.sh: not a Debian system; install the equivalents of:$packages" >&2
    exit 1
fi
missing=""
for package in $packages; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=" $package"
done
[ -n "$missing" ] || { environments; exit 0; }

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
environments
