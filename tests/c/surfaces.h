/* Surfaces of every kind the model knows, for tests that hold for all of them. */

#ifndef SURFACES_H
#define SURFACES_H

#include <asperity.h>
#include <math.h>

enum { SURFACES = 13 };

static const char *const SURFACE_NAMES[SURFACES] = {
    "the paper's case", "without adhesion", "strong adhesion", "weak adhesion", "skewed heights",
    "radii that grow with height", "radii that shrink with height", "no attraction out of contact", "polysilicon, SI",
    "Johnson's heights", "summits that yield", "tabulated heights", "one summit that slips as a whole",
};

static asperity_params surface(int which)
{
    static const double height[5] = { -1, -0.5, 0, 0.5, 1 }, density[5] = { 0, 1, 1, 1, 0 };
    asperity_params p;

    asperity_params_init(&p, sizeof p);
    asperity_params_set_dimensionless(&p, 0.01, 1000, 0.001, 1, 0.3);
    if (which >= 8) {
        asperity_params_set_materials(&p, 160e9, 0.22, 160e9, 0.22);
        p.work_of_adhesion = which == 8 || which == 12 ? 0.063 : 0;
        p.adhesion_range = p.burgers_vector = 0.384e-9;
        p.height_std = 5e-9;
        p.summit_radius = 1e-6;
        p.asperity_count = 1e5;
    }
    switch (which) {
    case 1: p.work_of_adhesion = 0; break;
    case 2: asperity_params_set_dimensionless(&p, 0.01, 1000, 0.02, 1.0, 0.3); break;
    case 3: asperity_params_set_dimensionless(&p, 0.01, 1000, 1e-4, 1.0, 0.3); break;
    case 4: asperity_params_set_text(&p, "skew = -0.5", 11); break;
    case 5: p.radius_amplitude = 1.0; break;
    case 6: p.radius_amplitude = -0.95; break;
    case 7: p.attraction = 0; break;
    case 9:
        p.height_distribution = ASPERITY_HEIGHTS_JOHNSON;
        p.skew = -0.4;
        p.kurtosis = 3.5;
        break;
    case 10:
        p.contact_law = ASPERITY_CONTACT_ELASTIC_PLASTIC;
        p.hardness = 10e9;
        p.pressure_coefficient = 0.05;
        p.nominal_area = 1e-8;
        break;
    case 11:
        p.height_distribution = ASPERITY_HEIGHTS_TABULATED;
        p.table_height = height;
        p.table_density = density;
        p.table_length = 5;
        break;
    case 12:
        p.asperity_count = 1;
        p.height_std = 1e-13;
        p.slip_onset = ASPERITY_SLIP_WHOLE;
        break;
    default: break;
    }
    return p;
}

#endif
