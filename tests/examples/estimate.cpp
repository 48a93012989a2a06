// As estimate.c.
#include <asperity.hpp>

#include <cstdio>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

int main() {
    const std::string surface(std::istreambuf_iterator<char>(std::cin), {});
    const std::vector<double> loads = {0.0, 1.0, 100.0};
    const auto found = asperity::estimates(surface, loads);
    for (std::size_t i = 1; i < found.size(); i++)
        std::printf("%.12E %.12E %.12E\n", found[i].friction_coefficient, found[i].low, found[i].high);
    std::printf("%s", asperity::estimate_text(surface, loads).c_str());
}
