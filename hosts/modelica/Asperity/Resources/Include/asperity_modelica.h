/* asperity for Modelica tools, between their external functions and the C interface: the constructor of an external object
 * returns the object, where asperity_create returns a status, and a tool takes errors by ModelicaFormatError, which does
 * not return. */
#ifndef ASPERITY_MODELICA_H
#define ASPERITY_MODELICA_H

#include <stdlib.h>
#include <string.h>

#include <asperity.h>
#include <asperity_loads.h>
#include <ModelicaUtilities.h>

/* Nothing of the library is on the stack here, so leaving by longjmp is safe. */
static inline void asperity_modelica_check(asperity_status status)
{
    if (status != ASPERITY_OK) {
        char message[512];
        asperity_last_error(message, sizeof message);
        ModelicaFormatError("asperity: %s\n", message);
    }
}

/* What the tool keeps: the law, and which warnings were told of it. */
typedef struct asperity_modelica_law {
    asperity_model *model;
    asperity_told told;
} asperity_modelica_law;

/* The path of a surface file, empty for none, and what a text changes of it. */
static inline void *asperity_modelica_create(const char *surface, const char *text)
{
    asperity_params params;
    asperity_model *model = NULL;
    asperity_modelica_law *law;

    asperity_modelica_check(asperity_params_init(&params, sizeof params));
    if (*surface)
        asperity_modelica_check(asperity_params_read(&params, surface));
    asperity_modelica_check(asperity_params_set_text(&params, text, strlen(text)));
    asperity_modelica_check(asperity_create(&params, &model));
    law = (asperity_modelica_law *)calloc(1, sizeof *law);
    if (law == NULL) {
        asperity_free(model);
        ModelicaFormatError("asperity: out of memory\n");
    }
    law->model = model;
    return law;
}

static inline void asperity_modelica_free(void *law)
{
    if (law != NULL)
        asperity_free(((asperity_modelica_law *)law)->model);
    free(law);
}

/* Each warning is told once, at the first load at which it is seen. */
static inline double asperity_modelica_force(void *object, double load)
{
    asperity_modelica_law *law = (asperity_modelica_law *)object;
    const uint64_t warnings = asperity_told_anew(&law->told, law->model, load);
    uint64_t bit;

    for (bit = 1; bit <= warnings; bit *= 2) {
        char text[512];
        if (!(warnings & bit))
            continue;
        asperity_warnings_text(bit, text, sizeof text);
        ModelicaFormatMessage("asperity: warning at a load of %g N: %s\n", load, text);
    }
    return asperity_friction_force_at_load(law->model, load);
}

/* dF/d(load). A separated contact has no friction and no slope: that is an answer, not an error. */
static inline double asperity_modelica_slope(void *law, double load)
{
    double slope = 0;
    const asperity_status status =
        asperity_friction_force_at_loads(((const asperity_modelica_law *)law)->model, 1, &load, NULL, &slope);

    if (status != ASPERITY_SEPARATED)
        asperity_modelica_check(status);
    return slope;
}

#endif
