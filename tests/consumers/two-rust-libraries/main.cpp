// A C++ program with two static libraries of Rust. Each unwinds for itself: a panic of the second, an exception of C++, an error of
// asperity. Exit status: 0 where all come to where they belong.

#include <asperity.hpp>

#include <cstdint>
#include <cstdio>

extern "C" std::uint64_t second_sum(std::uint64_t n);

int main() {
    const asperity::Model model(asperity::Params::paper());
    int caught = 0;
    try {
        asperity::Model(asperity::Params::paper().summit_radius(-1.0));
    } catch (const asperity::Error &error) {
        caught = error.status() == ASPERITY_INVALID_PARAMETER;
    }
    std::printf("%.15g %llu %d\n", model.friction_at_load(100.0), static_cast<unsigned long long>(second_sum(10)), caught);
    return caught == 1 && second_sum(10) == 45 && model.friction_at_load(100.0) > 0.0 ? 0 : 1;
}
