#include <asperity.h>
#include <stdio.h>

int main(void)
{
    asperity_params params;
    asperity_params_init(&params);
    asperity_model *model = NULL;
    if (asperity_create(&params, &model) != ASPERITY_OK)
        return 1;
    double force = asperity_friction_force_at_load(model, 1e-3);
    printf("asperity %s: friction %g N at a load of 1 mN\n", asperity_version(), force);
    asperity_free(model);
    return !(force > 0);
}
