# make demo      build the library, run the C example, draw its friction curve
# make test      everything that is checked before a release, in order
# make install   header, libraries and asperity.pc under $(DESTDIR)$(PREFIX)
# make header    write include/asperity.h anew from the sources
# make clean     remove what was built
#
# CARGO_TARGET_DIR is honoured; CC, CFLAGS, LDFLAGS, DESTDIR and PREFIX too.

SHELL := /bin/bash

CARGO_TARGET_DIR ?= target
export CARGO_TARGET_DIR
PREFIX ?= /usr/local
CARGO ?= cargo
INSTALL ?= install

TARGET := $(abspath $(CARGO_TARGET_DIR))
RELEASE := $(TARGET)/release
EXAMPLE := $(TARGET)/friction_curve
FIGURE := $(TARGET)/friction_curve.svg
VERSION := $(shell sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml)
SHARED := libasperity$(if $(filter Darwin,$(shell uname -s)),.dylib,.so)

WARNINGS := -std=c11 -Wall -Wextra -Wpedantic -Werror

# The scripts of `make test` that check other languages and hosts; each is run as it is, from the root.
TEST_SCRIPTS := tests/c/run.sh

.PHONY: all demo test install header clean library

all: library

library:
	$(CARGO) build --release --locked

demo: library
	$(CC) $(WARNINGS) $(CFLAGS) -Iinclude c_examples/friction_curve.c -o $(EXAMPLE) \
	    -L$(RELEASE) -Wl,-rpath,$(RELEASE) $(LDFLAGS) -lasperity -lm
	$(EXAMPLE) $(FIGURE)
	@echo "The friction curve is drawn in $(FIGURE)"

test:
	@echo "== tests/setup.sh core"; tests/setup.sh core
	@echo "== cargo fmt --check"; $(CARGO) fmt --check
	@echo "== cargo clippy"; $(CARGO) clippy --release --locked --all-targets -- -D warnings
	@echo "== cargo test"; $(CARGO) test --release --locked
	@set -e; for script in $(TEST_SCRIPTS); do echo "== $$script"; "$$script"; done
	@echo "== all tests passed"

install: library
	$(INSTALL) -d "$(DESTDIR)$(PREFIX)/include" "$(DESTDIR)$(PREFIX)/lib/pkgconfig"
	$(INSTALL) -m 644 include/asperity.h "$(DESTDIR)$(PREFIX)/include"
	$(INSTALL) -m 755 $(RELEASE)/$(SHARED) "$(DESTDIR)$(PREFIX)/lib"
	$(INSTALL) -m 644 $(RELEASE)/libasperity.a "$(DESTDIR)$(PREFIX)/lib"
	printf '%s\n' 'prefix=$(PREFIX)' 'includedir=$${prefix}/include' 'libdir=$${prefix}/lib' '' 'Name: asperity' \
	    'Description: Friction laws from contact physics' 'Version: $(VERSION)' 'Cflags: -I$${includedir}' \
	    'Libs: -L$${libdir} -lasperity' 'Libs.private: -lm -lpthread -ldl' \
	    > "$(DESTDIR)$(PREFIX)/lib/pkgconfig/asperity.pc"

header:
	ASPERITY_WRITE_HEADER=1 $(CARGO) test --locked --test header

clean:
	$(CARGO) clean
	rm -f $(EXAMPLE) $(FIGURE)
