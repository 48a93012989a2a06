#!/usr/bin/env bash
# Builds the library and checks the Fortran module: against the C header, against mechanics, under valgrind, and
# against the C example. Run from anywhere; builds in target/fortran (or under CARGO_TARGET_DIR).
#
# usage: fortran/test.sh
set -euo pipefail
cd "$(dirname "$0")/.."
started=$SECONDS

for tool in cargo cc gfortran nm python3 valgrind; do
    command -v "$tool" >/dev/null || { echo "fortran/test.sh: $tool is missing: run tests/setup.sh core" >&2; exit 1; }
done

mkdir -p "${CARGO_TARGET_DIR:-target}"
target=$(cd "${CARGO_TARGET_DIR:-target}" && pwd)
build=$target/fortran
rm -rf "$build"
mkdir -p "$build"
cargo build --release -j1 --locked --quiet
export LD_LIBRARY_PATH="$target/release${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"

strict="-std=f2008 -Wall -Wextra -Werror"
traps="-g -fcheck=all,no-array-temps -ffpe-trap=invalid,zero,overflow"
link="-L$target/release -lasperity"

# shellcheck disable=SC2086
compile() { gfortran $strict $traps -J"$build" -I"$build" "$@"; }

compile -c fortran/asperity.f90 -o "$build/asperity.o"
compile -c fortran/tests/checking.f90 -o "$build/checking.o"
for test in smoke c_interface friction_law stops; do
    compile -c "fortran/tests/$test.f90" -o "$build/$test.o"
    # shellcheck disable=SC2086
    compile "$build/$test.o" "$build/asperity.o" "$build/checking.o" $link -o "$build/$test"
done

# The first part of the module is written from the header, with sizes that a C compiler must find too.
awk '/^  type, bind\(c\), public ::/ {name = $NF}
     / :: struct_size = [1-9]/ {printf "_Static_assert(sizeof(%s) == %d, \"%s\");\n", name, $5, name}' \
    fortran/asperity.f90 >"$build/sizes.c"
cc -std=c11 -fsyntax-only -Iinclude -include asperity.h "$build/sizes.c"
echo "sizes agree: $(grep -c . "$build/sizes.c") of them"

# Every function is called by a test, in C's form or in the module's.
nm -u "$build/smoke.o" "$build/c_interface.o" | sed -E 's/^ *U (__asperity_MOD_)?//' | sort -u >"$build/called.txt"
grep -oE '\basperity_[a-z_]+\(' include/asperity.h | tr -d '(' | sort -u >"$build/declared.txt"
if comm -23 "$build/declared.txt" "$build/called.txt" | grep .; then
    echo "FAIL: fortran/tests calls these functions of asperity.h nowhere" >&2
    exit 1
fi

"$build/smoke"
"$build/c_interface"
"$build/friction_law"

# Leaks, double frees, uninitialised values.
valgrind -q --leak-check=full --errors-for-leak-kinds=definite,indirect,possible \
    --error-exitcode=1 "$build/friction_law" >"$build/valgrind.txt" 2>&1 || { cat "$build/valgrind.txt" >&2; exit 1; }
echo "valgrind: no leak, no invalid access"

# Without stat= an error stops the program: message and exit status.
stops() {
    local status=0
    "$build/stops" "$1" >"$build/stops.out" 2>"$build/stops.err" || status=$?
    if [ "$status" != 1 ] || [ -s "$build/stops.out" ] || [ "$(cat "$build/stops.err")" != "asperity: $2" ]; then
        echo "FAIL: $1: exit status $status, not 1, or another message than '$2':" >&2
        cat "$build/stops.out" "$build/stops.err" >&2
        exit 1
    fi
}
stops parameter 'summit_radius = 0: must be finite and > 0'
stops forgotten "asperity_count: must be set; a roughness with a nominal_area sets it: Ra or Rq with RSm or a process, \
Sq with Sdq, m0 with m2"
stops never_created "friction_model: no model here: call create on this variable first; a bitwise copy, as \
allocate(source=) makes, has none"
stops load 'element 2: load = inf: must be finite'
stops heavy 'element 3: load = 1e300: must be below 1e80 composite_modulus burgers_vector^2 asperity_count'
stops scalar 'element 1: load = -inf: must be finite'
stops shape 'friction_model: slope must have the shape of load'
stops status 'length = -5: must be finite and > 0'
echo "errors without stat= stop the program: 8 ways"

# The page: its program is the example, its commands run as they stand and print what it says.
block() { awk -v kind="\`\`\`$1" '$0 == kind {inside = 1; next} /^```/ {inside = 0} inside' docs/fortran.md; }
diff <(block fortran) fortran/examples/minimal.f90
block sh | sed "s#target/#$target/#g" >"$build/page.sh"
bash -euo pipefail "$build/page.sh" >"$build/page.txt"
diff <(block text) "$build/page.txt"
# shellcheck disable=SC2086
compile fortran/examples/minimal.f90 "$build/asperity.o" "$target/release/libasperity.a" -lpthread -ldl -lm \
    -o "$build/minimal_static"
"$build/minimal_static" | diff "$build/page.txt" -
echo "docs/fortran.md: its $(grep -c . "$build/page.sh") lines of commands print what it says"

# The starting points: one program, which prints for each surface file of two pages what stands below it.
awk -v out="$build/start" '
    /^```/ { kind = kind == "" ? substr($0, 4) : ""
             if (kind == "toml") file = out "-" ++n ".toml"
             if (kind == "text") file = out "-" n (texts[n]++ ? "-more" : "") ".txt"
             if (kind == "fortran") file = out ".f90"
             next }
    kind ~ /^(toml|text|fortran)$/ { print >file }' docs/start.md docs/device-or-bead.md
# shellcheck disable=SC2086
compile "$build/start.f90" "$build/asperity.o" $link -o "$build/start"
for surface in "$build"/start-[1-4].toml; do
    answer=${surface%toml}txt
    "$build/start" "$surface" "$(sed -n 's/^mu(\([^ ]*\) N).*/\1/p' "$answer")" >"$build/answer.txt"
    # A page may have the first lines alone, and `...`.
    diff <(sed '/^\.\.\.$/d' "$answer") <(head -n "$(grep -vcx '\.\.\.' "$answer")" "$build/answer.txt")
done
refuses() {
    local said status=0
    said=$("$build/start" "$1" "$2" 2>&1) || status=$?
    [ "$status" = 1 ] && [[ "$said" =~ ^asperity:\ [^$'\n']*"$3"$ ]] || { echo "FAIL: start $1 $2: status $status, $said" >&2; exit 1; }
}
refuses "$build/start-1.toml" ten 'usage: friction SURFACE LOAD'
refuses "$build/start-1.toml" '' 'usage: friction SURFACE LOAD'
refuses "$build/none.toml" 10 'No such file or directory'
refuses "$build/start-1.toml" 0,5 'usage: friction SURFACE LOAD'
echo "docs/start.md: the program in Fortran prints what stands below each surface"

echo "fortran  PASS  $((SECONDS - started)) s"
