/* asperity_loads.h: the load that the steps before let expect, of contacts and of pairs, against sums made here; the warnings
 * that were not told before; the friction force of a smooth sign. */
#include <asperity.h>
#include <asperity_loads.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

#define PAIRS 7

static int failures = 0;

static void require(int holds, const char *what)
{
    if (!holds) {
        fprintf(stderr, "tests/c/loads.c: %s\n", what);
        ++failures;
    }
}

static int close_to(double found, double wanted)
{
    return fabs(found - wanted) <= 1e-12 * fabs(wanted);
}

static void a_line_is_followed_but_not_far(void)
{
    asperity_load known;
    memset(&known, 0, sizeof known);
    require(asperity_load_expected(&known, 3.0) == 0.0, "nothing is known of a new contact");
    asperity_load_take(&known, 10.0, 1.0, 0.0);
    require(asperity_load_expected(&known, 2.0) == 10.0, "after one load that load is expected");
    asperity_load_take(&known, 11.0, 1.5, 0.0);
    require(close_to(asperity_load_expected(&known, 2.0), 12.0), "the line through two loads");
    require(close_to(asperity_load_expected(&known, 1.75), 11.5), "the line, half a step on");
    asperity_load_take(&known, 1.0, 2.0, 0.0);
    require(asperity_load_expected(&known, 2.5) == 0.5, "a falling line ends at half the last load");
    asperity_load_take(&known, 30.0, 2.5, 0.0);
    require(asperity_load_expected(&known, 4.0) == 60.0, "a rising line ends at twice the last load");
    asperity_load_take(&known, 5.0, 0.0, 0.0);
    require(asperity_load_expected(&known, 1.0) == 5.0, "a time that does not grow begins anew");
}

static void a_mean_forgets_with_its_time_constant(void)
{
    asperity_load known;
    double mean;
    int i;
    memset(&known, 0, sizeof known);
    for (i = 0; i < 4; ++i) asperity_load_take(&known, 4.0 + i, 0.1 * i, 1.0);
    require(close_to(asperity_load_expected(&known, 0.4), 8.0), "at first the line: it may be an impact");
    for (; i < 400; ++i) asperity_load_take(&known, i % 2 == 0 ? 2.0 : 6.0, 0.1 * i, 1.0);
    mean = asperity_load_expected(&known, 40.0);
    require(fabs(mean - 4.0) < 0.11, "loads that alternate by 2 about 4: a twentieth of that is left");
    asperity_load_take(&known, 8.0, 60.0, 1.0);
    require(asperity_load_expected(&known, 61.0) == 8.0, "a step longer than the time constant forgets all");
}

static void points_of_a_pair_are_summed(void)
{
    asperity_body_pair pairs[PAIRS];
    memset(pairs, 0, sizeof pairs);
    asperity_pairs_add(pairs, PAIRS, 3, 9, 1.0);
    asperity_pairs_add(pairs, PAIRS, 9, 3, 2.0);
    asperity_pairs_add(pairs, PAIRS, 3, 8, 0.5);
    asperity_pairs_end_step(pairs, PAIRS, 1.0, 0.0);
    require(asperity_pairs_expected(pairs, PAIRS, 9, 3, 2.0) == 3.0, "the sum, whichever comes first");
    require(asperity_pairs_expected(pairs, PAIRS, 8, 3, 2.0) == 0.5, "another pair of the same body");
    require(asperity_pairs_expected(pairs, PAIRS, 8, 9, 2.0) == 0.0, "a pair that does not touch");
    asperity_pairs_add(pairs, PAIRS, 3, 9, 4.0);
    asperity_pairs_end_step(pairs, PAIRS, 2.0, 0.0);
    require(asperity_pairs_expected(pairs, PAIRS, 3, 9, 3.0) == 5.0, "the line of the sums");
    require(asperity_pairs_expected(pairs, PAIRS, 3, 8, 3.0) == 0.0, "what is apart is forgotten");
}

static void a_pair_that_hops_has_load_0_between(void)
{
    asperity_body_pair pairs[PAIRS];
    double mean;
    int i;
    memset(pairs, 0, sizeof pairs);
    for (i = 0; i < 1000; ++i) {
        if (i % 4 == 0) asperity_pairs_add(pairs, PAIRS, 1, 2, 40.0);
        asperity_pairs_end_step(pairs, PAIRS, 0.01 * i, 1.0);
    }
    mean = asperity_pairs_expected(pairs, PAIRS, 1, 2, 10.0);
    require(fabs(mean - 10.0) < 0.5, "a quarter of the steps at 40 is 10");
    for (; i < 1090; ++i) asperity_pairs_end_step(pairs, PAIRS, 0.01 * i, 1.0);
    require(asperity_pairs_expected(pairs, PAIRS, 1, 2, 11.0) > 0.0, "apart for less than the time constant");
    for (; i < 1100; ++i) asperity_pairs_end_step(pairs, PAIRS, 0.01 * i, 1.0);
    require(asperity_pairs_expected(pairs, PAIRS, 1, 2, 11.0) == 0.0, "apart for longer");
}

/* Pairs come and go in a table that is full most of the time; beside it the loads of all in a plain array. */
static void none_is_lost_where_places_are_moved(void)
{
    enum { BODIES = 40, STEPS = 3000 };
    asperity_body_pair pairs[PAIRS];
    static double load[BODIES][BODIES];
    uint32_t random = 1;
    int step, i, a, b, places = 0, refused = 0;
    memset(pairs, 0, sizeof pairs);
    for (step = 0; step < STEPS; ++step) {
        memset(load, 0, sizeof load);
        for (i = 0; i < 9; ++i) {
            random = random * 1664525u + 1013904223u;
            a = (int)(random >> 16) % 5;
            random = random * 1664525u + 1013904223u;
            b = 5 + (int)(random >> 16) % (BODIES - 5);
            if (asperity_pairs_add(pairs, PAIRS, (uint64_t)a, (uint64_t)b, 1.0 + i)) load[a][b] += 1.0 + i;
            else ++refused;
        }
        asperity_pairs_end_step(pairs, PAIRS, 1.0 + step, 0.0);
        for (a = 0; a < BODIES; ++a)
            for (b = a; b < BODIES; ++b) {
                const double found = asperity_pairs_expected(pairs, PAIRS, (uint64_t)b, (uint64_t)a, 1.0 + step);
                if (found != load[a][b]) {
                    require(0, "a pair has another load than was added");
                    return;
                }
                places += found > 0.0;
            }
    }
    printf("loads.c: %d loads found, %d refused\n", places, refused);
    require(places > 3 * STEPS && refused > STEPS, "the table was full, and refused what was too much");
    require(asperity_pairs_add(pairs, 0, 1, 2, 1.0) == 0, "a table without places takes nothing");
}

static void each_warning_is_told_once(void)
{
    const double few = 1e-5, many = 1e-2;
    asperity_params params;
    asperity_model *model = NULL;
    asperity_told told;
    asperity_state state;
    uint64_t first, all;
    double load;
    memset(&told, 0, sizeof told);
    asperity_params_init(&params, sizeof params);
    require(asperity_params_set_pair(&params, "Si/Si") == ASPERITY_OK, "Si/Si is a pair");
    params.height_std = 5e-9;
    params.summit_radius = 1e-6;
    params.asperity_count = 1e5;
    params.nominal_area = 1e-8;
    require(asperity_create(&params, &model) == ASPERITY_OK, "the surface is taken");
    first = asperity_told_anew(&told, model, many);
    require(first == (ASPERITY_WARNING_UNCALIBRATED | ASPERITY_WARNING_BROAD), "what holds at the first load is new");
    require(asperity_told_anew(&told, model, many) == 0, "it is told once");
    require(asperity_told_anew(&told, model, 0.0) == 0 && asperity_told_anew(&told, model, -1.0) == 0, "an open contact");
    require(asperity_told_anew(&told, model, few) == ASPERITY_WARNING_FEW, "at another load the others");
    require(told.lightest == few && told.heaviest == many, "between these loads it was looked");
    /* In small steps of the load nothing is lost. */
    memset(&told, 0, sizeof told);
    for (all = 0, load = few; load < many; load *= 1.1) {
        first = asperity_told_anew(&told, model, load);
        require((all & first) == 0, "no warning is told twice");
        all |= first;
    }
    state.struct_size = sizeof state;
    require(asperity_state_at_load(model, few, &state) == ASPERITY_OK && (state.warnings & ~all) == 0, "all are told");
    asperity_free(model);
}

static void a_slip_force_has_the_sign_of_the_slip_rate(void)
{
    const double transition = 1e-3, third = 0.5 * log(2.0) * transition; /* tanh(ln(2)/2) = 1/3 */
    require(close_to(asperity_slip_force(6.0, third, transition), 2.0), "a third of the force at the rate of a third");
    require(close_to(asperity_slip_force(6.0, -third, transition), -2.0), "against the slip in the other direction too");
    require(asperity_slip_force(6.0, 0.0, transition) == 0.0, "none at rest");
    require(close_to(asperity_slip_force(6.0, 1e-9, transition), 6e-6), "in proportion to a creep");
    require(asperity_slip_force(6.0, 1e9, transition) == 6.0 && asperity_slip_force(6.0, -1e9, transition) == -6.0, "all of it");
    require(asperity_slip_force(6.0, 3.0 * transition, transition) > 0.995 * 6.0, "0.5 % low at three times the transition");
    require(asperity_slip_force(0.0, 1.0, transition) == 0.0, "none of an open contact");
}

int main(void)
{
    a_line_is_followed_but_not_far();
    a_mean_forgets_with_its_time_constant();
    points_of_a_pair_are_summed();
    a_pair_that_hops_has_load_0_between();
    none_is_lost_where_places_are_moved();
    each_warning_is_told_once();
    a_slip_force_has_the_sign_of_the_slip_rate();
    return failures != 0;
}
