/* The check of surface.h must refuse what the model does not hold for: the summits of a surface far smoother than what
 * is pressed on it, which all touch; a contact of too few summits; summits that yield; a surface of unknown hardness. */
#include <stdlib.h>

#include "surface.h"

static int failures;

static void expect(const char *what, const asperity_params *params, double lightest, double heaviest, int wanted) {
    asperity_model *model = NULL;
    if (asperity_create(params, &model) != ASPERITY_OK) abort();
    const int holds = surface_holds(model, lightest, heaviest);
    asperity_free(model);
    if (holds == wanted) return;
    printf("surface_test: %s from %g to %g: the check says %d\n", what, lightest, heaviest, holds);
    failures++;
}

int main(void) {
    asperity_params film, smooth, soft, unknown;
    if (set_surface(&film, 1e-4) != ASPERITY_OK) abort();
    expect("the film", &film, 1e-3, 7e4, 1);
    expect("the film, too heavily loaded,", &film, 1e-3, 9e4, 0);
    expect("the film, too lightly loaded,", &film, 1e-5, 7e4, 0);
    expect("the film, unloaded to nothing,", &film, -1, 7e4, 0);
    smooth = film;
    smooth.height_std = 2.5e-9;
    smooth.summit_radius = 25e-6;
    smooth.asperity_count = 1e6;
    smooth.radius_amplitude = smooth.rms_slope = 0;
    expect("a surface without roughness to speak of", &smooth, 500, 500, 0);
    soft = film;
    soft.hardness = 12e9;
    expect("a soft surface", &soft, 500, 500, 0);
    unknown = film;
    unknown.hardness = 0;
    expect("a surface of unknown hardness", &unknown, 500, 500, 0);
    return failures != 0;
}
