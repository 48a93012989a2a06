/* A solver may run with floating-point traps on: the whole interface, given good and bad numbers, raises none of invalid,
 * divide-by-zero, overflow; nor underflow, for loads that are 0 or at least 1e-300. A trap ends the program with the name of the
 * call. Calls that answer from the compiled law set the flag "inexact", and no call another. In other rounding directions, and
 * where small numbers are flushed to zero, the same holds, and the host finds its environment as it was. */

#define _GNU_SOURCE
#include <asperity.h>

#include <fenv.h>
#include <math.h>
#include <signal.h>
#include <stdint.h>
#include <stdlib.h>
#include <unistd.h>

#include "check.h"
#include "surfaces.h"

enum { TRAPS = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW };

/* The control of the processor: all but the flags, and what flushes small numbers to zero. */
#if defined __x86_64__
enum { FLUSH = 0x8040, CONTROL = 0xffc0 };
static uint64_t control(void) { return __builtin_ia32_stmxcsr() & CONTROL; }
static void set_control(uint64_t value) { __builtin_ia32_ldmxcsr((__builtin_ia32_stmxcsr() & ~(unsigned)CONTROL) | (unsigned)value); }
#elif defined __aarch64__
enum { FLUSH = 1 << 24 };
static uint64_t control(void) { uint64_t value; __asm__ volatile("mrs %0, fpcr" : "=r"(value)); return value; }
static void set_control(uint64_t value) { __asm__ volatile("msr fpcr, %0" : : "r"(value)); }
#else
enum { FLUSH = 0 };
static uint64_t control(void) { return 0; }
static void set_control(uint64_t value) { (void)value; }
#endif

/* Bits, as arithmetic would raise flags: infinities, quiet and signalling NaN, then numbers of every size. */
static const uint64_t SPECIALS[] = {
    UINT64_C(0x7ff0000000000000), UINT64_C(0xfff0000000000000), UINT64_C(0x7ff8000000000000), UINT64_C(0xfff8000000000000),
    UINT64_C(0x7ff0000000000001), UINT64_C(0xfff4000000000000), 0 /* 0 */, UINT64_C(1) << 63 /* -0 */, 1 /* 5e-324 */,
    UINT64_C(0x8000000000000001), UINT64_C(0x0010000000000000) /* 2e-308 */, UINT64_C(0x01a56e1fc2f8f359) /* 1e-300 */,
    UINT64_C(0x2b2bff2ee48e0530) /* 1e-100 */, UINT64_C(0x3bc79ca10c924223) /* 1e-20 */, UINT64_C(0x3ff0000000000000) /* 1 */,
    UINT64_C(0xbff0000000000000) /* -1 */, UINT64_C(0xbf50624dd2f1a9fc) /* -1e-3 */, UINT64_C(0x4415af1d78b58c40) /* 1e20 */,
    UINT64_C(0x54b249ad2594c37d) /* 1e100 */, UINT64_C(0x602758d6a7b7b3c9) /* about 1e155 */, UINT64_C(0xe02758d6a7b7b3c9),
    UINT64_C(0x7e37e43c8800759c) /* 1e300 */, UINT64_C(0xfe37e43c8800759c), UINT64_C(0x7fefffffffffffff) /* the largest */,
    UINT64_C(0xffefffffffffffff),
};
enum { SPECIAL = sizeof SPECIALS / sizeof *SPECIALS };

static int trapping_underflow;
static volatile const char *volatile doing = "nothing yet";

static void trapped(int signal_number)
{
    const char *text = (const char *)doing;
    (void)signal_number;
    if (write(STDERR_FILENO, "floating-point trap in: ", 24) < 0 || write(STDERR_FILENO, text, strlen(text)) < 0) _exit(3);
    _exit(2);
}

/* Not 0, and so small that products of it with numbers of a size underflow. */
static int is_tiny(uint64_t bits)
{
    return bits << 1 != 0 && (bits << 1 >> 1) < UINT64_C(0x01a56e1fc2f8f359);
}

/* Calls a function, which may set these flags and no other. */
#define ASK(allowed, name, ...)                                                                                        \
    do {                                                                                                               \
        doing = #name;                                                                                                 \
        feclearexcept(FE_ALL_EXCEPT);                                                                                  \
        (void)asperity_##name(__VA_ARGS__);                                                                            \
        CHECK((fetestexcept(FE_ALL_EXCEPT) & ~(allowed)) == 0, #name ": flags %#x", fetestexcept(FE_ALL_EXCEPT));       \
    } while (0)

/* Every question at one number: as load, gap, overlap, displacement, in a state of microslip. */
static void ask_at(const asperity_model *model, uint64_t bits)
{
    const int compiled = FE_INEXACT | (is_tiny(bits) ? FE_UNDERFLOW : 0);
    asperity_state state = { .struct_size = sizeof state };
    asperity_microslip slip = { .struct_size = sizeof slip };
    asperity_specimens specimens = { .struct_size = sizeof specimens };
    double x, in[2], out[2], slope[2];
    uint64_t warnings;

    if (trapping_underflow && is_tiny(bits)) return;
    memcpy(&x, &bits, sizeof x);
    memcpy(&in[0], &bits, sizeof x);
    in[1] = 1.0;
    ASK(compiled, friction_at_load, model, x);
    ASK(compiled, friction_force_at_load, model, x);
    ASK(compiled, friction_and_slope_at_load, model, x, slope);
    ASK(compiled, friction_force_and_slope_at_load, model, x, slope);
    ASK(compiled, friction_at_loads, model, 2, in, out, slope);
    ASK(compiled, friction_force_at_loads, model, 2, in, out, slope);
    ASK(compiled, friction_force_at_loads_of, &model, 1, 2, (const uint32_t[]){ 0, 1 }, in, out, slope);
    ASK(compiled, friction_force_at_loads_of, &model, 1, 2, (const uint32_t[]){ 0, 1 }, in, out, NULL);
    ASK(compiled, tangential_stiffness_at_load, model, x);
    ASK(compiled, tangential_stiffness_at_loads, model, 2, in, out);
    ASK(compiled, load_and_slope_at_gap, model, x, NULL);
    ASK(compiled, load_and_slope_at_gap, model, x, slope);
    ASK(compiled, loads_at_gaps, model, 2, in, out, slope);
    ASK(0, tangential_at_load, model, x, 1e-9, out, slope);
    ASK(0, tangential_at_load, model, 1.0, x, out, slope);
    ASK(0, specimens_at_loads, model, 2, bits, 1, in, &specimens);
    ASK(0, each_specimen_at_loads, model, x, bits, 1, 1, 1, in, out, out, out, out, out, out);
    ASK(0, state_at_load, model, x, &state);
    ASK(0, state_at_gap, model, x, &state);
    ASK(0, check_loads, model, x, x, &warnings);
    for (int which = 0; which < 5; which++) {
        double loads[2] = { 1.0, 1.0 }, by[4] = { 1e-3, -2e-3, 1.0, 2.0 }, states[86] = { 0.0 }, after[86], force[4], tangents[8];
        double *const places[] = { &loads[0], &by[1], &states[5], &states[40], &states[41] };
        memcpy(places[which], &bits, sizeof bits);
        ASK(0, microslip_step, model, loads[0], by, states, after, &slip);
        ASK(0, microslip_steps, model, 2, loads, by, states, after, force, tangents);
        ASK(0, microslip_turn, states, loads[0], 0.5);
    }
}

/* At the numbers above, and at the ends of the table and of contact. */
static void ask(const asperity_model *model)
{
    asperity_summary s = { .struct_size = sizeof s };

    ASK(0, summary_of, model, &s);
    for (int i = 0; i < SPECIAL; i++) ask_at(model, SPECIALS[i]);
    /* The program's own arithmetic may make tiny numbers. */
    const int traps = fedisableexcept(FE_UNDERFLOW);
    const double edges[] = {
        s.pull_off_load, nextafter(s.pull_off_load, INFINITY), nextafter(s.pull_off_load, -INFINITY), 2 * s.pull_off_load,
        0.5 * s.pull_off_load, 0.999999999999 * s.pull_off_load, s.min_table_load, nextafter(s.min_table_load, -INFINITY),
        s.max_table_load, nextafter(s.max_table_load, INFINITY), s.max_table_load < 1e300 ? 2 * s.max_table_load : 1e300,
    };
    feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(traps);
    for (size_t i = 0; i < sizeof edges / sizeof *edges; i++) {
        uint64_t bits;
        memcpy(&bits, &edges[i], sizeof bits);
        ask_at(model, bits);
    }
}

static int ask_surface(int which)
{
    const asperity_params p = surface(which), other = surface(0);
    asperity_model *model = NULL;

    ASK(0, create, &p, &model);
    CHECK(model != NULL, "%s: no model", SURFACE_NAMES[which]);
    if (model == NULL) return 0;
    ask(model);
    ASK(0, set_params, model, &other);
    ASK(0, set_params, model, &p);
    ASK(0, free, model);
    return 1;
}

static void every_surface(void)
{
    for (int i = 0; i < SURFACES; i++) ask_surface(i);
}

/* What is read from texts, and estimates from them. */
static void texts_and_estimates(void)
{
    static const char *const texts[] = {
        "pair = \"steel/steel\"\nnominal_area = 1e-4\nroughness = {Ra = 0.8e-6, process = \"ground\"}\nmeasured = [[100, 0.17], [1000, 0.16]]",
        "pair = \"mica/Au\"\nheight_std = 5e-9\nsummit_radius = 1e-6\nsummit_density = 1e13\nnominal_area = 1e-10\nskew = -0.5",
        "E1 = 1e300\nnu1 = 0.3\nE2 = 1e300\nnu2 = 0.3", "measured = [1e-300, 1e300]", "height_std = nan",
    };
    static char text[1 << 14];
    asperity_params p;
    const char *name;

    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        asperity_params_init(&p, sizeof p);
        ASK(0, params_set_text, &p, texts[i], strlen(texts[i]));
        ASK(0, params_text, &p, text, sizeof text);
        ASK(0, estimate_text, texts[i], strlen(texts[i]), 3, (const double[]){ 0, 1e-3, 10 }, text, sizeof text);
        for (int k = 0; i == 1 && k < SPECIAL; k++) {
            asperity_estimate found = { .struct_size = sizeof found };
            double load;
            memcpy(&load, &SPECIALS[k], sizeof load);
            ASK(0, estimate_at_loads, texts[i], strlen(texts[i]), 1, &load, &found);
        }
    }
    for (size_t k = 0; (name = asperity_name(ASPERITY_NAMES_PAIRS, k)) != NULL; k++) ASK(0, params_set_pair, &p, name);
}

static void other_environments(void)
{
    static const int roundings[] = { FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO }, kinds[] = { 0, 1, 4, 10 };
    const uint64_t start = control();

    for (int e = 0; e < 24; e++) {
        fesetround(roundings[e % 3]);
        set_control(control() | (e % 6 < 3 ? 0 : FLUSH));
        const uint64_t before = control();
        const int made = ask_surface(kinds[e / 6]), kept = control() == before && fegetround() == roundings[e % 3];
        set_control(start);
        fesetround(FE_TONEAREST);
        CHECK(made && kept, "environment %d: no model, or another environment", e);
    }
}

int main(void)
{
    signal(SIGFPE, trapped);
    CHECK(traps_at_start == TRAPS, "this machine cannot trap floating-point exceptions");
    every_surface();
    feenableexcept(FE_UNDERFLOW);
    trapping_underflow = 1;
    every_surface();
    fedisableexcept(FE_UNDERFLOW);
    trapping_underflow = 0;
    texts_and_estimates();
    other_environments();
    return checks_report("traps");
}
