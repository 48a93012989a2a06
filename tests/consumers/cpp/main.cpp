// A C++ program as a user has one: without adhesion, friction of the lightest contacts follows the real area, as all of
// them slip at the strength tau_1 (contact radii below a_1). Exit status: 0 where it does.

#include <asperity.hpp>

#include <cmath>
#include <cstdio>
#include <exception>

int main() {
    try {
        asperity::Params params;
        params.set_materials(160e9, 0.22, 160e9, 0.22).work_of_adhesion(0.0).slip_radius_1(1e3).slip_radius_2(1e6);
        params.burgers_vector(0.384e-9).adhesion_range(0.384e-9);
        params.summit_radius(1e-6).height_std(5e-9).asperity_count(1e5);
        const asperity::Model model(params);
        const asperity::State state = model.state_at_load(1e-6);

        const double strength = params.slip_stress_1() * params.effective_shear_modulus();
        const double expected = strength * state.real_area;
        const double force = model.friction_force_at_load(1e-6);
        if (std::fabs(force / expected - 1.0) < 1e-6) {
            return 0;
        }
        std::fprintf(stderr, "friction force = %.17g, must be %.17g\n", force, expected);
    } catch (const std::exception &error) {
        std::fprintf(stderr, "%s\n", error.what());
    }
    return 1;
}
