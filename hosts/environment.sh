# Read by the run.sh of each host, which is then in the root of the tree. The last line of a host is HOST  PASS or FAIL, and what
# was found.
# shellcheck shell=bash
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
host=$(basename "$(dirname "$(realpath "$0")")")
build=$target/hosts/$host
mkdir -p "$build"

fail() {
    echo "$host  FAIL  $*"
    exit 1
}

library() {
    cmake/check_rust.sh && cargo build --quiet --release --locked -j1 || fail "the library does not build"
}

# packages HOST PACKAGE...: an environment with these packages of PyPI, kept for as long as they are the same; $environment
# is where. None of them is compiled here, which may take half an hour.
packages() {
    environment=$target/$1-venv
    shift
    [ "$(cat "$environment/packages" 2>/dev/null)" != "$*" ] || return 0
    # Two thirds of the time that an environment takes to make are for its pip: one serves all, and the hosts take turns.
    (flock 9 && { [ -x "$target/pip-venv/bin/pip" ] || python3 -m venv "$target/pip-venv"; }) 9>"$target/pip-venv.lock" &&
        python3 -m venv --clear --without-pip "$environment" ||
        fail "no virtual environment: apt-get install python3-venv"
    "$target/pip-venv/bin/pip" --python "$environment/bin/python" install --quiet --no-compile --disable-pip-version-check --only-binary :all: "$@" ||
        fail "pip cannot install $* for $(python3 --version)"
    echo "$*" >"$environment/packages"
}

# verdict COMMAND...: a program that ends with 0 or 1 has given its verdict.
verdict() {
    local status=0
    "$@" || status=$?
    [ "$status" -le 1 ] || fail "$* ended with status $status"
    [ "$status" -eq 0 ] || exit 1
}

# run PYTHON PROGRAM [ARGUMENT...]: the verdict of a program with the asperity package of this tree.
run() {
    PYTHONPATH=$root/python/src ASPERITY_LIBRARY=$target/release/libasperity.so PYTHONPYCACHEPREFIX=$target/pycache verdict "$@"
}

# example PROGRAM PACKAGE...: the verdict of a program of this host, with packages of PyPI.
example() {
    local program=$1
    shift
    packages "$host" "$@"
    run "$environment/bin/python" "hosts/$host/$program"
}

# compile PROGRAM FLAG...: builds hosts/HOST/PROGRAM.c or .cpp against the library.
compile() {
    local program=$1 source compiler=(gcc -std=c11)
    shift
    source=$(echo "hosts/$host/$program".c*)
    mkdir -p "$(dirname "$build/$program")"
    [ "${source##*.}" = c ] || compiler=(g++ -std=c++17)
    "${compiler[@]}" -O2 -Wall -Wextra -Werror -Iinclude "$source" -o "$build/$program" -L"$target/release" -lasperity \
        -Wl,-rpath,"$target/release" "$@" -lm || fail "$source does not build"
}

library
