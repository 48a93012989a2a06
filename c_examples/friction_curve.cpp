// Friction coefficient of a polysilicon MEMS contact against normal load, with its band: the summary of friction_curve.c,
// which says where the numbers come from, in C++.

#include <asperity.hpp>

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

int main() {
    constexpr char surface[] = "measured = [1e-2, 0.3, 0.05]    # load [N], friction coefficient, relative error: ASSUMED\n"
                               "work_of_adhesion = 0.063        # [J/m^2]\n"
                               "adhesion_range = 0.384e-9       # [m]\n"
                               "burgers_vector = 0.384e-9       # [m]\n"
                               "hardness = 12e9                 # [Pa], for warnings\n"
                               "nominal_area = 1e-8             # [m^2]\n"
                               "[materials]\n"
                               "E1 = 160e9                      # [Pa]\n"
                               "nu1 = 0.22\n"
                               "E2 = 160e9\n"
                               "nu2 = 0.22\n"
                               "[roughness]\n"
                               "Sq = 5e-9                       # [m]\n"
                               "Sdq = 0.08\n";
    const std::vector<double> loads = {1e-4, 1e-3, 1e-2, 1e-1, 1.0}; // [N]
    try {
        const asperity::Model model(asperity::Params().set_text(surface));
        const std::vector<asperity::Estimate> estimates = asperity::estimates(surface, loads);
        std::printf("  load [N]      mu     low    high   contacts\n");
        for (std::size_t i = 0; i < loads.size(); ++i) {
            const asperity::Estimate &found = estimates[i];
            std::printf("%10.3g  %6.3f  %6.3f  %6.3f  %9.0f\n", found.load, found.friction_coefficient, found.low, found.high,
                        model.state_at_load(loads[i]).contacting);
        }
        const std::string warnings = asperity::warnings_text(model.check_loads(loads.front(), loads.back()));
        std::fprintf(stderr, "friction_curve: %s\n", warnings.c_str());
    } catch (const asperity::Error &error) {
        std::fprintf(stderr, "friction_curve: %s\n", error.what());
        return 1;
    }
    return 0;
}
