#!/usr/bin/env bash
# Not Chrono, which no registry has: a mock of its headers calls the adapter. The last line says PASS or FAIL.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
for version in 9 10; do
    compile mock/host -DMOCK_VERSION=$version -Ihosts/chrono -Ihosts/chrono/mock
    verdict "$build/mock/host"
done
