#!/usr/bin/env bash
# Lines of src/ that the tests run: cargo test, the batch tests on processors with AVX2 and with SSE alone, and the C
# programs, on a build with counters.
#
# usage: tests/harden/coverage.sh      needs qemu-x86_64 (Debian: qemu-user), and llvm-profdata and llvm-cov no older than
# the LLVM of rustc (rustc -vV; Debian: llvm-22); LLVM_SUFFIX names the version, -22 by default
set -euo pipefail
cd "$(dirname "$0")/../.."

suffix=${LLVM_SUFFIX--22}
for tool in cargo gcc qemu-x86_64 "llvm-profdata$suffix" "llvm-cov$suffix"; do
    command -v "$tool" >/dev/null ||
        { echo "tests/harden/coverage.sh: $tool is missing: run tests/setup.sh harden" >&2; exit 1; }
done
# A folder of its own: the flags differ. With --target they do not reach build scripts.
CARGO_TARGET_DIR=$(realpath -m "${CARGO_TARGET_DIR:-target}")/coverage
export CARGO_TARGET_DIR
triple=$(rustc -vV | sed -n 's/^host: //p')
built=$CARGO_TARGET_DIR/$triple/release
profiles=$CARGO_TARGET_DIR/profiles
rm -rf "$profiles"
mkdir -p "$profiles"
export RUSTFLAGS="-C instrument-coverage" LLVM_PROFILE_FILE=$profiles/%m-%p.profraw
export CARGO_PROFILE_RELEASE_LTO=off CARGO_PROFILE_RELEASE_CODEGEN_UNITS=16
unset CARGO_ENCODED_RUSTFLAGS

# The shared library first: of functions with one name in several objects, the first object's counts.
objects=(-object "$built/libasperity.so")
while read -r program; do
    objects+=(-object "$program")
    case "$program" in */c_api-*) c_api=$program ;; esac
done < <(cargo test --release --locked --target "$triple" --no-run --message-format=json 2>/dev/null |
    sed -n 's/.*"executable":"\([^"]*\)".*/\1/p')
[ "${#objects[@]}" -gt 2 ] || { echo "tests/harden/coverage.sh: the tests do not build" >&2; exit 1; }
# With counters all is slower, and limits of time may be missed: what fails is said, and counts as run.
ASPERITY_DOMAIN_SETS=40 ASPERITY_FUZZ_CALLS=40000 \
    cargo test --release --locked --quiet --no-fail-fast --target "$triple" >"$CARGO_TARGET_DIR/tests.log" 2>&1 ||
    grep -E '^test .*FAILED|FAILED$' "$CARGO_TARGET_DIR/tests.log" || true
for cpu in Haswell Nehalem; do
    qemu-x86_64 -cpu "$cpu" "$c_api" --quiet batch::the_ >/dev/null 2>&1
done
cargo build --release --locked --quiet --target "$triple"
link=(-L"$built" -Wl,-rpath,"$built" -lasperity -lm -lpthread)
for program in contract threads eval; do
    gcc -O1 -Iinclude "tests/c/$program.c" -o "$CARGO_TARGET_DIR/$program" "${link[@]}"
    "$CARGO_TARGET_DIR/$program" >/dev/null
done

"llvm-profdata$suffix" merge -sparse "$profiles"/*.profraw -o "$CARGO_TARGET_DIR/all.profdata"
show=("llvm-cov$suffix")
sources=(-instr-profile="$CARGO_TARGET_DIR/all.profdata" "${objects[@]:1}" --sources src)
"${show[@]}" report "${sources[@]}" |
    awk 'BEGIN { print "file lines missed run" } /\.rs|TOTAL/ { print $1, $8, $9, $10 }' | column -t
echo "lines that no test runs:"
"${show[@]}" show "${sources[@]}" --show-instantiations=false |
    awk -F'|' '/^\/.*\.rs:$/ { file = $0; sub(/^.*\/src\//, "src/", file) } $2 ~ /^ *0$/ { print file $1 ":" $3 }' \
        >"$CARGO_TARGET_DIR/uncovered.txt"
cat "$CARGO_TARGET_DIR/uncovered.txt"
