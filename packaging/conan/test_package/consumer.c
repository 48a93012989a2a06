#include <asperity.h>
#include <stdio.h>

int main(void)
{
    asperity_params params;
    asperity_model *model = NULL;
    asperity_params_init(&params, sizeof params);
    params.height_std = 5e-9, params.summit_radius = 1e-6, params.asperity_count = 1e5; /* silicon on silicon, in SI units */
    if (asperity_params_set_pair(&params, "Si/Si") != ASPERITY_OK || asperity_create(&params, &model) != ASPERITY_OK)
        return 1;
    double force = asperity_friction_force_at_load(model, 1e-3);
    printf("asperity %s: friction %g N at a load of 1 mN\n", asperity_version(), force);
    asperity_free(model);
    return !(force > 0);
}
