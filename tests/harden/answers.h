/* What a model answers to every kind of call, to compare bit for bit. */

#ifndef ANSWERS_H
#define ANSWERS_H

#include "../c/check.h"
#include "../c/surfaces.h"

enum { LOADS = 96, EXACT = 6 };

typedef struct answers {
    double load[LOADS], mu[LOADS], force[LOADS], batch[LOADS], slope[LOADS];
    asperity_state exact[EXACT];
    asperity_summary summary;
} answers;

/* A load above pull-off, the i-th of LOADS from the lightest of the table to ten times the heaviest: by operations that have
 * the same bits everywhere. */
static inline double load_of(const asperity_summary *summary, int i)
{
    const double nearest = summary->min_table_load - summary->pull_off_load;
    const double binades = ilogb(10 * summary->max_table_load / nearest) * (i / (LOADS - 1.0));

    return summary->pull_off_load + nearest * ldexp(1 + (binades - floor(binades)), (int)floor(binades));
}

static inline void answer(const asperity_model *model, answers *out)
{
    memset(out, 0, sizeof *out);
    out->summary.struct_size = sizeof out->summary;
    asperity_summary_of(model, &out->summary);
    for (int i = 0; i < LOADS; i++) {
        out->load[i] = load_of(&out->summary, i);
        out->mu[i] = asperity_friction_at_load(model, out->load[i]);
        out->force[i] = asperity_friction_force_at_load(model, out->load[i]);
    }
    asperity_friction_force_at_loads(model, LOADS, out->load, out->batch, out->slope);
    for (int i = 0; i < EXACT; i++) {
        out->exact[i].struct_size = sizeof out->exact[i];
        asperity_state_at_load(model, out->load[20 + 12 * i], &out->exact[i]);
    }
}

/* The bits of the answers. */
static inline int same(const answers *a, const answers *b)
{
    return memcmp(a, b, sizeof *a) == 0;
}

#endif
