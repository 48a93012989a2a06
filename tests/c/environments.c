/* A host may round in another direction, flush small numbers to zero, trap exceptions and have flags raised: the
 * answers are the same bits, and the host finds its environment as it was. */

#define _GNU_SOURCE
#include <asperity.h>

#include <fenv.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "check.h"
#include "surfaces.h"

enum { LOADS = 80, FAR = 32, EXACT = 3, KINDS = 3, FLAGS = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW | FE_UNDERFLOW };

/* ---- The host's environments ---- */

/* As the program starts, other roundings, small numbers flushed to zero, all of that, traps by
 * the register itself, an x87 unit of single precision. */
enum { PLAIN, UPWARD, DOWNWARD, TOWARD_ZERO, FLUSHING, EVERYTHING, TRAPPING, X87_SINGLE, ENVIRONMENTS };

static const char *const NAMES[ENVIRONMENTS] = {
    "as it starts", "upward", "downward", "toward zero", "flushing to zero", "upward, flushing, flags raised",
    "trapping", "x87 in single precision",
};

#if defined __GNUC__ && (defined __x86_64__ || defined __SSE2__)
/* MXCSR: flush to zero and denormals are zero; masks of invalid, divide by zero and overflow; all but the flags. The
 * control word of the x87 unit: its precision. */
enum { FLUSH = 0x8040, MASKS = 0x680, CONTROL = 0xffc0, PRECISION = 0x300 };
static unsigned x87(void)
{
    unsigned short word;
    __asm__ volatile("fnstcw %0" : "=m"(word));
    return word;
}
static void set_x87(unsigned bits)
{
    const unsigned short word = (unsigned short)bits;
    __asm__ volatile("fldcw %0" : : "m"(word));
}
static uint64_t control(void)
{
    return (__builtin_ia32_stmxcsr() & CONTROL) | (uint64_t)x87() << 32;
}
static void change(unsigned clear, unsigned set)
{
    __builtin_ia32_ldmxcsr((__builtin_ia32_stmxcsr() & ~clear) | set);
}
#elif defined __GNUC__ && defined __aarch64__
/* FPCR: flush to zero. */
enum { FLUSH = 1 << 24, MASKS = 0, PRECISION = 0 };
static uint64_t control(void)
{
    uint64_t value;
    __asm__ volatile("mrs %0, fpcr" : "=r"(value));
    return value;
}
static void change(unsigned clear, unsigned set)
{
    const uint64_t value = (control() & ~(uint64_t)clear) | set;
    __asm__ volatile("msr fpcr, %0" : : "r"(value));
}
static unsigned x87(void)
{
    return 0;
}
static void set_x87(unsigned bits)
{
    (void)bits;
}
#else /* no register is known, or it has none of that */
enum { FLUSH = 0, MASKS = 0, PRECISION = 0 };
static uint64_t control(void)
{
    return 0;
}
static void change(unsigned clear, unsigned set)
{
    (void)(clear + set);
}
static unsigned x87(void)
{
    return 0;
}
static void set_x87(unsigned bits)
{
    (void)bits;
}
#endif

static void enter(int environment)
{
    static const int rounding[ENVIRONMENTS] = {
        FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO, FE_TONEAREST, FE_UPWARD, FE_TONEAREST,
        FE_TONEAREST,
    };
    if (fesetround(rounding[environment]) != 0)
        abort();
    if (environment == FLUSHING || environment == EVERYTHING)
        change(0, FLUSH);
    if (environment == EVERYTHING && fegetexcept() == 0)
        feraiseexcept(FE_OVERFLOW | FE_INEXACT);
    if (environment == TRAPPING && fegetexcept() == 0)
        change(MASKS, 0);
    if (environment == X87_SINGLE)
        set_x87(x87() & ~(unsigned)PRECISION);
}

static void leave(unsigned precision)
{
    set_x87(precision);
    change(FLUSH, fegetexcept() == 0 ? MASKS : 0);
    fesetround(FE_TONEAREST);
    feclearexcept(FE_ALL_EXCEPT);
}

/* ---- Answers ---- */

typedef struct answers {
    asperity_params set;
    asperity_summary summary;
    asperity_table table;
    double mu[LOADS], force[LOADS], stiffness[LOADS], slopes[4][LOADS], sliding[3][LOADS], stress[LOADS];
    double radii[3][LOADS];
    double batch[3][LOADS], batch_slopes[2][LOADS];
    double gap[3][LOADS], gaps[2][LOADS], of[2][LOADS], pressed[4][LOADS], slipping[3][LOADS];
    asperity_state at_load[EXACT], at_separation[EXACT];
    asperity_sensitivities sensitivities;
    double tangential[2][EXACT], summits[3][EXACT];
    asperity_microslip slipped[EXACT];
    double states[EXACT][42], batch_states[EXACT][42], forces[EXACT][2], tangents[EXACT][4];
    int status[24];
} answers;

typedef struct questions {
    double load[LOADS], separation[LOADS], exact[EXACT], displacement, overlap[EXACT], increments[EXACT][2];
} questions;

/* Loads of every kind, made in the environment of the start; but none below 2.2e-308, which a host that flushes takes
 * for zero. */
static void prepare(const asperity_model *model, questions *q)
{
    const double special[] = {0.0, -0.0, 2.3e-308, -2.3e-308, 1e-290, 1e-200, 1e300, INFINITY, NAN};
    const int specials = sizeof special / sizeof *special;
    asperity_summary s = {.struct_size = sizeof s};
    asperity_state state = {.struct_size = sizeof state};

    asperity_summary_of(model, &s);
    asperity_state_at_load(model, s.pull_off_load < 0 ? s.pull_off_load : 1e-9 * s.max_table_load, &state);
    for (int i = 0; i < LOADS; i++)
        q->load[i] = i < specials ? special[i] : ldexp(0.7 + 0.1 * (i % 3), 5 - 2 * (LOADS - FAR - i)) * s.max_table_load;
    /* Far beyond both ends of the table, where numbers are still moderate and where they are not. */
    for (int i = 0; i < FAR; i++)
        q->load[LOADS - FAR + i] = ldexp(0.7 + 0.1 * (i % 3), (i % 2 == 0 ? 27 : -27) * i) * s.max_table_load;
    /* From compression beyond the table over all heights to surfaces apart. */
    for (int i = 0; i < LOADS; i++)
        q->separation[i] = i < specials ? special[i] : state.gap * (1.5 - ldexp(0.1 * i, i % 4 == 0 ? 40 - i : -2));
    q->load[specials] = s.pull_off_load;
    q->load[specials + 1] = 0.4 * s.pull_off_load;
    q->load[specials + 2] = 3 * s.pull_off_load;
    q->load[specials + 3] = s.pull_off_load * (1 - 1e-7);
    for (int i = 0; i < EXACT; i++)
        q->exact[i] = s.max_table_load * ldexp(0.3, -12 * i - 4);
    asperity_state_at_load(model, q->exact[1], &state);
    q->displacement = 0.6 * state.friction_force / state.tangential_stiffness;
    for (int i = 0; i < EXACT; i++) {
        q->increments[i][0] = (i - 1) * q->displacement;
        q->increments[i][1] = 0.3 * q->displacement;
    }
    for (int i = 0; i < EXACT; i++)
        q->overlap[i] = 0.2 * (i - 1) * state.mean_contact_radius;
}

/* Calls alone, without arithmetic of the program's own. */
static asperity_model *ask(const asperity_params *p, const questions *q, answers *a)
{
    asperity_model *model = NULL;
    int *status = a->status;

    *status++ = asperity_params_init(&a->set, sizeof a->set);
    *status++ = asperity_params_set_dimensionless(&a->set, 0.011, 1300, 0.0013, 1.1, 0.3);
    *status++ = asperity_params_set_materials(&a->set, 161e9, 0.23, 71e9, 0.34);
    *status++ = asperity_params_set_spectral_moments(&a->set, 3.1, 0.47, 0.71, 11);
    *status++ = asperity_params_set_skew(&a->set, -0.37);
    *status++ = asperity_create(p, &model);
    if (q == NULL || model == NULL)
        return model;
    a->summary.struct_size = sizeof a->summary;
    *status++ = asperity_summary_of(model, &a->summary);
    a->table.struct_size = sizeof a->table;
    *status++ = asperity_table_of(model, &a->table);
    for (int i = 0; i < LOADS; i++) {
        a->mu[i] = asperity_friction_at_load(model, q->load[i]);
        a->force[i] = asperity_friction_force_at_load(model, q->load[i]);
        a->stiffness[i] = asperity_tangential_stiffness_at_load(model, q->load[i]);
        a->radii[0][i] = asperity_contact_radius_sum_at_load(model, q->load[i]);
        asperity_friction_and_slope_at_load(model, q->load[i], &a->slopes[0][i]);
        asperity_friction_force_and_slope_at_load(model, q->load[i], &a->slopes[1][i]);
        asperity_friction_at_pressure(model, q->load[i], 1.3, &a->slopes[2][i]);
        a->stress[i] = asperity_shear_stress_at_pressure(model, q->load[i], 1.3, &a->slopes[3][i]);
        a->sliding[0][i] = asperity_slip_force(model, q->load[i], -0.31, 0.7, &a->sliding[1][i], &a->sliding[2][i]);
        a->gap[0][i] = asperity_load_at_gap(model, q->separation[i]);
        a->gap[1][i] = asperity_load_and_slope_at_gap(model, q->separation[i], &a->gap[2][i]);
    }
    {
        const asperity_model *const models[] = {model, model};
        uint32_t which[LOADS];
        for (int i = 0; i < LOADS; i++)
            which[i] = (uint32_t)(i % 2);
        *status++ = asperity_loads_at_gaps(model, LOADS, q->separation, a->gaps[0], a->gaps[1]);
        *status++ = asperity_friction_force_at_loads_of(models, 2, LOADS, which, q->load, a->of[0], a->of[1]);
        *status++ = asperity_friction_at_pressures(model, LOADS, q->load, 1.3, a->pressed[0], a->pressed[1]);
        *status++ = asperity_shear_stresses_at_pressures(model, LOADS, q->load, 1.3, a->pressed[2], a->pressed[3]);
        *status++ = asperity_slip_forces(model, LOADS, q->load, q->separation, 0.7, a->slipping[0], a->slipping[1],
                                         a->slipping[2]);
    }
    *status++ = asperity_friction_at_loads(model, LOADS, q->load, a->batch[0], a->batch_slopes[0]);
    *status++ = asperity_friction_force_at_loads(model, LOADS, q->load, a->batch[1], a->batch_slopes[1]);
    *status++ = asperity_tangential_stiffness_at_loads(model, LOADS, q->load, a->batch[2]);
    *status++ = asperity_contact_radius_sum_at_loads(model, LOADS, q->load, a->radii[1], a->radii[2]);
    for (int i = 0; i < EXACT; i++) {
        a->at_load[i].struct_size = a->at_separation[i].struct_size = sizeof(asperity_state);
        asperity_state_at_load(model, q->exact[i], &a->at_load[i]);
        asperity_state_at_gap(model, q->overlap[i], &a->at_separation[i]);
        asperity_tangential_at_load(model, q->exact[i], q->displacement, &a->tangential[0][i], &a->tangential[1][i]);
        a->slipped[i].struct_size = sizeof(asperity_microslip);
        asperity_microslip_step(model, q->exact[i], q->increments[i], a->states[i], a->states[i], &a->slipped[i]);
    }
    *status++ = asperity_microslip_steps(model, EXACT, q->exact, q->increments[0], a->states[0], a->batch_states[0],
                                         a->forces[0], a->tangents[0]);
    *status++ =
        asperity_summits_at_overlaps(model, EXACT, q->overlap, NULL, a->summits[0], a->summits[1], a->summits[2]);
    a->sensitivities.struct_size = sizeof a->sensitivities;
    *status++ = asperity_sensitivities_at_load(model, q->exact[1], &a->sensitivities);
    return model;
}

/* The same in one of the host's environments, which must be left as it was. */
static asperity_model *ask_in(int environment, const asperity_params *p, const questions *q, answers *a)
{
    asperity_model *model;
    int rounding, flags, traps;
    unsigned precision;
    uint64_t bits;

    memset(a, 0, sizeof *a);
    feclearexcept(FE_ALL_EXCEPT);
    precision = x87();
    enter(environment);
    rounding = fegetround();
    flags = fetestexcept(FLAGS);
    traps = fegetexcept();
    bits = control();
    model = ask(p, q, a);
    CHECK(control() == bits, "%s: the control register is another", NAMES[environment]);
    CHECK(fegetround() == rounding, "%s: rounding is %d", NAMES[environment], fegetround());
    CHECK(fegetexcept() == traps, "%s: other exceptions are trapped", NAMES[environment]);
    CHECK(fetestexcept(FLAGS) == flags, "%s: flags %#x, not %#x", NAMES[environment], fetestexcept(FLAGS), flags);
    leave(precision);
    return model;
}

static void compare(int which, int environment, const asperity_params *p, const questions *q, const answers *expected,
                    const double *rows)
{
    static answers found;
    asperity_model *model = ask_in(environment, p, q, &found);
    const char *name = SURFACE_NAMES[which];

    CHECK(memcmp(found.table.rows, rows, (size_t)found.table.total_count * 8 * sizeof *rows) == 0,
          "%s, %s: another table", name, NAMES[environment]);
    found.table.rows = expected->table.rows;
    for (int i = 0; i < LOADS; i++) {
        CHECK(SAME(found.mu[i], expected->mu[i]), "%s, %s: mu %a, not %a at %a", name, NAMES[environment], found.mu[i],
              expected->mu[i], q->load[i]);
        CHECK(SAME(found.force[i], expected->force[i]), "%s, %s: force %a, not %a at %a", name, NAMES[environment],
              found.force[i], expected->force[i], q->load[i]);
        CHECK(SAME(found.sliding[0][i], expected->sliding[0][i]), "%s, %s: sliding at %a", name, NAMES[environment],
              q->load[i]);
    }
#define PART(field) CHECK(SAME(found.field, expected->field), "%s, %s: other " #field, name, NAMES[environment])
    PART(set); PART(summary); PART(table); PART(stiffness); PART(radii); PART(slopes); PART(sliding); PART(stress);
    PART(batch);
    PART(batch_slopes); PART(at_load); PART(at_separation); PART(sensitivities); PART(tangential); PART(summits);
    PART(slipped); PART(states); PART(batch_states); PART(forces); PART(tangents);
    PART(status);
#undef PART
    asperity_free(model);
}

int main(void)
{
    static const int kinds[KINDS] = {0, 1, 4}; /* adhesion, none, skewed heights */
    static answers expected, first;
    static questions q;

    for (int k = 0; k < KINDS; k++) {
        const asperity_params p = surface(kinds[k]);
        asperity_model *model = ask(&p, NULL, &first);
        CHECK(model != NULL, "%s: no model", SURFACE_NAMES[kinds[k]]);
        prepare(model, &q);
        asperity_free(model);
        model = ask_in(PLAIN, &p, &q, &expected);
        for (int e = PLAIN + 1; e < ENVIRONMENTS; e++)
            compare(kinds[k], e, &p, &q, &expected, expected.table.rows);
        asperity_free(model);
    }
    return checks_report("environments");
}
