/* The check of surface.h must refuse what the model does not hold for: the summits of a surface far smoother than what
 * is pressed on it, which all touch; a contact of too few summits; summits that yield; a surface of unknown hardness. */
#include <stdlib.h>
#include <string.h>

#include "surface.h"

static int failures;

static void expect(const char *what, const asperity_params *params, double load, const char *wanted) {
    asperity_model *model = NULL;
    asperity_state state = {0};
    if (asperity_create(params, &model) != ASPERITY_OK) abort();
    const char *fault = surface_fault(model, load, 1, &state);
    asperity_free(model);
    if (wanted ? fault != NULL && strstr(fault, wanted) != NULL : fault == NULL) return;
    printf("surface_test: %s: '%s', expected '%s'\n", what, fault ? fault : "none", wanted ? wanted : "none");
    failures++;
}

int main(void) {
    asperity_params film, smooth, rough, unknown;
    if (set_surface(&film, 1e-4) != ASPERITY_OK) abort();
    expect("the film at 1 N", &film, 1, NULL);
    expect("the film at 7 kN", &film, 7e3, NULL);
    expect("the film at 9 kN", &film, 9e3, "more than 10 %");
    expect("the film at 1e-5 N", &film, 1e-5, "fewer than 20");
    smooth = film;
    smooth.height_std = 2.5e-9;
    smooth.summit_radius = 25e-6;
    smooth.asperity_count = 1e6;
    expect("a surface without roughness to speak of", &smooth, 500, "more than 10 %");
    rough = film;
    rough.hardness = 12e9;
    expect("a soft surface", &rough, 500, "yield");
    unknown = film;
    unknown.hardness = 0;
    expect("a surface of unknown hardness", &unknown, 500, "hardness");
    return failures != 0;
}
