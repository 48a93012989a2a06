# make bench: measures speed and accuracy, and rewrites docs/dev/performance.md with its picture.
# Needs libgsl-dev and valgrind (tests/setup.sh). A missed limit is shown in the document; it is no failure.

bench_target := $(abspath $(or $(CARGO_TARGET_DIR),target))
bench_program := $(bench_target)/bench/solver_speed

.PHONY: bench
bench:
	cargo build --release
	mkdir -p $(bench_target)/bench
	$(CXX) -std=c++17 -O2 -Wall -Wextra -Iinclude benches/solver_speed.cpp -o $(bench_program) \
	    -L$(bench_target)/release -Wl,-rpath,$(bench_target)/release -lasperity -lgsl -lgslcblas -lm -pthread
	CXX="$(CXX)" benches/report.sh $(bench_program)

# Speed and memory of studies of many surfaces, as tables for docs/dev/performance.md; half an hour on two idle cores.
.PHONY: bench-studies
bench-studies:
	cargo build --release --locked
	mkdir -p $(bench_target)/bench
	$(CC) -std=c11 -O2 -Wall -Wextra -Wpedantic -D_POSIX_C_SOURCE=200809L -Iinclude benches/creation_threads.c \
	    -o $(bench_target)/bench/creation_threads -L$(bench_target)/release -Wl,-rpath,$(bench_target)/release -lasperity -pthread
	$$(python/environment.sh)/bin/python benches/studies.py $(bench_target)/bench/creation_threads $(SURFACES)

# What the core costs, in lines, constants, instructions and memory; fails beyond the limits of benches/costs.hpp. Half a minute.
.PHONY: core
core:
	cargo build --release --locked
	mkdir -p $(bench_target)/bench
	$(CXX) -std=c++17 -O2 -Wall -Wextra -Iinclude benches/core.cpp -o $(bench_target)/bench/core \
	    -L$(bench_target)/release -Wl,-rpath,$(bench_target)/release -lasperity
	benches/core.sh $(bench_target)/bench/core
