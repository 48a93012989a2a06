#!/usr/bin/env bash
# Builds the site in target/site/html: the guides, searchable, the references of C, Python and Rust, the explorer. Checks its links.
#
# usage: docs/site/build.sh      needs what tests/setup.sh web installs; fetches MkDocs from PyPI, at fixed versions
set -euo pipefail
cd "$(dirname "$0")/../.."

tests/setup.sh web
venv=target/site/venv
if ! cmp -s docs/site/requirements.txt "$venv/requirements.txt"; then
    "${PYTHON:-python3}" -m venv --clear "$venv"
    "$venv/bin/pip" install --quiet --disable-pip-version-check -r docs/site/requirements.txt
    cp docs/site/requirements.txt "$venv/requirements.txt"
fi

cargo build --release --locked --quiet
js/build.sh
"$venv/bin/python" docs/site/build.py target/site/pages
# Not --quiet, which hides warnings from --strict.
NO_MKDOCS_2_WARNING=1 "$venv/bin/mkdocs" build --strict --config-file docs/site/mkdocs.yml 2>&1 | sed '/^INFO /d' >&2
RUSTDOCFLAGS="-D warnings" cargo doc --release --locked --quiet --no-deps --lib
cp -r "${CARGO_TARGET_DIR:-target}/doc" target/site/html/rust
"$venv/bin/python" docs/site/check_links.py target/site/html
echo "The site is in target/site/html. To look at it, with its search: python3 -m http.server --directory target/site/html"
