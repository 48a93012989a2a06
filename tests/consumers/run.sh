#!/usr/bin/env bash
# Installs asperity into a temporary folder, by make and by CMake, checks what was installed, and builds and runs the
# projects beside this script against it: each uses the library as one kind of user does.
#
# usage: tests/consumers/run.sh      needs cargo, cc, c++, clang++, make, cmake, pkg-config, readelf, nm, git, python3
set -euo pipefail
cd "$(dirname "$0")/../.."

for tool in cargo cc c++ clang++ make cmake pkg-config readelf nm git python3; do
    command -v "$tool" >/dev/null ||
        { echo "tests/consumers/run.sh: $tool is missing; run tests/setup.sh core" >&2; exit 1; }
done
root=$PWD
CARGO_TARGET_DIR=$(realpath -m "${CARGO_TARGET_DIR:-target}")
export CARGO_TARGET_DIR
work=$CARGO_TARGET_DIR/tests-consumers
rm -rf "$work"
mkdir -p "$work"
unset LD_LIBRARY_PATH

fail() {
    echo "tests/consumers/run.sh: $1" >&2
    exit 1
}

# Runs a command quietly; shows its output if it fails.
quietly() {
    "$@" >"$work/log" 2>&1 || { cat "$work/log" >&2; fail "failed: $*"; }
}

# ---- Installation ----
changes=$(git status --porcelain)
quietly make -f cmake/install.mk install DESTDIR="$work/by-make" PREFIX=/opt/asperity
quietly cmake -S . -B "$work/cmake" -DCMAKE_INSTALL_PREFIX=/opt/asperity
quietly cmake --build "$work/cmake"
DESTDIR=$work/by-cmake quietly cmake --install "$work/cmake"
diff -r --no-dereference "$work/by-make" "$work/by-cmake" || fail "make and CMake install different files"
[ "$(git status --porcelain)" = "$changes" ] || fail "installing changed the source tree"
echo "make and CMake install the same $(find "$work/by-make" -type f | wc -l) files"

tests/consumers/spaces.sh "$work/with spaces"

# Everything from here on uses a copy elsewhere, as nothing may depend on the folder it was installed for.
prefix=$work/elsewhere
mv "$work/by-make/opt/asperity" "$prefix"
export PKG_CONFIG_PATH=$prefix/lib/pkgconfig CMAKE_PREFIX_PATH=$prefix

# ---- Names and versions ----
library=$prefix/lib/libasperity.so
version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml)
IFS=. read -r major minor _ <<<"$version"
soname=libasperity.so.$major
grep -qx "#define ASPERITY_VERSION \"$version\"" "$prefix/include/asperity.h" || fail "the header is not of $version"
[ "$(pkg-config --modversion asperity)" = "$version" ] || fail "asperity.pc is not of version $version"
[ "$(readlink "$library")" = "libasperity.so.$version" ] || fail "libasperity.so does not lead to version $version"
readelf -d "$library" | grep -qF "soname: [$soname]" || fail "wrong soname"
[ -f "$(pkg-config --variable=fortran_source asperity)" ] || fail "asperity.pc names no Fortran source"

grep -oE '\basperity_[a-z_]+\(' "$prefix/include/asperity.h" | tr -d '(' | sort -u >"$work/declared"
nm -D --defined-only "$library" | awk '{ print $3 }' | sort >"$work/exported"
diff "$work/declared" "$work/exported" || fail "the library exports other names than its header declares"
echo "soname $soname; exactly the $(wc -l <"$work/exported") functions of the header are exported"
# What the static library defines has its names, so that it links beside others.
nm -g --defined-only "$prefix/lib/libasperity.a" | awk 'NF == 3 && $3 !~ /^asperity_own_/ { print $3 }' | sort >"$work/defined"
diff "$work/declared" "$work/defined" || fail "the static library defines names that others may define too"
if readelf -SW "$prefix/lib/libasperity.a" | grep -F .llvmbc; then fail "the static library has bitcode, for linkers of one LLVM alone"; fi
# Those of the system have other last bits on another processor or system.
nm -D --undefined-only "$library" | awk '{ sub(/@.*/, "", $2); print $2 }' | sort >"$work/imported"
grep -xE 'a?(sin|cos|tan)h?|atan2|sincos|exp(2|10|m1)?|log(2|10|1p)?|pow|cbrt|hypot|fma|[lt]gamma(_r)?|erfc?' "$work/imported" &&
    fail "the library takes these functions from the system; take them from src/numerics/elementary.rs"
echo "its elementary functions are its own"

# ---- Projects ----
needs_library() {
    readelf -d "$1" | grep -q "(NEEDED).*\[$soname\]"
}

with_make() {
    mkdir -p "$work/$1"
    quietly make -C "tests/consumers/$1" BUILD="$work/$1"
}

with_cmake() {
    local project=$1
    shift
    quietly cmake -S "tests/consumers/$project" -B "$work/$project" "$@"
    quietly cmake --build "$work/$project"
}

# A host may trap floating-point exceptions. The programs are written as users write them, and know nothing of that.
cc -shared -fPIC -x c tests/c/traps_on.h -o "$work/traps_on.so" -lm
echo 'int main(void) { volatile double zero = 0; return !(1 / zero > 0); }' | cc -x c - -o "$work/divides"
"$work/divides" || fail "a division by zero ends a program that traps nothing"
if { LD_PRELOAD=$work/traps_on.so "$work/divides"; } 2>/dev/null; then fail "the traps are not on"; fi

# check PROJECT shared|static [PROGRAM [ARGUMENT]]: the program runs, traps on, and needs the shared library or does not.
check() {
    local name=${3:-consumer}
    local program=$work/$1/$name
    if needs_library "$program"; then
        [ "$2" = shared ] || fail "$1/$name needs the shared library"
    else
        [ "$2" = static ] || fail "$1/$name does not need the shared library"
    fi
    LD_PRELOAD=$work/traps_on.so "$program" ${4:+"$4"} || fail "$1/$name failed"
    echo "$1/$name: passed"
}

with_make pkg-config
check pkg-config shared
with_make pkg-config-static
check pkg-config-static static
with_make static-library
check static-library static
with_make two-rust-libraries
check two-rust-libraries static
check two-rust-libraries static optimised
with_make dlopen
check dlopen static consumer "$library"
with_cmake find-package-shared -DASPERITY_WANTED="$major.$minor"
check find-package-shared shared
with_cmake find-package-static
check find-package-static static
with_cmake cpp
check cpp shared
with_cmake add-subdirectory -DASPERITY_SOURCE="$root"
check add-subdirectory shared
check add-subdirectory static consumer_static
# What the page and this consumer fetch is there: the branch main, or a version that CHANGELOG.md calls released.
for ref in $(grep -oh 'GIT_TAG [^ )]*' docs/install.md tests/consumers/fetch-content/CMakeLists.txt | cut -d' ' -f2); do
    [ "$ref" = main ] || grep -qE "^## ${ref#v}( \\(|\$)" CHANGELOG.md ||
        { echo "tests/consumers/run.sh: GIT_TAG $ref: no such version is released" >&2; exit 1; }
done
with_cmake fetch-content -DFETCHCONTENT_SOURCE_DIR_ASPERITY="$root"
check fetch-content shared

# ---- Documentation ----
# follow PAGE: does what the page says, in a copy of the source tree and with a home of its own. All pages share the two.
follow() {
    local folder=$work/guides
    mkdir -p "$folder/source" "$folder/home"
    git ls-files -z --cached --others --exclude-standard | xargs -0 cp --parents -t "$folder/source"
    CARGO_HOME=${CARGO_HOME:-$HOME/.cargo} RUSTUP_HOME=${RUSTUP_HOME:-$HOME/.rustup} HOME=$folder/home \
        env -u PKG_CONFIG_PATH -u CMAKE_PREFIX_PATH python3 tests/consumers/follow_docs.py "$1" "$folder/source"
}

follow docs/install.md
follow docs/c.md
follow docs/cpp.md
with_make modelica
check modelica static

# ---- Refusals ----
for wanted in "$major.$((minor + 1))" "$((major + 1)).0" "$major.$minor.99;EXACT"; do
    if cmake -S tests/consumers/find-package-shared -B "$work/refused" -DASPERITY_WANTED="$wanted" \
        >"$work/log" 2>&1; then
        fail "find_package(asperity $wanted) accepts version $version"
    fi
    grep -qF "version: $version" "$work/log" ||
        { cat "$work/log" >&2; fail "find_package(asperity $wanted) failed for another reason"; }
    rm -rf "$work/refused"
done
echo "find_package refuses versions that are not there"
