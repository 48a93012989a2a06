/* A program compiled against the first version of the header, and one against the second: the structs have no more than
 * the fields of then, and lie at the end of heap blocks, so that valgrind sees every byte that the library reads or
 * writes past them. It declares what it calls itself, as the headers of then did. */

#include <math.h>
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

typedef struct second_params {
    params first;
    double skew, kurtosis, hardness;
    const double *table_height, *table_density;
    uint64_t table_length;
    double tangential_modulus, nominal_area;
    int32_t contact_law, reserved;
} second_params;

typedef struct second_state {
    state first;
    double mean_contact_radius, max_contact_radius, fraction_below_slip_radius_1, fraction_between_slip_radii,
        fraction_above_slip_radius_2, fraction_in_contact, mean_asperity_pressure, plasticity_index;
    uint64_t warnings;
    double tangential_stiffness, fraction_elastic, fraction_flowing;
} second_state;

int32_t asperity_params_init(params *);
int32_t asperity_params_init_sized(void *, uint64_t);
int32_t asperity_get_params_sized(const asperity_model *, void *, uint64_t);
int32_t asperity_params_set_value(void *, const char *, double);
int32_t asperity_params_calibrate(void *, double, double);
int32_t asperity_params_set_interface(void *, const char *);
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

/* The second version has no pressure coefficient: it is 0, and where one is asked for there is no place for it. */
static void second_version(void)
{
    second_params *p = malloc(sizeof *p), *kept = malloc(sizeof *kept);
    second_state *s = malloc(sizeof *s);
    asperity_model *model = NULL;
    double plain;

    if (p == NULL || kept == NULL || s == NULL)
        exit(1);
    CHECK(asperity_params_init_sized(p, sizeof *p) == 0 && p->first.struct_size == sizeof *p, "struct_size %d",
          (int)p->first.struct_size);
    CHECK(asperity_create(&p->first, &model) == 0, "create");
    CHECK(asperity_get_params_sized(model, kept, sizeof *kept) == 0 && memcmp(p, kept, sizeof *p) == 0,
          "other parameters come back");
    plain = asperity_friction_at_load(model, 10);
    s->first.struct_size = sizeof *s;
    CHECK(asperity_state_at_load(model, 10, &s->first) == 0 && s->first.struct_size == sizeof *s &&
          s->tangential_stiffness > 0 && s->fraction_elastic == 1, "a state");
    /* kappa = 0: F is the strength times the area, and twice the strength gives twice the friction. */
    p->first.slip_stress_1 *= 2;
    p->first.slip_stress_2 *= 2;
    CHECK(asperity_set_params(model, &p->first) == 0, "set_params");
    CHECK(fabs(asperity_friction_at_load(model, 10) / (2 * plain) - 1) < 1e-12, "mu = %g", plain);
    CHECK(asperity_params_calibrate(p, 10, 3) == 0 && asperity_set_params(model, &p->first) == 0, "calibrate");
    CHECK(fabs(asperity_friction_at_load(model, 10) / 0.3 - 1) < 2e-9, "a measured point");
    CHECK(asperity_params_set_value(p, "pressure_coefficient", 0.1) != 0, "a parameter without a place is refused");
    p->first.effective_shear_modulus = 1e10;
    CHECK(asperity_params_set_interface(p, "KCl film on iron in vacuum") != 0, "an interface whose strength grows with pressure too");
    CHECK(asperity_params_set_interface(p, "graphite layers") == 0 && p->first.slip_stress_2 == 140e6 / 1e10, "one of which it does not");
    asperity_free(model);
    free(p);
    free(kept);
    free(s);
}

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
    second_version();
    return checks_report("old_caller");
}
