/* A host may round in another direction, flush small numbers to zero and have exceptions trapped: every call ends, none traps,
 * and the host finds its environment as it was. The answers of calls from the compiled law may then differ in their last
 * digits. */

#define _GNU_SOURCE
#include <asperity.h>

#include <fenv.h>
#include <math.h>
#include <stdint.h>

#include "check.h"
#include "surfaces.h"

enum { LOADS = 48, FLAGS = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW };

#if defined __GNUC__ && (defined __x86_64__ || defined __SSE2__)
/* MXCSR: flush to zero and denormals are zero; all but the flags. */
enum { FLUSH = 0x8040, CONTROL = 0xffc0 };
static uint64_t control(void)
{
    return __builtin_ia32_stmxcsr() & CONTROL;
}
static void set_control(uint64_t value)
{
    __builtin_ia32_ldmxcsr((__builtin_ia32_stmxcsr() & ~(unsigned)CONTROL) | (unsigned)value);
}
#elif defined __GNUC__ && defined __aarch64__
/* FPCR: flush to zero. */
enum { FLUSH = 1 << 24 };
static uint64_t control(void)
{
    uint64_t value;
    __asm__ volatile("mrs %0, fpcr" : "=r"(value));
    return value;
}
static void set_control(uint64_t value)
{
    __asm__ volatile("msr fpcr, %0" : : "r"(value));
}
#else
enum { FLUSH = 0 };
static uint64_t control(void)
{
    return 0;
}
static void set_control(uint64_t value)
{
    (void)value;
}
#endif

/* Loads of every kind, as multiples of the heaviest of the table, and what is no load. */
static void prepare(const asperity_model *model, double *load)
{
    const double special[] = { 0.0, -0.0, 5e-324, 2.3e-308, -2.3e-308, 1e-290, 1e300, 1.7e308, INFINITY, -INFINITY, NAN };
    const int specials = sizeof special / sizeof *special;
    asperity_summary s = { .struct_size = sizeof s };

    asperity_summary_of(model, &s);
    for (int i = 0; i < LOADS; i++)
        load[i] = i < specials ? special[i] : ldexp(0.7 + 0.1 * (i % 3), 160 - 7 * i) * s.max_table_load;
    load[specials] = s.pull_off_load;
    load[specials + 1] = 0.4 * s.pull_off_load;
    load[specials + 2] = 3 * s.pull_off_load;
}

/* Whether a friction force is about the one of the other environment; none is where there was none. */
static int near(double found, double expected)
{
    if (isnan(expected))
        return isnan(found);
    return !isnan(found) && fabs(found - expected) <= 1e-6 * fabs(expected) + 1e-300;
}

static void ask(const asperity_params *p, const double *load, double *force)
{
    asperity_params set;
    asperity_model *model = NULL;
    asperity_state state = { .struct_size = sizeof state };
    asperity_microslip slipped = { .struct_size = sizeof slipped };
    double mu[LOADS], slope[LOADS], states[42], increments[2] = { 1e-3, -2e-3 }, two[2];
    uint64_t warnings;

    asperity_params_init(&set, sizeof set);
    asperity_params_set_materials(&set, 161e9, 0.23, 71e9, 0.34);
    asperity_params_set_spectral_moments(&set, 3.1, 0.47, 0.71, 11);
    CHECK(asperity_create(p, &model) == ASPERITY_OK, "no model");
    for (int i = 0; i < LOADS; i++) {
        force[i] = asperity_friction_force_at_load(model, load[i]);
        asperity_friction_at_load(model, load[i]);
        asperity_tangential_stiffness_at_load(model, load[i]);
        asperity_friction_and_slope_at_load(model, load[i], slope);
        asperity_friction_force_and_slope_at_load(model, load[i], slope);
        asperity_load_and_slope_at_gap(model, load[i], slope);
    }
    asperity_friction_at_loads(model, LOADS, load, mu, slope);
    asperity_friction_force_at_loads(model, LOADS, load, mu, slope);
    asperity_tangential_stiffness_at_loads(model, LOADS, load, mu);
    asperity_loads_at_gaps(model, LOADS, load, mu, slope);
    for (int i = 0; i < LOADS; i += 5) {
        memset(states, 0, sizeof states);
        asperity_state_at_load(model, load[i], &state);
        asperity_tangential_at_load(model, load[i], 1e-3, &two[0], &two[1]);
        asperity_microslip_step(model, load[i], increments, states, states, &slipped);
    }
    asperity_check_loads(model, load[LOADS - 1], load[LOADS - 5], &warnings);
    asperity_free(model);
}

int main(void)
{
    static const int kinds[] = { 0, 1, 4 }; /* adhesion, none, skewed heights */
    static const int roundings[] = { FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO };
    double load[LOADS], expected[LOADS], force[LOADS];

    for (int k = 0; k < 3; k++) {
        const asperity_params p = surface(kinds[k]);
        asperity_model *model = NULL;
        CHECK(asperity_create(&p, &model) == ASPERITY_OK, "no model");
        prepare(model, load);
        asperity_free(model);
        ask(&p, load, expected);
        for (int e = 0; e < 6; e++) {
            const uint64_t start = control();
            uint64_t before;
            int rounding, raised;
            feclearexcept(FE_ALL_EXCEPT);
            fesetround(roundings[e % 3]);
            set_control(control() | (e < 3 ? 0 : FLUSH));
            before = control();
            rounding = fegetround();
            ask(&p, load, force);
            raised = fetestexcept(FLAGS);
            CHECK(control() == before && fegetround() == rounding, "%d: the environment is another", e);
            set_control(start);
            fesetround(FE_TONEAREST);
            CHECK(raised == 0, "%d: flags %#x", e, raised);
            for (int i = 0; i < LOADS; i++)
                CHECK(near(force[i], expected[i]), "%d: %g at %g, not %g", e, force[i], load[i], expected[i]);
        }
    }
    return checks_report("environments");
}
