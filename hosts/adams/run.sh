#!/usr/bin/env bash
# Compiles the contact friction subroutine of Adams with a mock host that calls the published interface, and runs it. Adams
# itself is not run. The last line says PASS or FAIL.
set -euo pipefail
cd "$(dirname "$0")/../.."
target=${CARGO_TARGET_DIR:-target}
build=$target/hosts/adams

fail() {
    echo "adams  FAIL  $*"
    exit 1
}
cmake/check_rust.sh || fail "the library does not build"
cargo build --quiet --release --locked -j1 || fail "the library does not build"
library=$(realpath "$target/release")
mkdir -p "$build"
"${CC:-cc}" -std=c11 -O2 -Wall -Wextra -Werror -Iinclude -Ihosts/adams/mock hosts/adams/cffsub.c hosts/adams/mock/host.c \
    -o "$build/host" -L"$library" -lasperity -Wl,-rpath,"$library" -lm || fail "cffsub.c does not build"
status=0
"$build/host" || status=$?
[ "$status" -le 1 ] || fail "the mock host ended with status $status"
exit "$status"
