#!/usr/bin/env bash
# Builds and runs an arm on a belt (is a lagged force stable?), then the box on an incline; the last line says PASS or FAIL. The figure of the
# arm is left in target/hosts/ode/lag.svg.
# shellcheck source=hosts/environment.sh
. "$(dirname "$0")/../environment.sh"
pkg-config --exists ode || fail "ODE is missing: apt-get install libode-dev pkg-config"
for program in arm incline; do
    # shellcheck disable=SC2046
    compile "$program" hosts/ode/law_step.c $(pkg-config --cflags ode | sed 's/-I/-isystem /g') $(pkg-config --libs ode)
done
verdict "$build/arm" "$build/lag.svg"
verdict "$build/incline"
