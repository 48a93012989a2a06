# make bench: measures speed, and rewrites the results in docs/dev/performance.md.

bench_target := $(abspath $(or $(CARGO_TARGET_DIR),target))
bench_program := $(bench_target)/bench/solver_speed

.PHONY: bench
bench:
	cargo build --release
	mkdir -p $(bench_target)/bench
	$(CXX) -std=c++17 -O2 -Wall -Wextra -Iinclude benches/solver_speed.cpp -o $(bench_program) \
	    -L$(bench_target)/release -Wl,-rpath,$(bench_target)/release -lasperity -pthread
	CXX="$(CXX)" benches/report.sh $(bench_program)

# What the core costs, in lines, constants, instructions and memory; fails beyond the limits of benches/costs.hpp. Half a minute.
.PHONY: core
core:
	cargo build --release --locked
	mkdir -p $(bench_target)/bench
	$(CXX) -std=c++17 -O2 -Wall -Wextra -Iinclude benches/core.cpp -o $(bench_target)/bench/core \
	    -L$(bench_target)/release -Wl,-rpath,$(bench_target)/release -lasperity
	benches/core.sh $(bench_target)/bench/core
