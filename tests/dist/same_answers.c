/* A hundred answers of the library, a row each: platforms are to agree on them to 1e-12 (same_answers.sh). Texts of surfaces in
 * place of files, which WebAssembly has none of. */

#include <asperity.h>

#include <stdio.h>
#include <string.h>

#define SILICON "pair = \"Si/Si\"\nheight_std = 5e-9\nsummit_radius = 1e-6\nasperity_count = 1e5\n"

static const struct {
    const char *name, *text;
} SURFACES[] = {
    { "Gaussian", SILICON },
    { "no adhesion", SILICON "work_of_adhesion = 0\n" },
    { "skewed", SILICON "skew = -0.5\n" },
    { "radii", SILICON "radius_amplitude = 0.5\n" },
    { "yielding", SILICON "contact_law = \"elastic-plastic\"\nhardness = 1e9\n" },
    { "table", SILICON "table_height = [-2, -1, 0, 1, 2]\ntable_density = [0, 0.2, 0.5, 0.2, 0]\n" },
};

static const char *name;

static void row(const char *what, double load, double value)
{
    printf("%s, %s at %g: %.17g\n", name, what, load, value);
}

/* Whether the model could be made. */
static int answer(const char *text)
{
    static const double loads[] = { 1e-7, 1e-3, 10 };
    asperity_params p;
    asperity_model *model = NULL;
    asperity_summary summary = { .struct_size = sizeof summary };
    asperity_state state = { .struct_size = sizeof state };
    double slope, force, stiffness;
    char message[256];

    asperity_params_init(&p, sizeof p);
    if (asperity_params_set_text(&p, text, strlen(text)) != ASPERITY_OK || asperity_create(&p, &model) != ASPERITY_OK) {
        asperity_last_error(message, sizeof message);
        fprintf(stderr, "same_answers: %s: %s\n", name, message);
        return 0;
    }
    asperity_summary_of(model, &summary);
    row("pull-off load", 0, summary.pull_off_load);
    for (int i = 0; i < 3; i++) {
        row("coefficient", loads[i], asperity_friction_at_load(model, loads[i]));
        row("force", loads[i], asperity_friction_force_and_slope_at_load(model, loads[i], &slope));
        row("slope", loads[i], slope);
        row("stiffness", loads[i], asperity_tangential_stiffness_at_load(model, loads[i]));
    }
    row("load of the gap", 0, asperity_load_and_slope_at_gap(model, 0, &slope));
    asperity_state_at_load(model, 1e-3, &state);
    row("exact force", 1e-3, state.friction_force);
    row("real area", 1e-3, state.real_area);
    asperity_tangential_at_load(model, 1e-3, 1e-9, &force, &stiffness);
    row("tangential force", 1e-3, force);
    asperity_free(model);
    return 1;
}

int main(void)
{
    for (size_t i = 0; i < sizeof SURFACES / sizeof *SURFACES; i++) {
        name = SURFACES[i].name;
        if (!answer(SURFACES[i].text))
            return 1;
    }
    return 0;
}
