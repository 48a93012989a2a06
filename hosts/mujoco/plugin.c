/* The engine plugin asperity.friction of MuJoCo: the friction coefficient of contacts, the law at their normal force.
 *
 * MuJoCo makes the constraints of a step and then asks plugins for passive forces, before it solves. There the plugin
 * sets the friction coefficients of its contacts: with elliptic cones nothing that was made before depends on them, if
 * the coefficients of a contact keep their ratios. The normal force of the step is not known yet; what the steps before
 * tell of it (asperity_loads.h), for each pair of geometries, is in the plugin's state, which MuJoCo copies, saves and
 * resets. With `microslip` pairs that stick stay where they are (microslip.h), in the same way.
 */
#include <math.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <mujoco/mujoco.h>

#include "asperity.h"
#include "asperity_loads.h"
#include "asperity_mujoco.h"
#include "microslip.h"

#ifdef mjUSESINGLE
#error "asperity.friction is for MuJoCo in double precision"
#endif

#define PLUGIN "asperity.friction"

/* ---- Configuration ---- */

/* A surface file and what a text changes of it; the plugin's own. */
static const char *const KEYS[] = {"surface", "text", "time_constant", "most_pairs", "pairs", "microslip"};
enum { KEY_COUNT = sizeof KEYS / sizeof KEYS[0] };

/* Two geometries that an instance names in its configuration. */
typedef struct named_pair {
    int geom[2], instance;
} named_pair;

/* What an instance is, made for each mjData. */
typedef struct surface {
    asperity_model *model;
    size_t most_pairs;
    size_t held_width; /* doubles that a pair has in microslip; 0 without */
    named_pair *named; /* those of all instances */
    size_t named_count;
    int crowded;             /* more pairs touched than there are places, and this was told */
    asperity_told told;      /* warnings that were seen */
    _Atomic uint64_t *said; /* those in MuJoCo's log, of this surface in all mjData; NULL if there is no room for it */
} surface;

/* What mj_getState and the like carry: the time of the forces at hand, the pairs, and after them the same number of places for
 * microslip. */
typedef struct memory {
    double time;
    asperity_body_pair pairs[];
} memory;

static memory *memory_of(const mjModel *m, const mjData *d, int instance) {
    return (memory *)(d->plugin_state + m->plugin_stateadr[instance]);
}

static surface *surface_of(const mjData *d, int instance) { return (surface *)d->plugin_data[instance]; }

static const char *instance_name(const mjModel *m, int instance) {
    const char *name = m->names + m->name_pluginadr[instance];
    return *name ? name : "(without a name)";
}

/* Ends the run, or in Python raises mujoco.FatalError, or fails the compilation of the model. */
static void refuse(const mjModel *m, int instance, const char *format, ...) {
    char what[900];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    mju_error(PLUGIN ", instance '%s': %s", instance_name(m, instance), what);
}

static void refuse_as_library(const mjModel *m, int instance) {
    char message[512];
    asperity_last_error(message, sizeof message);
    refuse(m, instance, "%s", message);
}

static void refuse_options(const mjModel *m, int instance) {
    if (m->opt.cone != mjCONE_ELLIPTIC)
        refuse(m, instance, "needs <option cone=\"elliptic\"/>: in the pyramidal cone friction depends on the "
                            "direction of slip");
    if ((m->opt.disableflags & mjDSBL_SPRING) && (m->opt.disableflags & mjDSBL_DAMPER))
        refuse(m, instance, "needs <flag spring=\"enable\"/> or <flag damper=\"enable\"/> in <option>: MuJoCo asks no "
                            "plugin if both are disabled");
}

/* A number of the configuration; `missing` if it is not given. */
static double number(const mjModel *m, int instance, const char *key, double missing) {
    const char *text = mj_getPluginConfig(m, instance, key);
    char *end = NULL;
    if (!text || !*text) return missing;
    const double value = strtod(text, &end);
    if (end == text || *(end + strspn(end, " \t\n\r")))
        refuse(m, instance, "%s = '%s' is not a number", key, text);
    return value;
}

/* The time over which loads are averaged. Bodies that slide in MuJoCo hop, at times of `solref`, by default 0.02 s. Boxes of 0.1 to
 * 100 kg on an incline slide as the mean load lets expect, within 2 %, from 0.05 s or 40 steps on; with steps of
 * 10 ms within 3 %, with a solref of 0.005 s within 6 %. */
static double time_constant(const mjModel *m, int instance) {
    const double time = number(m, instance, "time_constant", fmax(0.05, 40 * m->opt.timestep));
    if (!(time >= 0 && isfinite(time)))
        refuse(m, instance, "time_constant = %g: must be finite and not negative", time);
    return time;
}

static int has_microslip(const mjModel *m, int instance) {
    static const char *const words[2][3] = {{"false", "no", "0"}, {"true", "yes", "1"}};
    const char *text = mj_getPluginConfig(m, instance, "microslip");
    if (!text || !*text) return 0;
    for (int i = 0; i < 6; i++)
        if (strcmp(text, words[i / 3][i % 3]) == 0) return i / 3;
    refuse(m, instance, "microslip = '%s': must be true or false, or yes or no", text);
    return 0;
}

static void read_params(const mjModel *m, int instance, asperity_params *params) {
    const char *file = mj_getPluginConfig(m, instance, "surface"), *text = mj_getPluginConfig(m, instance, "text");
    asperity_status status = asperity_params_init(params, sizeof *params);
    if (status == ASPERITY_OK && file && *file) status = asperity_params_read(params, file);
    if (status == ASPERITY_OK && text) status = asperity_params_set_text(params, text, strlen(text));
    if (status != ASPERITY_OK) refuse_as_library(m, instance);
}

/* ---- Which contacts ---- */

static int is_ours(const mjModel *m, int instance) {
    return instance >= 0 && strcmp(mjp_getPluginAtSlot(m->plugin[instance])->name, PLUGIN) == 0;
}

int asperity_mujoco_has_plugin(const mjModel *m, int instance) { return instance < m->nplugin && is_ours(m, instance); }

/* The geometry that is named at *text, which is moved to the next word, comma or end. */
static int next_geom(const mjModel *m, int instance, const char **text) {
    char name[200];
    const size_t length = strcspn(*text, " \t\n\r,");
    snprintf(name, sizeof name, "%.*s", (int)length, *text);
    const int geom = mj_name2id(m, mjOBJ_GEOM, name);
    if (geom < 0) refuse(m, instance, "pairs: there is no geom '%s'; give 'geom1 geom2, geom3 geom4'", name);
    *text += length;
    *text += strspn(*text, " \t\n\r");
    return geom;
}

/* Adds the pairs that an instance names to an array, unless it is NULL; returns how many. */
static size_t named_by(const mjModel *m, int instance, named_pair *pairs) {
    const char *text = mj_getPluginConfig(m, instance, "pairs");
    size_t count = 0;
    if (!text) return 0;
    for (text += strspn(text, " \t\n\r"); *text; text += strspn(text, " ,\t\n\r"), count++) {
        const int first = next_geom(m, instance, &text), second = next_geom(m, instance, &text);
        if (*text && *text != ',') refuse(m, instance, "pairs: a comma must follow two geoms");
        if (pairs) pairs[count] = (named_pair){{first, second}, instance};
    }
    return count;
}

static void read_named_pairs(const mjModel *m, surface *made) {
    size_t count = 0;
    for (int i = 0; i < m->nplugin; i++) count += is_ours(m, i) ? named_by(m, i, NULL) : 0;
    made->named = count ? mju_malloc(count * sizeof *made->named) : NULL;
    for (int i = 0; i < m->nplugin; i++)
        if (is_ours(m, i)) made->named_count += named_by(m, i, made->named + made->named_count);
}

/* Whether two geometries may collide, and one of them is of a body with the instance. */
static int may_touch(const mjModel *m, int instance, int a, int b) {
    const int first = m->geom_bodyid[a], second = m->geom_bodyid[b];
    if (m->body_plugin[first] != instance && m->body_plugin[second] != instance) return 0;
    if (m->body_weldid[first] == m->body_weldid[second]) return 0;
    return (m->geom_contype[a] & m->geom_conaffinity[b]) || (m->geom_contype[b] & m->geom_conaffinity[a]);
}

/* How many pairs may touch at a time: unless it is given, all that may collide, but no more than eight for each of their geometries
 * (of balls of any sizes fewer than 7.5 can touch for each ball), those named, and some. */
static size_t most_pairs(const mjModel *m, int instance) {
    size_t pairs = 0, geoms = 0;
    for (int a = 0; a < m->ngeom; a++) {
        size_t before = pairs;
        for (int b = 0; b < m->ngeom; b++) pairs += b != a && may_touch(m, instance, a, b);
        geoms += pairs > before;
    }
    const size_t named = named_by(m, instance, NULL) + (size_t)m->npair;
    const double most = number(m, instance, "most_pairs", fmin(1e6, 8 + (double)named + fmin((double)pairs / 2, 8.0 * (double)geoms)));
    if (!(most >= 1 && most <= 1e6)) refuse(m, instance, "most_pairs = %g: must be from 1 to 1e6", most);
    return (size_t)most;
}

static const char *geom_name(const mjModel *m, int geom) {
    const char *name = mj_id2name(m, mjOBJ_GEOM, geom);
    return name ? name : "without a name";
}

/* Whether a contact has the friction of an instance: it names the two geometries, or none does and it is that of one of
 * their bodies. */
static int has_surface(const mjModel *m, const surface *here, int instance, const mjContact *contact) {
    const int a = contact->geom[0], b = contact->geom[1];
    if (contact->dim < 3 || contact->efc_address < 0 || a < 0 || b < 0) return 0;
    for (size_t i = 0; i < here->named_count; i++) {
        const int *geom = here->named[i].geom;
        if ((geom[0] == a && geom[1] == b) || (geom[0] == b && geom[1] == a))
            return here->named[i].instance == instance;
    }
    const int of_a = m->body_plugin[m->geom_bodyid[a]], of_b = m->body_plugin[m->geom_bodyid[b]];
    if (of_a != instance && of_b != instance) return 0;
    if (of_a != of_b && is_ours(m, of_a) && is_ours(m, of_b))
        refuse(m, instance, "geoms '%s' and '%s' touch, and the body of the other has the instance '%s': say in one of "
                            "the two which it is, by <config key=\"pairs\" value=\"%s %s\"/>",
               geom_name(m, a), geom_name(m, b), instance_name(m, of_a == instance ? of_b : of_a), geom_name(m, a),
               geom_name(m, b));
    return 1;
}

/* The points of two geometries, which follow one another among the contacts. */
typedef struct points {
    mjContact *first;
    int count;
} points;

/* The next pair with the friction of an instance, of whose points the last are given, none to begin with; without points if
 * there are no more. */
static points next_pair(const mjModel *m, mjData *d, int instance, points last) {
    mjContact *const end = d->contact + d->ncon, *at = last.first ? last.first + last.count : d->contact;
    while (at < end) {
        points pair = {at, 0};
        int ours = 0;
        for (; at < end && at->geom[0] == pair.first->geom[0] && at->geom[1] == pair.first->geom[1]; at++) {
            ours |= has_surface(m, surface_of(d, instance), instance, at);
            pair.count++;
        }
        if (ours) return pair;
    }
    return (points){NULL, 0};
}

/* The normal force that MuJoCo solved for on a pair, over its points. */
static double load_of(const mjData *d, points pair) {
    double load = 0;
    for (int i = 0; i < pair.count; i++)
        if (pair.first[i].efc_address >= 0) load += d->efc_force[pair.first[i].efc_address];
    return load;
}

/* ---- Friction ---- */

/* The coefficients of a contact keep their ratios, on which its regularisation rests; the first is that of sliding. */
static void set_coefficient(points pair, double coefficient) {
    for (mjContact *contact = pair.first; contact < pair.first + pair.count; contact++) {
        if (contact->efc_address < 0) continue;
        const double ratio = fmax(coefficient, mjMINMU) / contact->friction[0];
        for (int k = 0; k < 5; k++) contact->friction[k] *= ratio;
        contact->mu *= ratio;
    }
}

static asperity_body_pair *place_of(const mjModel *m, const mjData *d, int instance, points pair) {
    return asperity_pairs_place(memory_of(m, d, instance)->pairs, surface_of(d, instance)->most_pairs,
                                (uint64_t)pair.first->geom[0], (uint64_t)pair.first->geom[1]);
}

/* Loads are known of a pair that has been in contact for some steps; before, they change too fast to be expected. */
static int is_known(const asperity_body_pair *place) {
    enum { STEPS = 2 };
    return place && place->taken && place->known.count >= STEPS && place->known.load > 0;
}

/* Gives the pairs of an instance the law at the loads that the steps before let expect. Returns how many are new. */
static int set_coefficients(const mjModel *m, mjData *d, int instance) {
    int unknown = 0;
    memory_of(m, d, instance)->time = d->time;
    for (points pair = {NULL, 0}; (pair = next_pair(m, d, instance, pair)).first;) {
        const asperity_body_pair *place = place_of(m, d, instance, pair);
        const double load = place && place->taken ? asperity_load_expected(&place->known, d->time) : 0;
        if (load > 0) set_coefficient(pair, asperity_friction_at_load(surface_of(d, instance)->model, load));
        unknown += !is_known(place);
    }
    return unknown;
}

/* Gives pairs of an instance the law at the forces just found: all of them, or those of which the steps before know nothing.
 * Returns by how much a coefficient changed at most, relative to itself. `part` is the part of the change that is made. */
static double correct(const mjModel *m, mjData *d, int instance, int all, double part) {
    double change = 0;
    for (points pair = {NULL, 0}; (pair = next_pair(m, d, instance, pair)).first;) {
        const asperity_body_pair *place = place_of(m, d, instance, pair);
        const double load = load_of(d, pair), before = pair.first->friction[0];
        if (!(load > 0) || (!all && is_known(place))) continue;
        const double law = fmax(asperity_friction_at_load(surface_of(d, instance)->model, load), mjMINMU);
        change = fmax(change, fabs(law / before - 1));
        set_coefficient(pair, before + part * (law - before));
    }
    return change;
}

/* Solves the step for the forces of contacts. */
static void solve(const mjModel *m, mjData *d) {
    mj_fwdActuation(m, d);
    mj_fwdAcceleration(m, d);
    mj_fwdConstraint(m, d);
    mju_copy(d->qacc_warmstart, d->qacc, m->nv);
}

/* Solves ahead for the loads of new pairs. MuJoCo makes anew what this leaves, except what a solution begins with and the
 * acceleration that mj_inverse is given. */
static void solve_ahead(const mjModel *m, mjData *d) {
    enum { PASSES = 4 };
    const double settled = 0.01;
    mj_markStack(d);
    mjtNum *acceleration = mj_stackAllocNum(d, (size_t)m->nv), *start = mj_stackAllocNum(d, (size_t)m->nv);
    mju_copy(acceleration, d->qacc, m->nv);
    mju_copy(start, d->qacc_warmstart, m->nv);
    mj_referenceConstraint(m, d);
    mj_rne(m, d, 0, d->qfrc_bias);
    double change = INFINITY;
    for (int pass = 0; pass < PASSES && change > settled; pass++) {
        solve(m, d);
        change = 0;
        for (int i = 0; i < m->nplugin; i++)
            if (is_ours(m, i)) change = fmax(change, correct(m, d, i, 0, 1));
    }
    mju_copy(d->qacc, acceleration, m->nv);
    mju_copy(d->qacc_warmstart, start, m->nv);
    mj_freeStack(d);
}

/* Keeps the normal forces of this step with the pairs that they belong to. A pair without a place has the law at its current load. */
static void add_loads(const mjModel *m, mjData *d, int instance) {
    surface *here = surface_of(d, instance);
    const size_t most = here->most_pairs;
    for (points pair = {NULL, 0}; (pair = next_pair(m, d, instance, pair)).first;) {
        if (asperity_pairs_add(memory_of(m, d, instance)->pairs, most, (uint64_t)pair.first->geom[0], (uint64_t)pair.first->geom[1],
                               load_of(d, pair)) || here->crowded) continue;
        here->crowded = 1;
        mju_warning(PLUGIN ", instance '%s': more than most_pairs = %zu pairs of geoms touch: those beyond have the law at their current "
                    "load%s, and steps are solved several times; give <config key=\"most_pairs\" value=\"%zu\"/>", instance_name(m, instance),
                    most, here->held_width > 0 ? " without microslip" : "", 2 * most);
    }
}

/* The warnings of a surface that stand in MuJoCo's log: one mask for all mjData of a program, of which there may be thousands. */
static _Atomic uint64_t *said_of(const asperity_params *params) {
    enum { SURFACES = 256 };
    static struct {
        asperity_params params;
        _Atomic uint64_t said;
    } surfaces[SURFACES];
    static size_t count;
    static atomic_flag busy = ATOMIC_FLAG_INIT;
    size_t i = 0;
    while (atomic_flag_test_and_set(&busy)) continue;
    while (i < count && memcmp(&surfaces[i].params, params, sizeof *params) != 0) i++;
    if (i == count && count < SURFACES) surfaces[count++].params = *params;
    atomic_flag_clear(&busy);
    return i < SURFACES ? &surfaces[i].said : NULL;
}

/* Tells each warning of a surface once, at the first load of a pair at which it is seen. */
static void tell_warnings(const mjModel *m, const mjData *d, int instance) {
    surface *here = surface_of(d, instance);
    const memory *known = memory_of(m, d, instance);
    for (size_t i = 0; i < here->most_pairs; i++) {
        const double load = known->pairs[i].taken ? known->pairs[i].known.load : 0;
        uint64_t warnings = asperity_told_anew(&here->told, here->model, load);
        if (warnings && here->said) warnings &= ~atomic_fetch_or(here->said, warnings);
        for (uint64_t bit = 1; bit <= warnings; bit *= 2) {
            if (!(warnings & bit)) continue;
            char text[512];
            asperity_warnings_text(bit, text, sizeof text);
            mju_warning(PLUGIN ", instance '%s', at a load of %g: %s", instance_name(m, instance), load, text);
        }
    }
}

/* ---- Microslip ---- */

static held_pairs held_of(const mjModel *m, const mjData *d, int instance) {
    const surface *here = surface_of(d, instance);
    double *places = (double *)(memory_of(m, d, instance)->pairs + here->most_pairs);
    return (held_pairs){places, here->most_pairs, here->held_width};
}

static void hold_pairs(const mjModel *m, mjData *d, int instance) {
    const held_pairs places = held_of(m, d, instance);
    for (points pair = {NULL, 0}; (pair = next_pair(m, d, instance, pair)).first;) {
        const held_pair *held = held_place(places, pair.first);
        if (held && held->taken != 0) hold(m, d, held, pair.first, pair.count);
    }
}

/* Writes the places anew, with those that touch: an open pair forgets. */
static void slide_pairs(const mjModel *m, mjData *d, int instance) {
    const held_pairs places = held_of(m, d, instance);
    const size_t all = places.count * places.width;
    mj_markStack(d);
    mjtNum *velocity = mj_stackAllocNum(d, (size_t)d->nefc);
    held_pairs before = places;
    before.places = mj_stackAllocNum(d, all);
    mju_copy(before.places, places.places, (int)all);
    mju_zero(places.places, (int)all);
    if (d->nefc > 0) mj_mulJacVec(m, d, velocity, d->qvel);
    for (points pair = {NULL, 0}; (pair = next_pair(m, d, instance, pair)).first;) {
        const held_pair *old = held_place(before, pair.first);
        held_pair *held = held_place(places, pair.first);
        if (!held) continue; /* add_loads tells */
        if (old && old->taken != 0) mju_copy((double *)held, (const double *)old, (int)places.width);
        if (!slide(m, d, surface_of(d, instance)->model, velocity, pair.first, pair.count, load_of(d, pair), held))
            mju_zero((double *)held, (int)places.width);
    }
    mj_freeStack(d);
}

int asperity_mujoco_solve(const mjModel *m, mjData *d) {
    /* A change of 1 that is halved is settled after 37 passes: enough are left for it. Friction is then that of the law to
     * a hundredth of the 1e-9 that hosts/mujoco/slider.py demands. */
    enum { PASSES = 50, SIMPLE = 8 };
    const double settled = 1e-11;
    for (int pass = 1; pass <= PASSES; pass++) {
        double change = 0;
        solve(m, d);
        /* Half the change where the whole one does not settle: where friction raises its own normal force. */
        for (int i = 0; i < m->nplugin; i++)
            if (is_ours(m, i)) change = fmax(change, correct(m, d, i, 1, pass <= SIMPLE ? 1 : 0.5));
        if (change <= settled) return pass;
    }
    mju_warning(PLUGIN ": friction and normal force do not settle in %d passes at time %g", PASSES, d->time);
    return -1;
}

/* ---- What MuJoCo calls ---- */

static int state_size(const mjModel *m, int instance) {
    asperity_params params;
    asperity_model *model = NULL;
    refuse_options(m, instance);
    named_by(m, instance, NULL);
    time_constant(m, instance);
    read_params(m, instance, &params);
    if (asperity_create(&params, &model) != ASPERITY_OK) refuse_as_library(m, instance);
    const size_t held = has_microslip(m, instance) ? held_width(model) : 0;
    asperity_free(model);
    return (int)(offsetof(memory, pairs) / sizeof(mjtNum) +
                 most_pairs(m, instance) * (sizeof(asperity_body_pair) / sizeof(mjtNum) + held));
}

static int make(const mjModel *m, mjData *d, int instance) {
    asperity_params params;
    read_params(m, instance, &params);
    surface *made = mju_malloc(sizeof *made);
    *made = (surface){.most_pairs = most_pairs(m, instance), .said = said_of(&params)};
    read_named_pairs(m, made);
    d->plugin_data[instance] = (uintptr_t)made;
    if (asperity_create(&params, &made->model) != ASPERITY_OK) refuse_as_library(m, instance);
    made->held_width = has_microslip(m, instance) ? held_width(made->model) : 0;
    return 0;
}

static void destroy(mjData *d, int instance) {
    surface *made = surface_of(d, instance);
    if (!made) return;
    asperity_free(made->model);
    mju_free(made->named);
    mju_free(made);
    d->plugin_data[instance] = 0;
}

static void reset(const mjModel *m, mjtNum *plugin_state, void *plugin_data, int instance) {
    (void)plugin_data;
    mju_zero(plugin_state, m->plugin_statenum[instance]);
}

/* The first instance does what is to be done for all: new pairs of several are solved ahead once. */
static void compute(const mjModel *m, mjData *d, int instance, int capability) {
    int unknown = 0;
    (void)capability;
    for (int i = 0; i < instance; i++)
        if (is_ours(m, i)) return;
    refuse_options(m, instance);
    for (int i = instance; i < m->nplugin; i++) {
        if (!is_ours(m, i)) continue;
        unknown += set_coefficients(m, d, i);
        if (surface_of(d, i)->held_width > 0) hold_pairs(m, d, i);
    }
    if (unknown > 0) solve_ahead(m, d);
}

static void advance(const mjModel *m, mjData *d, int instance) {
    const surface *here = surface_of(d, instance);
    memory *known = memory_of(m, d, instance);
    refuse_options(m, instance);
    add_loads(m, d, instance);
    if (here->held_width > 0) slide_pairs(m, d, instance);
    asperity_pairs_end_step(known->pairs, here->most_pairs, known->time, time_constant(m, instance));
    tell_warnings(m, d, instance);
}

mjPLUGIN_LIB_INIT(asperity) {
    mjpPlugin plugin;
    mjp_defaultPlugin(&plugin);
    plugin.name = PLUGIN;
    plugin.nattribute = KEY_COUNT;
    plugin.attributes = KEYS;
    plugin.capabilityflags = mjPLUGIN_PASSIVE;
    plugin.nstate = state_size;
    plugin.init = make;
    plugin.destroy = destroy;
    plugin.reset = reset;
    plugin.compute = compute;
    plugin.advance = advance;
    mjp_registerPlugin(&plugin);
}
