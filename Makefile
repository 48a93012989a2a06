# make demo      build the library, run the C example, draw its friction curve
# make test      everything that is checked before a release, in order
# make hosts     the law inside other people's solvers
# make validate  against boundary elements, other people's code and measurements: docs/validation.md anew, an hour or two
# make bench     measures speed and accuracy, and writes docs/performance.md and its tables anew
# make core      what the numerical core costs: lines, constants, instructions, memory
# make harden    every instrument of docs/reliability.md, for hours; tests/harden/harden.mk names its parts
# make dist      the files of a release, in dist/: libraries for every platform, wheels, packages, sources; TARGETS="..." for a part
# make dist-test proves the files in dist/ as users get them
# make release   VERSION=x.y.z: checks that the tree is ready for a release, builds and proves it, and says what is left to do
# make site      the documentation as a searchable site in target/site/html, with the explorer
# make figures   draw the figures of the documents anew, in minutes
# make header    write include/asperity.h anew from the sources, and from it what other languages and the pages repeat
# make abi       write tests/abi/abi-1.h anew from the header, on purpose
# make clean     remove what was built
# make install   as cmake/install.mk says, under $(DESTDIR)$(PREFIX)
#
# CARGO_TARGET_DIR is honoured; CC, CFLAGS, LDFLAGS, DESTDIR and PREFIX too.

SHELL := /bin/bash

CARGO_TARGET_DIR ?= target
export CARGO_TARGET_DIR
CARGO ?= cargo

TARGET := $(abspath $(CARGO_TARGET_DIR))
RELEASE := $(TARGET)/release
EXAMPLE := $(TARGET)/friction_curve
FIGURE := $(TARGET)/friction_curve.svg

WARNINGS := -std=c11 -Wall -Wextra -Wpedantic -Werror

# The scripts of `make test` that check other languages and hosts; each is run as it is, from the root.
TEST_SCRIPTS := tests/cpp/called.sh tests/c/gpu.sh fortran/test.sh python/test.sh js/test.sh tests/validation/run.sh \
    tests/examples/run.sh tests/consumers/run.sh tests/build_checks.sh tests/harden/run.sh tests/harden/memory.sh \
    tests/harden/supply_chain.sh tests/dist/same_bits.sh tests/dist/refusals.sh

.PHONY: all demo test hosts site figures header abi clean library

all: library

include cmake/install.mk
include benches/bench.mk
include tests/harden/harden.mk
include tests/validation/validation.mk
include packaging/dist.mk

library:
	@cmake/check_rust.sh "$(CARGO)"
	$(CARGO) build --release --locked

demo: library
	$(CC) $(WARNINGS) $(CFLAGS) -Iinclude c_examples/friction_curve.c -o $(EXAMPLE) \
	    -L$(RELEASE) -Wl,-rpath,$(RELEASE) $(LDFLAGS) -lasperity -lm
	$(EXAMPLE) $(FIGURE)
	@echo "The friction curve is drawn in $(FIGURE)"

test:
	@cmake/check_rust.sh "$(CARGO)"
	@echo "== tests/setup.sh core validation"; tests/setup.sh core validation
	@echo "== cargo fmt --check"; $(CARGO) fmt --check
	@echo "== cargo clippy"; $(CARGO) clippy --release --locked --all-targets -- -D warnings
	@echo "== cargo test"; $(CARGO) test --release --locked
	@set -e; for script in $(TEST_SCRIPTS); do echo "== $$script"; "$$script"; done
	@$(MAKE) --no-print-directory hosts
	@echo "== all tests passed"

hosts:
	@echo "== tests/setup.sh hosts"; tests/setup.sh hosts
	@echo "== hosts/run.sh"; hosts/run.sh

site:
	docs/site/build.sh

# Two pictures are of measurements, which come with them: docs/performance.svg is drawn by make bench, docs/domain.svg by make
# domain.
figures: library
	python=$$(python/environment.sh)/bin/python && \
	    $$python -m asperity figures --out docs && \
	    $$python python/examples/sampling_bias.py docs/figures/sampling_bias.svg 24
	$(MAKE) --no-print-directory demo FIGURE=docs/friction_curve.svg
	hosts/ode/run.sh && cp $(TARGET)/hosts/ode/lag.svg docs/hosts-lag.svg

header:
	ASPERITY_WRITE_HEADER=1 $(CARGO) test --locked --test install header::committed
	python3 packaging/declarations

abi:
	ASPERITY_WRITE_ABI=1 $(CARGO) test --locked --test abi the_file_has

clean:
	$(CARGO) clean
	rm -f $(EXAMPLE) $(FIGURE)
