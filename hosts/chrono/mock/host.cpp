// A mock of Chrono: a block that touches a floor in four points, a lighter one on top of it, and one without a law, slide under loads that
// change. The coefficient of each contact is held to the exact one at the load of its pair.
#define HOST "chrono"
#include <cmath>
#include <string>

#include "../../verdict.h"
#include "asperity_chrono.h"

// The largest error of a coefficient after a while, over the exact one.
static double slide(const asperity_model *law, bool smooth, double step, double time_constant, double swing, double weight, std::size_t most = 64) {
    chrono::ChSystem system;
    chrono::ChContactable floor, block, upper, other;
    chrono::ChCollisionModel of_floor{&floor}, of_block{&block}, of_upper{&upper}, of_other{&other};
    system.smooth = smooth;
    auto friction = AsperityFriction::attach(system, [&](chrono::ChContactable *a, chrono::ChContactable *b) {
        return a == &other || b == &other ? nullptr : law;
    }, time_constant, most);
    double worst = 0;
    for (int k = 0; k * step < 1; k++) {
        const double whole = weight * (1 + swing * std::sin(6.283185307179586 * k * step));
        auto &contacts = system.container->contacts;
        contacts.clear();
        for (const double share : {0.1, 0.2, 0.3, 0.4})    // a pair whose bodies change places
            contacts.push_back(share < 0.25 ? chrono::ChContactContainer::Contact{&of_block, &of_floor, share * whole, 0}
                                            : chrono::ChContactContainer::Contact{&of_floor, &of_block, share * whole, 0});
        contacts.push_back({&of_upper, &of_block, 0.2 * whole, 0});
        contacts.push_back({&of_other, &of_floor, whole, 0});
        friction->step(step);
        for (std::size_t at = 0; at < contacts.size(); at++) {
            const double exact = at == 5 || k == 0 ? 0.6 : exact_mu(law, at < 4 ? whole : 0.2 * whole);
            if (k * step > 0.5 || k == 0 || at == 5) worst = worse(worst, std::fabs(contacts[at].friction / exact - 1));
        }
    }
    return worst;
}

int main() {
    asperity_model *law = law_of_contact();
    if (!surface_holds(law, 1, 1000)) fail("the model does not hold");
    double still = 0;
    for (const bool smooth : {false, true})
        for (const double step : {1e-3, 5e-3})
            for (const double constant : {0.0, 0.05})
                for (const double weight : {10.0, 900.0}) still = worse(still, slide(law, smooth, step, constant, 0, weight));
    const double line = slide(law, false, 1e-3, 0, 0.8, 100), mean = slide(law, false, 1e-3, 0.05, 0.8, 100);
    std::string message = "nothing";
    try {
        slide(law, false, 1e-3, 0, 0, 100, 2);
    } catch (const std::runtime_error &error) {
        message = error.what();
    }
    const bool good = still <= 1e-6 && line <= 1e-4 && mean <= 0.1 && message == "asperity: more pairs touch than most_pairs";
    printf(HOST "  %s  mock host of Chrono %d: coefficients within %.0e of the law (limit 1e-06), under a load that swings by 80 %% within %.0e by the "
           "line and %.0e by the mean; too many pairs: %s  %.1f s\n", good ? "PASS" : "FAIL", MOCK_VERSION, still, line, mean, message.c_str(), now());
    asperity_free(law);
    return !good;
}
