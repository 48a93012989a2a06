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
# The page has the number that the library wants.
stops depvar "PROPERTIES=1 computes microslip and needs $(grep -o 'DEPVAR=[0-9]*' hosts/abaqus/README.md); it has 1"

# What users change, each once: words of the first surface file, the units of surfaces.f90, and whether the law is then the same.
habits="film||1e-3|1|same
m and Pa||1|1|same
um and uN||1e-6|1e-6|same
cm and kN||1e-2|1e3|same
mm and kN||1e-3|1e3|same
roughness of a profile|/^Sdq/d;s/^Sq = .*/Rq = 9.8e-9\nRdq = 0.0424264068711928/|1e-3|1|same
spectral moments|/^Sdq/d;s/^Sq = .*/m0 = 9.604e-17\nm2 = 1.8e-3/|1e-3|1|same
smoother|s/^Sq = .*/Sq = 6e-9/|1e-3|1|other
calibrated|1i calibration_load = 100\ncalibration_friction_coefficient = 0.2|1e-3|1|other
another adhesion|s/^work_of_adhesion.*/work_of_adhesion = 0.03/|1e-3|1|other
another area|s/^nominal_area.*/nominal_area = 2e-4/|1e-3|1|same"
#   analyses HOST FOLDER...     prints what each has
analyses() {
    local host=$build/$1/host folders=()
    shift
    for name in "$@"; do case $name in - | restart) folders+=("$name") ;; *) folders+=("$build/$name") ;; esac; done
    "$host" analyses "${folders[@]}" 2>"$build/analyses.txt" || { cat "$build/analyses.txt" >&2; fail "analyses $* end with status $?"; }
}
# like A B: whether the first surface has the same numbers in both, but for rounding; the other has in any case.
like() {
    paste "$1" "$2" | awk '{ for (k = 2; k <= 5; k++) if (!(($k - $(k + 5))^2 <= 1e-14 * $k^2)) off[$1] = 1 } END { exit off[2] ? 2 : off[1] + (NR != 2) }'
}
tried=0
while IFS='|' read -r name words length force expected; do
    folder=${name// /_} host=units_${length}_$force
    mkdir -p "$build/$folder/hosts/abaqus" "$build/$host"
    cp hosts/abaqus/smooth.toml "$build/$folder/hosts/abaqus"
    sed "$words" hosts/surface.toml >"$build/$folder/hosts/surface.toml"
    if [ ! -x "$build/$host/host" ]; then
        sed "s/UNIT_OF_LENGTH = 1e-3_c_double, UNIT_OF_FORCE = 1/UNIT_OF_LENGTH = ${length}_c_double, UNIT_OF_FORCE = ${force}_c_double/" \
            hosts/abaqus/surfaces.f90 >"$build/$host/surfaces.f90"
        make_host "$host" standard "$build/$host/surfaces.f90 ${standard#* } fric_coef_slip_data.f90" call_slip_data standard_host
    fi
    analyses "$host" "$folder" >"$build/$folder/alone.txt"
    found=0
    like "$build/film/alone.txt" "$build/$folder/alone.txt" || found=$?
    case $found$expected in 0same | 1other) ;; *) fail "habit '$name': the law must be $expected, and is not" ;; esac
    tried=$((tried + 1))
done <<<"$habits"
# Analyses in one process, ended, not ended and restarted: each has what it has in a process of its own.
in_turn="film smoother - calibrated - smoother restart film another_adhesion"
# shellcheck disable=SC2086
analyses slip_data $in_turn >"$build/in_turn.txt"
for name in $in_turn; do case $name in - | restart) ;; *) cat "$build/$name/alone.txt" ;; esac; done | cmp - "$build/in_turn.txt" ||
    fail "an analysis depends on the one before it in the process"
# Where the law does not hold for the pressures of surfaces.f90, a warning says so, and only there.
warned() { grep -q "^\*\*\*WARNING: asperity: surface $1: *${2:-}" "$build/analyses.txt"; }
sed 's/^hardness = .*/hardness = 5e9/' hosts/surface.toml >"$build/smoother/hosts/surface.toml"
analyses slip_data calibrated >"$build/told.txt"
! warned 1 && warned 2 "the strength of the interface" || fail "warnings of a calibrated surface are wrong"
analyses slip_data smoother >"$build/told.txt"
warned 1 "asperities yield" || fail "no warning of a soft surface"

# How Newton's method converges on the block: increments of stick, of slip, of reversal.
awk '$1 == "residual" && ($2 == 1 || $2 == 5 || $2 == 11 || $2 == 20) { row[$2] = row[$2] "  " $4; if (!seen[$2]++) order[++n] = $2 }
    END { for (i = 1; i <= n; i++) print "  residuals of the block, increment " order[i] ":" row[order[i]] }' \
    "$build/slip_data/measures.txt"

awk -v tried="$tried" -v started="$started" -v now="$(date +%s.%N)" '
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
               "before %.0f (limit %.0f), %d habits  %.1f s\n",
               worst["mu"], limit["mu"], worst["mu_single"], limit["mu_single"], worst["tangent"], limit["tangent"],
               iterations, worst["curve"], limit["curve"], block, worst["quadratic"], limit["quadratic"], tried, now - started
    }' "$build"/*/measures.txt
