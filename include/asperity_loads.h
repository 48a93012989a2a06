/* asperity_loads.h: from the numbers of a solver to those of the library, and back. The load at which to ask for friction,
 * where a solver needs the friction coefficient before it knows the normal force of the step; pressures in place of loads;
 * friction of a slip rate that passes through zero.
 *
 * The load of the last step lags behind, and biases friction where it jitters. These functions keep the loads of past
 * steps for each contact, or for each pair of bodies, and return the expected load of the next step [force]:
 *
 *   time_constant = 0   the straight line through the last two loads, for loads that vary smoothly
 *   time_constant > 0   the mean over about that time, for loads that are right on average only; steps without contact
 *                       count as load 0, until the pair has been apart for time_constant. A contact that is younger
 *                       than that has the line: it may be an impact
 *
 * For pairs, in memory of the caller, which must be zero at the start (the functions allocate nothing):
 *
 *     static asperity_body_pair pairs[1000];
 *     each contact, before the step:    load = asperity_pairs_expected(pairs, 1000, a, b, time);
 *                                       mu = load > 0 ? asperity_friction_at_load(model, load) : first_guess;
 *     each contact, after the step:     asperity_pairs_add(pairs, 1000, a, b, normal_force);
 *     then once:                        asperity_pairs_end_step(pairs, 1000, time, time_constant);
 *
 * A solver that keeps its own data with each contact can keep an asperity_load there, without the pairs: call
 * asperity_load_take after the step, asperity_load_expected before.
 *
 * If you include it after asperity.h, it also returns the warnings of the model that are new at a load, so that a host
 * writes each one once:
 *
 *     static asperity_told told;
 *     char text[4096];
 *     uint64_t warnings = asperity_told_anew(&told, model, load);
 *     if (warnings != 0) asperity_warnings_text(warnings, text, sizeof text), write_to_log(text);
 *
 * Pressures: a model whose asperity_count summits stand on one unit of area takes pressures in place of loads and gives
 * shear stresses in place of forces; slopes and coefficients are the same. A grain or facet of the area A whose forces you
 * need, with a model of the area A0: ask at the load times A0/A, and multiply the force by A/A0.
 *
 * Self-contained: C99 and C++. Both structs are plain doubles, so that a host may save, copy and restore them with its
 * own state. Loads are positive in compression, finite and not negative. `time` is the host's time of a load, past or
 * expected. A time that does not increase starts again.
 */
#ifndef ASPERITY_LOADS_H
#define ASPERITY_LOADS_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>

/* What is known of the load on one contact. All zero: nothing yet. */
typedef struct asperity_load {
    double load;  /* the last one, or the mean */
    double slope; /* its change by time; 0 for a mean */
    double time;  /* at which it was taken */
    double count; /* loads taken so far */
} asperity_load;

/* Two bodies, or whatever a host numbers, that touch. All zero: a free place. */
typedef struct asperity_body_pair {
    double taken;         /* 1 if this place is in use */
    double first, second; /* the smaller number first */
    double sum;           /* of the loads of the points of this step */
    double touched;       /* the time at which it last had a load */
    asperity_load known;
} asperity_body_pair;

/* Takes the load found at a time. */
static inline void asperity_load_take(asperity_load *known, double load, double time, double time_constant)
{
    const double step = time - known->time;
    const double share = time_constant > 0.0 ? step / time_constant : 0.0;
    if (known->count == 0.0 || !(step > 0.0)) {
        known->load = load;
        known->slope = 0.0;
        known->count = 0.0;
    } else if (share * known->count >= 1.0) {
        known->load += (load - known->load) * (share < 1.0 ? share : 1.0);
        known->slope = 0.0;
    } else {
        known->slope = (load - known->load) / step;
        known->load = load;
    }
    known->count += 1.0;
    known->time = time;
}

/* The load to be expected at a time; 0 if nothing is known. A line is followed to half the last load and to twice it:
 * what changes faster within a step is not resolved by the steps. */
static inline double asperity_load_expected(const asperity_load *known, double time)
{
    const double line = known->load + known->slope * (time - known->time);
    if (line < 0.5 * known->load) return 0.5 * known->load;
    if (line > 2.0 * known->load) return 2.0 * known->load;
    return line;
}

/* The place at which the search for a pair begins. */
static inline size_t asperity_pairs_home(size_t capacity, double first, double second)
{
    const uint64_t golden = UINT64_C(0x9E3779B97F4A7C15); /* 2^64 over the golden ratio: spreads consecutive numbers */
    const uint64_t mixed = ((uint64_t)first * golden ^ (uint64_t)second) * golden;
    return (size_t)((mixed >> 32) % capacity);
}

/* The place of a pair in whichever order, or if it has none a free one; NULL if there is neither. */
static inline asperity_body_pair *asperity_pairs_place(asperity_body_pair *pairs, size_t capacity, uint64_t a, uint64_t b)
{
    const double first = (double)(a < b ? a : b), second = (double)(a < b ? b : a);
    size_t i, tried;
    if (capacity == 0) return NULL;
    i = asperity_pairs_home(capacity, first, second);
    for (tried = 0; tried < capacity; ++tried, i = (i + 1) % capacity) {
        asperity_body_pair *pair = &pairs[i];
        if (pair->taken == 0.0 || (pair->first == first && pair->second == second)) return pair;
    }
    return NULL;
}

/* Adds the load of a contact point to those of its pair in this step. The numbers of the bodies are below 2^53, as
 * addresses are too. Returns 1; or 0 if all places are taken: there must be one for each pair that touches in this
 * step, in the step before or within the time constant, and twice as many for speed. */
static inline int asperity_pairs_add(asperity_body_pair *pairs, size_t capacity, uint64_t a, uint64_t b, double load)
{
    asperity_body_pair *pair = asperity_pairs_place(pairs, capacity, a, b);
    if (pair == NULL) return 0;
    if (pair->taken == 0.0) {
        if (!(load > 0.0)) return 1;
        pair->taken = 1.0;
        pair->first = (double)(a < b ? a : b);
        pair->second = (double)(a < b ? b : a);
    }
    pair->sum += load;
    return 1;
}

/* The load to be expected on a pair at a time, over all its points; 0 if nothing is known. */
static inline double asperity_pairs_expected(asperity_body_pair *pairs, size_t capacity, uint64_t a, uint64_t b, double time)
{
    const asperity_body_pair *pair = asperity_pairs_place(pairs, capacity, a, b);
    return pair != NULL && pair->taken != 0.0 ? asperity_load_expected(&pair->known, time) : 0.0;
}

/* Frees a place and moves what a search would not find any more. */
static inline void asperity_pairs_remove(asperity_body_pair *pairs, size_t capacity, size_t hole)
{
    const asperity_body_pair none = {0.0, 0.0, 0.0, 0.0, 0.0, {0.0, 0.0, 0.0, 0.0}};
    const size_t start = hole;
    size_t i;
    for (i = (hole + 1) % capacity; i != start && pairs[i].taken != 0.0; i = (i + 1) % capacity) {
        const size_t home = asperity_pairs_home(capacity, pairs[i].first, pairs[i].second);
        if ((i + capacity - home) % capacity < (i + capacity - hole) % capacity) continue;
        pairs[hole] = pairs[i];
        hole = i;
    }
    pairs[hole] = none;
}

/* Ends a step, whose loads were added and belong to this time. */
static inline void asperity_pairs_end_step(asperity_body_pair *pairs, size_t capacity, double time, double time_constant)
{
    size_t i;
    for (i = 0; i < capacity; ++i) {
        asperity_body_pair *pair = &pairs[i];
        if (pair->taken == 0.0) continue;
        if (pair->sum > 0.0) pair->touched = time;
        asperity_load_take(&pair->known, pair->sum, time, time_constant);
        pair->sum = 0.0;
    }
    for (i = 0; i < capacity;) {
        /* What moves into a place that was freed is looked at there. */
        const int apart = pairs[i].taken != 0.0 && pairs[i].touched != time;
        if (apart && !(time - pairs[i].touched < time_constant)) asperity_pairs_remove(pairs, capacity, i);
        else ++i;
    }
}

/* Friction force of a sliding contact with a smooth sign of the slip rate, F tanh(v/v0), for solvers that integrate through
 * zero slip rate; F is asperity_friction_force_at_load. It has the sign of the slip rate, and friction opposes slip: apply
 * minus this force to the body whose slip rate you give. Its slope by the load is tanh(v/v0) times that of F, its slope by
 * the slip rate F (1 - tanh(v/v0)^2)/v0. A contact that should stick creeps instead. How to choose transition_rate, v0 > 0:
 *
 *   sliding         less than a third of the slowest sliding speed of interest, at which friction is then 0.5 % low
 *   holding         a tangential force T < F makes the contact creep with v0 artanh(T/F): keep that below the creep that
 *                   you allow
 *   explicit steps  steps h of a mass m stop without a change of sign if v0 >= F h/m, and oscillate below half of that */
static inline double asperity_slip_force(double friction_force, double slip_rate, double transition_rate)
{
    return friction_force * tanh(slip_rate / transition_rate);
}

#ifdef ASPERITY_H
/* After asperity.h: which warnings a host has told of a model. All zero: none, and it was looked for none. */
typedef struct asperity_told {
    uint64_t warnings;         /* told so far, bits ASPERITY_WARNING_... */
    double lightest, heaviest; /* the loads between which it was looked for them */
} asperity_told;

/* The warnings that hold at a load and were not told before: a host writes their asperity_warnings_text to its log.
 * May be asked with every load. It looks at the exact state, in less than a millisecond, only where the load is above twice the
 * heaviest or below half the lightest load so far. */
static inline uint64_t asperity_told_anew(asperity_told *told, const asperity_model *model, double load)
{
    asperity_state state;
    uint64_t found;
    if (!(load > 0.0)) return 0;
    if (told->heaviest > 0.0 && load <= 2.0 * told->heaviest && load >= 0.5 * told->lightest) return 0;
    state.struct_size = sizeof state;
    if (asperity_state_at_load(model, load, &state) != ASPERITY_OK) return 0;
    if (!(told->heaviest > load)) told->heaviest = load;
    if (!(told->lightest > 0.0 && told->lightest < load)) told->lightest = load;
    found = state.warnings & ~told->warnings;
    told->warnings |= found;
    return found;
}
#endif

#endif
