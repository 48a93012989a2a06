#!/usr/bin/env bash
# Compiles the Abaqus user subroutines with gfortran and drives them from mock hosts that call the published argument
# lists. Abaqus itself is not run. Builds in target/abaqus (or under CARGO_TARGET_DIR).
#
# usage: hosts/abaqus/run.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
started=$(date +%s.%N)

cmake/check_rust.sh
command -v gfortran >/dev/null ||
    { echo "hosts/abaqus/run.sh: gfortran is missing: run tests/setup.sh core" >&2; exit 1; }

mkdir -p "${CARGO_TARGET_DIR:-target}"
target=$(cd "${CARGO_TARGET_DIR:-target}" && pwd)
build=$target/abaqus
here=$PWD/hosts/abaqus
rm -rf "$build"
cargo build --release -j1 --locked --quiet
export LD_LIBRARY_PATH="$target/release${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
export OMP_NUM_THREADS=4

# The argument lists are the host's: most arguments are not for us, and the mock calls them without an interface.
flags="-std=f2008 -ffree-form -Wall -Wextra -Werror -Wno-unused-dummy-argument -Wno-unused-parameter -g -O1 -fopenmp
    -fcheck=bounds -ffpe-trap=invalid,zero,overflow"

# Joins the files of a solver into the one that it wants, as the page says, and compiles it with its mock host.
#   make NAME MOCK_INCLUDES "USER FILES" MOCK FILES...
make_host() {
    local name=$1 includes=$here/mock/$2 files=$3
    shift 3
    local dir=$build/$name
    mkdir -p "$dir"
    # shellcheck disable=SC2086
    (cd "$here" && { echo '!DIR$ FREEFORM'; cat ../../fortran/asperity.f90 $files; }) >"$dir/user.for"
    # shellcheck disable=SC2086
    (cd "$dir" && gfortran $flags -I"$includes" -c user.for && for file in measures "$@"; do
        gfortran $flags -I"$includes" -c "$here/mock/$file.f90"
    done && gfortran -fopenmp ./*.o -L"$target/release" -lasperity -o host)
}
fail() {
    echo "abaqus  FAIL  $*" >&2
    exit 1
}
standard="surfaces.f90 models.f90 standard.f90 fric.f90"
explicit="surfaces.f90 models.f90 explicit.f90 vfric_coef.f90"
make_host slip_rate standard "$standard fric_coef_slip_rate.f90" call_slip_rate standard_host
make_host slip_data standard "$standard fric_coef_slip_data.f90" call_slip_data standard_host
make_host explicit_single single "$explicit" explicit_host
make_host explicit_double double "$explicit" explicit_host

# The commands of the page make the same file.
awk '$0 == "```sh" {inside = 1; next} /^```/ {inside = 0} inside' hosts/abaqus/README.md |
    sed "s#> user.for#> $build/page.for#" | bash -euo pipefail
cmp "$build/page.for" "$build/slip_data/user.for"

for host in slip_rate slip_data explicit_single explicit_double; do
    "$build/$host/host" >"$build/$host/measures.txt" || { echo "abaqus  FAIL  $host" >&2; exit 1; }
done

# What must stop the analysis does, and says why.
#   stops PROVOKED MESSAGE [FOLDER]     FOLDER with other surface files in it
stops() {
    local status=0
    (cd "${3:-.}" && "$build/slip_data/host" "$1") >/dev/null 2>"$build/stops.txt" || status=$?
    if [ "$status" != 7 ] || ! grep -q "^\*\*\*ERROR: asperity: .*$2" "$build/stops.txt"; then
        echo "abaqus  FAIL  '$1' must stop the analysis with: $2" >&2
        cat "$build/stops.txt" >&2
        exit 1
    fi
}
stops unmade 'no model was made: call make_models'
stops surface 'the first property of \*FRICTION is 3.*1 to 2'
stops stiffness 'the stick stiffness, must be > 0'
surfaces=$build/surfaces
mkdir -p "$surfaces/hosts/abaqus"
stops surface 'surface 1: hosts/surface.toml: No such file' "$surfaces"
sed 's/hardness/hardnes/' hosts/surface.toml >"$surfaces/hosts/surface.toml"
stops surface 'surface 1: hosts/surface.toml: line 10: hardnes: no such key; the nearest is hardness' "$surfaces"
{ printf 'calibration_load = 100\ncalibration_friction_coefficient = 0.2\n'; grep -v nominal_area hosts/abaqus/smooth.toml; } \
    >"$surfaces/hosts/surface.toml"
stops surface 'surface 1: hosts/surface.toml: nominal_area must be given' "$surfaces"
stops depvar 'PROPERTIES=1 computes microslip and needs DEPVAR=.*; it has 1'

# Files, units and analyses are altered: each analysis gives what it gives in a process of its own.
for name in film smoother calibrated; do mkdir -p "$build/$name/hosts/abaqus"; cp hosts/abaqus/smooth.toml "$build/$name/hosts/abaqus"; done
cp hosts/surface.toml "$build/film/hosts"
sed 's/^Sq = .*/Sq = 6e-9/' hosts/surface.toml >"$build/smoother/hosts/surface.toml"
{ printf 'calibration_load = 100\ncalibration_friction_coefficient = 0.2\n'; cat hosts/surface.toml; } >"$build/calibrated/hosts/surface.toml"
mkdir -p "$build/si_source"
sed 's/UNIT_OF_LENGTH = 1e-3_c_double/UNIT_OF_LENGTH = 1/' hosts/abaqus/surfaces.f90 >"$build/si_source/surfaces.f90"
make_host si standard "$build/si_source/surfaces.f90 ${standard#* } fric_coef_slip_data.f90" call_slip_data standard_host
#   analyses HOST FOLDER...     prints what each has
analyses() {
    local host=$build/$1/host folders=()
    shift
    for name in "$@"; do [ "$name" = - ] && folders+=(-) || folders+=("$build/$name"); done
    "$host" analyses "${folders[@]}" 2>"$build/analyses.txt" || { cat "$build/analyses.txt" >&2; fail "analyses $* end with status $?"; }
}
in_turn="film smoother - calibrated - smoother film"
# shellcheck disable=SC2086
analyses slip_data $in_turn >"$build/in_turn.txt"
for name in ${in_turn//-/}; do analyses slip_data "$name"; done >"$build/alone.txt"
cmp "$build/in_turn.txt" "$build/alone.txt" || fail "an analysis depends on the one before it in the process"
[ "$(sort -u "$build/alone.txt" | wc -l)" = 4 ] || fail "another surface file makes no difference, or in the other surface does"
analyses si film smoother >"$build/si.txt"
analyses slip_data film smoother | paste - "$build/si.txt" | awk '
    { for (k = 2; k <= 4; k++) if (!(($k - $(k + 4))^2 <= 1e-18 * $k^2)) exit wrong = 1 } END { exit wrong || NR != 4 }' ||
    fail "the law depends on the units of the model"
# Where the law does not hold for the pressures of surfaces.f90, a warning says so, and only there.
warned() { grep -q "^\*\*\*WARNING: asperity: surface $1: *${2:-}" "$build/analyses.txt"; }
sed 's/^hardness = .*/hardness = 5e9/' hosts/surface.toml >"$build/smoother/hosts/surface.toml"
analyses slip_data calibrated >"$build/told.txt"
! warned 1 && warned 2 "the strength of the interface" || fail "warnings of a calibrated surface are wrong"
analyses slip_data smoother >"$build/told.txt"
warned 1 "summits yield" || fail "no warning of a soft surface"

# How Newton's method converges on the block: increments of stick, of slip, of reversal.
awk '$1 == "residual" && ($2 == 1 || $2 == 5 || $2 == 11 || $2 == 20) { row[$2] = row[$2] "  " $4; if (!seen[$2]++) order[++n] = $2 }
    END { for (i = 1; i <= n; i++) print "  residuals of the block, increment " order[i] ":" row[order[i]] }' \
    "$build/slip_data/measures.txt"

awk -v started="$started" -v now="$(date +%s.%N)" '
    # What is not a number fails: awk takes it for 0.
    NF == 3 && !($2 ~ /^[0-9][-+.E0-9]*$/ && $2 + 0 <= $3 + 0) { wrong = wrong " " $1 " = " $2 " (limit " $3 ")" }
    function keep(name) { if ($2 + 0 > worst[name]) worst[name] = $2 + 0; limit[name] = $3; seen[name]++ }
    $1 == "mu" || $1 == "tangent" || $1 == "mu_single" || $1 == "curve" || $1 == "quadratic" { keep($1) }
    $1 == "iterations" && $2 > iterations { iterations = $2 }
    $1 == "block_iterations" && $2 > block { block = $2 }
    END {
        if (seen["mu"] < 7 || seen["tangent"] < 8 || seen["mu_single"] != 1 || seen["curve"] != 2 || seen["quadratic"] != 2) {
            print "abaqus  FAIL  measures are missing"
            exit 1
        }
        if (wrong != "") {
            print "abaqus  FAIL " wrong
            exit 1
        }
        printf "abaqus  PASS  max |t/p - mu(p)|/mu = %.0e (limit %.0e), in single precision %.0e (limit %.0e), " \
               "tangent vs differences %.0e (limit %.0e), Newton %d iterations (limit 7); microslip within %.3f F of the " \
               "curve (limit %.2f), on a block Newton %d iterations (limit 11), residual over the square of the one " \
               "before %.0f (limit %.0f)  %.1f s\n",
               worst["mu"], limit["mu"], worst["mu_single"], limit["mu_single"], worst["tangent"], limit["tangent"],
               iterations, worst["curve"], limit["curve"], block, worst["quadratic"], limit["quadratic"], now - started
    }' "$build"/*/measures.txt
