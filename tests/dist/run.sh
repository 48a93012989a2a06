#!/usr/bin/env bash
# Proves the files in dist/ as users get them: unpacks, installs, builds against, runs. What make dist was not told to
# build is not proved; the last line says how much was. The first run makes a Debian system to install packages in and
# builds Rust's standard library once more, which takes some minutes; both are kept under the target directory.
#
# usage: tests/dist/run.sh      after make dist; needs what tests/setup.sh dist installs, and root for the Debian system
set -euo pipefail
cd "$(dirname "$0")/../.."
. tests/dist/shared.sh
root=$PWD
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
all=$target/dist/test
venv=$target/dist-venv
version=$(version_of_tree)

# passed FILE WHAT: tells what was proved of a file.
passed() {
    echo "$(basename "$1"): $2 ($((SECONDS - since)) s)" | tee -a "$all/proved"
    since=$SECONDS
}

[ -f dist/SHA256SUMS ] || fail "there is nothing in dist/: run make dist"
rm -rf "$all"
mkdir -p "$all"
(cd dist && sha256sum --quiet -c SHA256SUMS) || fail "files in dist/ are not those that make dist built"

# A wheel's library, loaded by a C program of its platform, alone.
load_wheel() {
    local wheel=$1 compiler=$2 runner=$3 folder=$work/$2
    rm -rf "$folder"
    mkdir -p "$folder"
    python3 -m zipfile -e "$wheel" "$folder"
    quietly "$compiler" -std=c11 -Iinclude tests/consumers/dlopen/main.c -o "$folder/consumer" -pthread -ldl
    # shellcheck disable=SC2086
    quietly $runner "$folder/consumer" "$folder/asperity/libasperity.so"
    passed "$wheel" "its library, loaded and unloaded by a C program of that platform"
}

# Uses the files of dist/.
use_files() {
    local work=$all/files since=$SECONDS
    mkdir "$work"

    # ---- Archives: unpacked as installations, by Rust's names of the targets ----
    prefixes=$work/prefixes
    mkdir -p "$prefixes"
    while read -r name rust _ ending _; do
        archive=dist/asperity-$version-$name.$ending
        [ -f "$archive" ] || continue
        if [ "$ending" = zip ]; then python3 -m zipfile -e "$archive" "$work"; else tar -xf "$archive" -C "$work"; fi
        mv "$work/asperity-$version-$name" "$prefixes/$rust"
    done < <(grep -v '^#' packaging/targets.txt)

    # Symbols of the C library that are later than 2.17 would keep a library from old systems. musl's have no version.
    for rust in x86_64-unknown-linux-gnu aarch64-unknown-linux-gnu x86_64-unknown-linux-musl; do
        [ -d "$prefixes/$rust" ] || continue
        objdump -T "$prefixes/$rust/lib/libasperity.so" >"$work/symbols" || fail "$rust: objdump cannot read the library"
        grep -q 'asperity_create$' "$work/symbols" || fail "$rust: the library has no asperity_create"
        newest=$( (echo GLIBC_2.17; sed -n 's/.*\(GLIBC_[0-9.]*\).*/\1/p' "$work/symbols") | sort -V | tail -n 1)
        [ "$newest" = GLIBC_2.17 ] || fail "$rust: the library needs $newest"
    done
    if [ -d "$prefixes/x86_64-unknown-linux-gnu" ]; then
        said=$(tests/dist/installed.sh "$work/installed" "$prefixes/x86_64-unknown-linux-gnu")
        passed "x86_64-linux-gnu" "$said; needs glibc 2.17 or older"
    fi
    if [ -d "$prefixes/x86_64-unknown-linux-musl" ]; then
        musl=$prefixes/x86_64-unknown-linux-musl
        quietly musl-gcc -std=c11 -I"$musl/include" tests/consumers/greenwood_williamson.c -o "$work/musl" -L"$musl/lib" -lasperity \
            -Wl,-rpath,"$musl/lib"
        quietly "$work/musl"
        passed "x86_64-linux-musl" "a C program with the shared library"
    fi
    for rust in aarch64-apple-darwin x86_64-apple-darwin; do
        if [ -d "$prefixes/$rust" ]; then
            said=$(python3 tests/dist/macos.py "$prefixes/$rust")
            passed "$rust" "$said"
        fi
    done
    if [ -d "$prefixes/x86_64-pc-windows-gnu" ]; then
        tests/dist/windows.sh "$work/windows" "$prefixes/x86_64-pc-windows-gnu"
        passed "x86_64-windows" "a CMake project, linked by MinGW and by an import library for Microsoft's linker, run in Wine"
    fi

    # ---- The same answers from all of them ----
    mapfile -t run_here < <(cd "$prefixes" && ls -d -- *linux* *windows* *wasm32* 2>/dev/null)
    if [ "${#run_here[@]}" != 0 ]; then
        STAGE=$prefixes tests/dist/same_answers.sh "${run_here[@]}"
        passed "the archives" "the same answers to 1e-12 on ${#run_here[@]} targets"
    fi

    # ---- Wheels ----
    mapfile -t wheels < <(ls dist/*.whl 2>/dev/null)
    if [ "${#wheels[@]}" != 0 ]; then
        quietly "$venv/bin/twine" check --strict "${wheels[@]}"
        passed "${#wheels[@]} wheels" "twine check"
    fi
    for wheel in "${wheels[@]}"; do
        case "$wheel" in
        *manylinux*x86_64*)
            python3 -m venv "$work/wheel"
            quietly "$work/wheel/bin/pip" install --disable-pip-version-check "$wheel"
            said=$(cd / && "$work/wheel/bin/python" "$root/tests/dist/python_check.py" "$version")
            passed "$wheel" "in a new virtual environment: $said"
            windows=${wheel/manylinux*/win_amd64.whl}
            if [ -f "$windows" ]; then
                said=$(tests/dist/fmu.sh "$work/fmu" "$work/wheel/bin/python" "$windows")
                passed "$windows" "$said"
            fi ;;
        *manylinux*aarch64*) load_wheel "$wheel" aarch64-linux-gnu-gcc "qemu-aarch64 -L /usr/aarch64-linux-gnu" ;;
        *musllinux* | *macosx* | *win*)
            "$venv/bin/python" tests/dist/same_library.py "$wheel" "$prefixes"
            passed "$wheel" "has the library of the archive" ;;
        esac
    done

    # ---- Packages ----
    if ls dist/*.deb >/dev/null 2>&1; then
        quietly lintian --allow-root --fail-on error,warning dist/*.deb
        tests/dist/debian.sh "$target/dist/bookworm"
        passed "$(cd dist && echo *.deb)" "lintian; amd64 installed in a Debian 12 without Rust, used from C, C++, Fortran and Python"
        said=$(tests/dist/debian_arm64.sh "$work/arm64")
        passed "$(cd dist && echo *_arm64.deb)" "$said"
    fi
    for package in dist/*.conda; do
        [ -f "$package" ] || continue
        said=$("$venv/bin/python" tests/dist/conda_check.py "$package" "$work/conda-$(basename "$package")")
        passed "$package" "$said"
    done

    # ---- Sources, without a network ----
    if [ -f "dist/asperity-$version-source.tar.xz" ]; then
        # -m: with the date of now, so that cargo takes no earlier build for newer.
        tar -xmf "dist/asperity-$version-source.tar.xz" -C "$work"
        CARGO_HOME=$work/no-crates quietly unshare -r -n make -C "$work/asperity-$version-source" \
            CARGO_TARGET_DIR="$target/dist/test-source" install PREFIX="$work/from-source"
        said=$(tests/dist/installed.sh "$work/from-source-installed" "$work/from-source")
        passed "asperity-$version-source.tar.xz" "built without a network; $said"
    fi
    if [ -f "dist/asperity-$version.tar.gz" ]; then
        python3 -m venv "$work/sdist"
        quietly env CARGO_TARGET_DIR="$target/dist/test-sdist" "$work/sdist/bin/pip" install --disable-pip-version-check \
            "dist/asperity-$version.tar.gz"
        said=$(cd / && "$work/sdist/bin/python" "$root/tests/dist/python_check.py" "$version")
        passed "asperity-$version.tar.gz" "installed by pip: $said"
    fi
}

# Builds from the checkout.
build_again() {
    local work=$all/again since=$SECONDS
    mkdir "$work"

    # ---- The same bytes from a second build ----
    again=()
    [ ! -f "dist/asperity-$version-x86_64-linux-gnu.tar.xz" ] || again+=(x86_64-linux-gnu)
    [ ! -f "dist/asperity-$version-source.tar.xz" ] || again+=(sources)
    [ ! -f "dist/asperity-$version.crate" ] || again+=(crate)
    ! ls dist/*.deb >/dev/null 2>&1 || again+=(debian)
    if [ "${#again[@]}" != 0 ]; then
        said=$(tests/dist/reproducible.sh "$target/dist/again" "${again[@]}")
        passed "${again[*]}" "$said"
    fi

    tests/dist/refusals.sh building
    passed "make dist, make release" "what they cannot do they name; workflows follow GitHub's schema"

    CONAN_HOME=$target/dist/conan tests/dist/conan.sh "$work/conan" "$venv/bin/conan"
    passed packaging/conan "conan create builds from source, and the test package runs"
}

# The two at a time: most steps keep one processor busy.
use_files &
files=$!
build_again &
builds=$!
failed=
wait "$files" || failed=yes
wait "$builds" || failed=yes
[ -z "$failed" ] || fail "not everything was proved; see above"
proved=$(wc -l <"$all/proved")
echo "tests/dist/run.sh: $proved proofs passed, 0 failed, in $SECONDS s"
