#!/usr/bin/env bash
# Compiles the contact friction subroutine of Adams with a mock host that calls the published interface, and runs it. Adams
# itself is not run. The last line says PASS or FAIL.
set -euo pipefail
cd "$(dirname "$0")/../.."

fail() {
    echo "adams  FAIL  $*"
    exit 1
}
# shellcheck source=hosts/environment.sh
. hosts/environment.sh
library
build=$target/hosts/adams
mkdir -p "$build"
"${CC:-cc}" -std=c11 -O2 -Wall -Wextra -Werror -Iinclude -Ihosts/adams/mock hosts/adams/cffsub.c hosts/adams/mock/host.c \
    -o "$build/host" -L"$target/release" -lasperity -Wl,-rpath,"$target/release" -lm || fail "cffsub.c does not build"
verdict "$build/host" "$build"
