#!/usr/bin/env bash
# Not Adams, a mock host that calls the published interface: compiles Adams's contact friction subroutine with it and runs it;
# the last line says PASS or FAIL.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
compile mock/host hosts/adams/cffsub.c -Ihosts/adams/mock
verdict "$build/mock/host" "$build"
