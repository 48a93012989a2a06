# make demo      build the library, run the C example, draw its friction curve
# make quick     after each change of the sources: form, unit tests, header, interface
# make test      Rust, C, C++, Fortran, Python, JavaScript and one host, in minutes
# make test-all  that, and everything else that is checked before a release
# make hosts     the law inside other people's solvers
# make validate  against boundary elements, other people's code and measurements: docs/validation.md anew, two hours or so
# make bench     measures speed, and writes docs/dev/performance.md anew
# make core      what the numerical core costs: lines, constants, instructions, memory
# make harden    every instrument of docs/dev/reliability.md, for hours; tests/harden/harden.mk names its parts
# make dist      the files of a release, in dist/: libraries for every platform, wheels, packages, sources; TARGETS="..." for a part
# make dist-test proves the files in dist/ as users get them
# make release   VERSION=x.y.z: checks that the tree is ready for a release, builds and proves it, and says what is left to do
# make site      the documentation as a searchable site in target/site/html, with the explorer
# make figures   draw the figures of the documents anew, in minutes
# make header    write include/asperity.h anew from the sources, and from it what other languages and the pages repeat
# make pages     write into the pages what their programs print now, after a change that is to change answers
# make abi       write tests/abi/abi-1.h anew from the header, on purpose
# make clean     remove what was built
# make install   as cmake/install.mk says, under $(DESTDIR)$(PREFIX); make uninstall takes it away
#
# CARGO_TARGET_DIR is honoured; CC, CFLAGS, LDFLAGS, DESTDIR and PREFIX too.

SHELL := /bin/bash

CARGO_TARGET_DIR ?= target
export CARGO_TARGET_DIR
CARGO ?= cargo

TARGET := $(if $(filter /%,$(firstword $(CARGO_TARGET_DIR))),,$(CURDIR)/)$(CARGO_TARGET_DIR)
RELEASE := $(TARGET)/release
EXAMPLE := $(TARGET)/friction_curve
FIGURE := $(TARGET)/friction_curve.svg

WARNINGS := -std=c11 -Wall -Wextra -Wpedantic -Werror

# What `make test` does, and what `make test-all` does after it, in order; each command is run as it is, from the root.
QUICK_TARGETS := --lib --test layout --test install --test abi --test c_api
define QUICK_TESTS
tests/setup.sh core node ode
$(CARGO) fmt --check
$(CARGO) test --release --locked $(QUICK_TARGETS)
fortran/test.sh
python/test.sh --quick
js/test.sh --quick
hosts/run.sh ode
endef
define OTHER_TESTS
tests/setup.sh core validation
$(CARGO) clippy --release --locked --all-targets -- -D warnings
$(CARGO) test --release --locked --test law --test numerics --test physics
$(CARGO) test --release --locked --doc
tests/cpp/called.sh
tests/c/gpu.sh
python/test.sh
js/test.sh
tests/validation/run.sh
tests/examples/run.sh
tests/consumers/run.sh
docs/site/build.sh
tests/build_checks.sh
tests/harden/run.sh
tests/harden/memory.sh
tests/harden/supply_chain.sh
tests/harden/mutants.py --check
packaging/size.py
tests/dist/same_answers.sh
tests/dist/refusals.sh
tests/setup.sh hosts
hosts/run.sh
endef
export QUICK_TESTS OTHER_TESTS

.PHONY: all demo quick test test-all hosts site figures header pages abi clean library

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
	$(CC) $(WARNINGS) $(CFLAGS) -Iinclude c_examples/friction_curve.c -o "$(EXAMPLE)" \
	    -L"$(RELEASE)" -Wl,-rpath,"$(RELEASE)" $(LDFLAGS) -lasperity -lm
	"$(EXAMPLE)" "$(FIGURE)"
	@echo "The friction curve is drawn in $(FIGURE)"

# Built without link-time optimisation and bit by bit, so that only what changed is compiled.
quick:
	$(CARGO) fmt --check
	$(CARGO) test --profile mutants --locked --no-fail-fast --lib --test layout --test abi
	$(CARGO) test --profile mutants --locked --test install header::

test:
	@cmake/check_rust.sh "$(CARGO)"
	@tests/each.sh "make test" "$$QUICK_TESTS"

test-all: test
	@tests/each.sh "the rest of make test-all" "$$OTHER_TESTS"

hosts:
	@echo "== tests/setup.sh hosts"; tests/setup.sh hosts
	@echo "== hosts/run.sh"; hosts/run.sh

site:
	docs/site/build.sh

figures: library
	python=$$(python/environment.sh)/bin/python && \
	    $$python docs/gallery
	$(MAKE) --no-print-directory demo FIGURE=docs/friction_curve.svg
	hosts/ode/run.sh && cp $(TARGET)/hosts/ode/lag.svg docs/hosts-lag.svg
	hosts/changes/run.sh && cp $(TARGET)/hosts/changes/changes-*.svg docs/figures/

header:
	ASPERITY_WRITE_HEADER=1 $(CARGO) test --locked --test install header::committed
	python3 packaging/declarations

pages: export ASPERITY_WRITE_PAGES := 1
pages:
	$(CARGO) build --release --locked
	$(CARGO) test --release --locked --test install readme
	python/test.sh tests/test_docs.py tests/test_guides.py tests/test_surface_file.py tests/test_export.py
	js/test.sh --quick
	tests/consumers/run.sh

abi:
	ASPERITY_WRITE_ABI=1 $(CARGO) test --locked --test abi the_file_has

clean:
	$(CARGO) clean
	rm -f "$(EXAMPLE)" "$(FIGURE)"
