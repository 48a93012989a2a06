# Read by the scripts of hosts, in the root of the tree; `fail MESSAGE` is theirs.
# shellcheck shell=bash
root=$PWD
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")

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
