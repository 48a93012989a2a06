#!/usr/bin/env bash
# What make dist and make release refuse: each must be named, and dist/ must be as it was before. In a copy of the commit, whose
# dist/ holds one file.
#
# usage: tests/dist/refusals.sh            needs git, make and python3; seconds
#        tests/dist/refusals.sh building   a build that fails on the way too, and the workflows against GitHub's schema;
#                                          after tests/setup.sh dist
set -euo pipefail
cd "$(dirname "$0")/../.."
. tests/dist/shared.sh
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
copy=$target/dist-refusals
rm -rf "$copy" "$copy.log"
copy_commit "$copy"
cd "$copy"
git config user.name tests
git config user.email tests@localhost
export CARGO_TARGET_DIR=$copy/target
mkdir dist
echo "of an earlier run" >dist/file

# refuses TEXT COMMAND...: the command fails, says the text in one line, and leaves dist/ alone.
refuses() {
    local text=$1
    shift
    if "$@" >"$copy.log" 2>&1; then fail "accepted: $*"; fi
    grep -qF -- "$text" "$copy.log" || { cat "$copy.log" >&2; fail "'$*' does not say: $text"; }
    if grep -q Traceback "$copy.log"; then cat "$copy.log" >&2; fail "'$*' ends with a traceback"; fi
    [ "$(cat dist/*)" = "of an earlier run" ] || fail "'$*' changed dist/"
}

version=$(version_of_tree)

refuses "no target 'x86-linux'; there are x86_64-linux-gnu, " make dist TARGETS="x86_64-linux-gnu x86-linux"

echo >>README.md
refuses "the tree differs from the commit (M README.md, 1 in all)" make dist TARGETS=x86_64-linux-gnu
refuses "the tree differs from the commit" python3 packaging/release.py "$version"
git checkout --quiet README.md

# Without the tools: of PyPI, in the target directory of this copy; of a linker, on a PATH that lacks it.
refuses "missing: cargo-zigbuild, " make dist TARGETS=aarch64-linux-gnu
mkdir -p "$copy/target/bin"
for tool in cargo git rustc; do ln -s "$(command -v $tool)" "$copy/target/bin/$tool"; done
python=$(python3 -c 'import sys; print(sys.executable)')
refuses "x86_64-w64-mingw32-gcc" env PATH="$copy/target/bin" "$python" packaging/dist.py x86_64-windows
refuses "tests/setup.sh dist installs them" env PATH="$copy/target/bin" "$python" packaging/dist.py x86_64-windows

rm "$copy/target/bin/rustc"
refuses "missing: rustc, " env PATH="$copy/target/bin" "$python" packaging/dist.py x86_64-windows

refuses "say which: make release VERSION=x.y.z" make release
refuses "'next' is no version" make release VERSION=next
refuses "Cargo.toml has $version, not 9.9.9" make release VERSION=9.9.9
refuses "CHANGELOG.md has no heading" make release VERSION="$version"
# After a release the interface may grow, and in no other way change.
git tag v0.0.1
sed -i "s/^## $version, not released/## $version (2000-01-01)/" CHANGELOG.md
sed -i 's|^} asperity_state;|  double another; /* 232, 8 */\n&|; $i void asperity_another(void);' tests/abi/abi-1.h
git commit --quiet --all --message "the interface grows"
python3 packaging/release.py --check "$version" >/dev/null || fail "make release refuses a field at the end and another function"
abi="tests/abi/abi-1.h has changed since v0.0.1, and may only grow:"
# Another compiler than that of releases.
printf '#!/bin/sh\necho rustc 1.0.0\n' >"$copy/target/bin/rustc"
chmod +x "$copy/target/bin/rustc"
refuses "and this is 1.0.0: RUSTUP_TOOLCHAIN=" env PATH="$copy/target/bin:$PATH" make release VERSION="$version"
sed -i '/ weibull_shape;/d' tests/abi/abi-1.h
git commit --quiet --all --message "a field goes"
refuses "$abi asperity_params" make release VERSION="$version"
sed -i '/asperity_version(/d' tests/abi/abi-1.h
git commit --quiet --all --message "a function goes"
refuses "$abi const char *asperity_version(void);" make release VERSION="$version"
git reset --quiet --hard v0.0.1
git tag --delete v0.0.1 >/dev/null

# One place that was forgotten.
sed -i "s/^version: $version/version: 0.0.9/" CITATION.cff
git commit --quiet --all --message "one version differs"
refuses "CITATION.cff has 0.0.9, not $version" make release VERSION="$version"

case "${1:-}" in
"") ;;
building)
    git reset --quiet --hard HEAD~
    sed -i '$a compile_error!("stop");' src/lib.rs
    git commit --quiet --all --message "does not compile"
    ln -s "$target/dist-venv" "$copy/target/dist-venv"
    refuses "failed: make -f cmake/install.mk" make dist TARGETS=x86_64-linux-gnu
    "$target/dist-venv/bin/check-jsonschema" --builtin-schema vendor.github-workflows .github/workflows/*.yml >/dev/null ||
        fail "a workflow does not follow GitHub's schema"
    ;;
*) fail "unknown word '$1': building, or none" ;;
esac
rm -rf "$copy" "$copy.log"
echo "tests/dist/refusals.sh: what make dist and make release cannot do they name, and leave dist/ as it was"
