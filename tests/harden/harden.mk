# make harden: every instrument of docs/dev/reliability.md at full length, hours on two cores; its parts have targets of their
# own. The short form of each is part of `make test-all`. Heavy runs go one after the other, at low priority.
#
# `tests/setup.sh harden` installs what they need.
#
#   make fuzz            10^7 calls of random bytes, with oracles         FUZZ_CALLS, FUZZ_SEED
#   make fuzz-coverage   libFuzzer with AddressSanitizer                  FUZZ_SECONDS; needs cargo-fuzz
#   make domain          20,000 surfaces against a second evaluation      DOMAIN_SETS
#   make memory          sanitizers, valgrind
#   make races           ThreadSanitizer in the Rust code                 needs a nightly Rust with rust-src
#   make miri            every C function in Miri, by two rules of aliasing,
#                        an hour for each on a slow processor          needs a nightly Rust with miri
#   make supply-chain    known faults of crates, licences, bans, sources   needs cargo-deny and the network
#   make oldest-rust     the Rust tests with the oldest compiler          needs rustup
#   make constants       each constant of the core moved by 4 %,       CONSTANTS (a regular expression of file:NAME)
#                        half an hour
#   make mutants         200 changes of the source, drawn at random:      MUTANTS (globs of files)
#                        which of them no test notices

FUZZ_CALLS ?= 10000000
FUZZ_SEED ?= 1
FUZZ_SECONDS ?= 1800
DOMAIN_SETS ?= 20000
MUTANTS ?=
CONSTANTS ?= .
LOW := nice -n 19
# Compilers of a toolchain with nightly options; a stable one takes them with RUSTC_BOOTSTRAP.
FUZZ_CARGO ?= RUSTC_BOOTSTRAP=1 $(CARGO)

NIGHTLY ?= cargo +nightly
OLDEST_RUST = $(shell sed -n 's/^rust-version = "\(.*\)"/\1/p' Cargo.toml)
HOST = $(shell rustc -vV | sed -n 's/^host: //p')
# Miri has the instructions of AVX2, and none that ask whether the processor has them. Its own arithmetic would otherwise
# have other last bits each time.
MIRI_PROCESSOR = $(if $(findstring x86_64,$(HOST)),-Ctarget-feature=+avx2$(COMMA)+bmi2)
MIRI_OPTIONS := -Zmiri-strict-provenance -Zmiri-deterministic-floats
COMMA := ,

.PHONY: harden fuzz fuzz-coverage domain memory races miri supply-chain oldest-rust constants mutants

harden:
	tests/setup.sh core hosts harden
	$(MAKE) --no-print-directory fuzz fuzz-coverage domain memory races miri supply-chain oldest-rust

fuzz:
	ASPERITY_FUZZ_CALLS=$(FUZZ_CALLS) ASPERITY_FUZZ_SEED=$(FUZZ_SEED) \
	    $(LOW) $(CARGO) test --release --locked --test c_api -- --nocapture fuzz::

fuzz-coverage:
	cd fuzz && CARGO_TARGET_DIR=$(TARGET)/fuzz $(FUZZ_CARGO) fuzz build calls
	cd fuzz && CARGO_TARGET_DIR=$(TARGET)/fuzz $(LOW) env $(FUZZ_CARGO) fuzz run calls -- \
	    -max_total_time=$(FUZZ_SECONDS) -max_len=4096 -len_control=0 -timeout=60 -print_final_stats=1

domain:
	mkdir -p $(TARGET)/domain
	ASPERITY_DOMAIN_SETS=$(DOMAIN_SETS) ASPERITY_DOMAIN_MAP=$(TARGET)/domain \
	    $(LOW) $(CARGO) test --release --locked --test numerics -- --nocapture domain::

memory:
	$(LOW) tests/harden/memory.sh long

races:
	CARGO_TARGET_DIR=$(TARGET)/races RUSTFLAGS=-Zsanitizer=thread $(LOW) $(NIGHTLY) test -Zbuild-std --target $(HOST) \
	    --profile mutants --locked --test c_api threads_that_share -- --skip programs::

miri:
	for aliasing in "" -Zmiri-tree-borrows; do \
	    CARGO_TARGET_DIR=$(TARGET)/miri RUSTFLAGS="$(MIRI_PROCESSOR)" MIRIFLAGS="$(MIRI_OPTIONS) $$aliasing" \
	        $(LOW) $(NIGHTLY) miri test --locked --test c_api contract:: || exit 1; \
	done

supply-chain:
	$(CARGO) deny --locked check advisories licenses bans sources
	tests/harden/supply_chain.sh

oldest-rust:
	rustup toolchain install $(OLDEST_RUST) --profile minimal
	CARGO_TARGET_DIR=$(TARGET)/oldest-rust $(LOW) cargo +$(OLDEST_RUST) test --profile mutants --locked

constants:
	$(LOW) python3 tests/harden/nudge_constants.py '$(CONSTANTS)'

mutants:
	$(LOW) tests/harden/mutants.py $(MUTANTS)
