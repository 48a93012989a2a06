/* A program as any user of libasperity has one: without adhesion, the load, area and number of contacts that Greenwood
 * and Williamson's integrals give. Proc. R. Soc. A 295 (1966), 300: with F_n(d) the integral of (z - d)^n over the
 * Gaussian density, P = 4/3 N E* R^(1/2) sigma^(3/2) F_3/2, A = pi N R sigma F_1, contacts = N F_0.
 * Exit status: 0 where all agree. */

#include <asperity.h>
#include <stdio.h>
#include <string.h>

static int failures;

static void expect(const char *what, double value, double expected, double tolerance)
{
    const double error = value / expected - 1;

    if (!(error < tolerance && error > -tolerance)) {
        fprintf(stderr, "%s = %.17g, must be %.17g\n", what, value, expected);
        failures++;
    }
}

static int failed(const char *call)
{
    char message[256];

    asperity_last_error(message, sizeof message);
    fprintf(stderr, "%s: %s\n", call, message);
    return 1;
}

static void compare(const asperity_params *params, const asperity_model *model, const asperity_state *state)
{
    const double pi = 3.14159265358979324;
    const double root_r = 1e-3, sigma_to_3_2 = 1e-12;    /* of the R and sigma below */
    const double f_3_2 = 0.43001999, f_1 = 0.39894228040143268, f_0 = 0.5;    /* at d = 0; F_1 is 1/sqrt(2 pi) */
    const double n = params->asperity_count;

    expect("load", state->load, 4.0 / 3 * n * params->composite_modulus * root_r * sigma_to_3_2 * f_3_2, 2e-8);
    expect("real area", state->real_area, pi * n * params->summit_radius * params->height_std * f_1, 1e-9);
    expect("contacts", state->contacting, n * f_0, 1e-9);
    expect("friction force", asperity_friction_force_at_load(model, state->load), state->friction_force, 1e-6);
    expect("friction coefficient", asperity_friction_at_load(model, state->load), state->friction_force / state->load,
           1e-6);
}

int main(void)
{
    asperity_params params;
    asperity_model *model;
    asperity_state state;

    if (strcmp(asperity_version(), ASPERITY_VERSION) != 0 || asperity_abi_version() != ASPERITY_ABI_VERSION) {
        fprintf(stderr, "library %s is not of the header, " ASPERITY_VERSION "\n", asperity_version());
        return 1;
    }
    asperity_params_init(&params, sizeof params);
    if (asperity_params_set_materials(&params, 160e9, 0.22, 160e9, 0.22) != ASPERITY_OK)
        return failed("asperity_params_set_materials");
    params.work_of_adhesion = 0;
    params.burgers_vector = params.adhesion_range = 0.384e-9;
    params.summit_radius = 1e-6;
    params.height_std = 1e-8;
    params.asperity_count = 1e5;
    if (asperity_create(&params, &model) != ASPERITY_OK)
        return failed("asperity_create");
    state.struct_size = sizeof state;
    if (asperity_state_at_gap(model, 0, &state) != ASPERITY_OK)
        return failed("asperity_state_at_gap");
    compare(&params, model, &state);
    asperity_free(model);
    return failures != 0;
}
