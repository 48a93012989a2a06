/* A program compiled against the first version of the header: its structs have no more than the fields of then, and
 * lie at the end of heap blocks, so that valgrind sees every byte that the library reads or writes past them. It
 * declares what it calls itself, as the header of then did. */

#include <stdint.h>
#include <stdlib.h>

#include "check.h"

typedef struct asperity_model asperity_model;

typedef struct params {
    uint64_t struct_size;
    double composite_modulus, effective_shear_modulus, work_of_adhesion, adhesion_range, burgers_vector, height_std,
        summit_radius, asperity_count;
    int32_t height_distribution, attraction;
    double weibull_shape, radius_amplitude, radius_rate, slip_radius_1, slip_stress_1, slip_radius_2, slip_stress_2,
        max_friction_coefficient;
} params;

typedef struct state {
    uint64_t struct_size;
    double load, separation, friction_force, friction_coefficient, dforce_dload, dmu_dload, dload_dseparation,
        real_area, contacting, attracted, attraction_load;
} state;

int32_t asperity_params_init(params *);
int32_t asperity_params_set_dimensionless(params *, double, double, double, double, double);
int32_t asperity_params_set_materials(params *, double, double, double, double);
int32_t asperity_params_set_skew(params *, double);
int32_t asperity_create(const params *, asperity_model **);
int32_t asperity_set_params(asperity_model *, const params *);
int32_t asperity_get_params(const asperity_model *, params *);
void asperity_free(asperity_model *);
double asperity_friction_at_load(const asperity_model *, double);
int32_t asperity_state_at_load(const asperity_model *, double, state *);
int32_t asperity_state_at_separation(const asperity_model *, double, state *);

int main(void)
{
    params *p = malloc(sizeof *p), *kept = malloc(sizeof *kept);
    state *s = malloc(sizeof *s);
    asperity_model *model = NULL;
    double mu;

    if (p == NULL || kept == NULL || s == NULL)
        return 1;
    CHECK(asperity_params_init(p) == 0 && p->struct_size == sizeof *p, "struct_size %d", (int)p->struct_size);
    CHECK(p->max_friction_coefficient == 1000, "cap %g", p->max_friction_coefficient);
    CHECK(asperity_params_set_dimensionless(p, 0.02, 500, 0.003, 0.5, 0.2) == 0, "set_dimensionless");
    CHECK(asperity_params_set_materials(p, 3, 0.2, 5, 0.3) == 0, "set_materials");
    CHECK(asperity_params_set_skew(p, 0.5) == 0 && p->struct_size == sizeof *p, "set_skew");
    CHECK(asperity_create(p, &model) == 0, "create");
    mu = asperity_friction_at_load(model, 10);
    CHECK(mu > 0, "mu = %g", mu);
    CHECK(asperity_get_params(model, kept) == 0 && memcmp(p, kept, sizeof *p) == 0, "other parameters come back");
    CHECK(asperity_set_params(model, kept) == 0 && asperity_friction_at_load(model, 10) == mu, "set_params");
    s->struct_size = sizeof *s;
    CHECK(asperity_state_at_load(model, 10, s) == 0 && s->struct_size == sizeof *s && s->contacting > 0, "a state");
    CHECK(asperity_state_at_separation(model, s->separation, s) == 0 && s->attraction_load < 0, "a state");
    asperity_free(model);
    free(p);
    free(kept);
    free(s);
    return checks_report("old_caller");
}
