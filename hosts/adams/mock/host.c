/* Calls the contact friction subroutine as Adams's C interface does, with floating-point traps on, and checks the forces:
 * of single calls, of a block that brakes, and what it says about wrong input. */

#define _GNU_SOURCE
#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "../../surface.h"
#include "slv_c_utils.h"

adams_c_Cffsub Cffsub;

enum { NUMBERS = 4, MISSING = 9 };
static const double nominal_area = 1e-4, creep_speed = 1e-4, lightest = 1, heaviest = 5000;
static const double force_limit = 1e-6, braking_limit = 1e-6;

static char stopped[640];
static int stopped_contact;

void c_errmes(int errflg, const char *mesage, int id, const char *endflg) {
    if (errflg == 0 || strcmp(endflg, "STOP") != 0) return;
    snprintf(stopped, sizeof stopped, "%s", mesage);
    stopped_contact = id;
}

/* The STRING statements of the model: surface files, of which those after the first are written here. */
static char strings[4][4200] = {"hosts/surface.toml"};

void c_gtstrg(int id, char *string, int *nchars, int *istat) {
    *istat = id < 1 || id > 4;
    if (*istat == 0) *nchars = (int)strlen(strcpy(string, strings[id - 1]));
}

static void fail(const char *what) {
    printf("adams  FAIL  %s\n", what);
    exit(1);
}

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

typedef struct contact {
    double par[NUMBERS];
    struct sAdamsContactFriction adams;
} contact;

/* In a model whose unit of length is so many metres. */
static void set_contact(contact *c, int id, double length) {
    memset(c, 0, sizeof *c);
    c->par[0] = creep_speed;
    c->par[1] = id;
    c->par[2] = length;
    c->par[3] = 1;
    c->adams.contact.ID = id;
    c->adams.NPAR = NUMBERS;
    c->adams.PAR = c->par;
}

static void write_surface(int id, const char *folder, const char *name, const char *text) {
    snprintf(strings[id - 1], sizeof strings[0], "%s/%s", folder, name);
    FILE *file = fopen(strings[id - 1], "w");
    if (!file || fputs(text, file) == EOF || fclose(file) != 0) fail(strings[id - 1]);
}

/* Place, deformation and spin are nothing to the law: any numbers will do. */
static void call(const contact *c, double vx, double vy, double normal, int iflag, double *force) {
    const double loci[] = {1, 2, 3}, locj[] = {4, 5, 6}, x[] = {7, 8, 9}, xdot[] = {vx, vy, 10};
    force[0] = force[1] = force[2] = 1e300;
    stopped[0] = 0;
    Cffsub(&c->adams, 0.5, loci, locj, x, xdot, normal, 11, 0, iflag, force);
}

/* The force against the exact law at all loads and in all directions, relative to it. */
static double worst_force(const contact *c, const asperity_model *model) {
    double worst = 0, force[3];
    asperity_state state = {.struct_size = sizeof state};
    for (double normal = lightest; normal <= heaviest; normal *= 1.3)
        for (int i = 0; i < 16; i++) {
            const double angle = 0.1 + i * M_PI / 8, speed = i % 2 ? 1 : creep_speed;
            if (asperity_state_at_load(model, normal, &state) != ASPERITY_OK) fail("no exact state");
            call(c, speed * cos(angle), speed * sin(angle), normal, 0, force);
            const double exact = state.friction_force * tanh(speed / creep_speed);
            worst = worse(worst, hypot(force[0] + exact * cos(angle), force[1] + exact * sin(angle)) / exact);
            if (force[2] != 0 || stopped[0]) fail("a force beyond the plane, or a message");
        }
    return worst;
}

/* A block of 1 kg slides aslant under 50 N until it creeps, by the method of Runge and Kutta. Its speed has a closed form:
 * sinh(v/v0) falls exponentially. */
static double worst_braking(const contact *c, const asperity_model *model) {
    const double normal = 50, start = 20 * creep_speed, angle = 0.7;
    asperity_state state = {.struct_size = sizeof state};
    if (asperity_state_at_load(model, normal, &state) != ASPERITY_OK) fail("no exact state");
    const double end = 25 * creep_speed / state.friction_force, step = end / 4000;
    double v[2] = {start * cos(angle), start * sin(angle)}, worst = 0;
    for (int n = 1; n <= 4000; n++) {
        static const double share[] = {0, 0.5, 0.5, 1}, weight[] = {1, 2, 2, 1};
        double k[3] = {0}, sum[2] = {0};
        for (int stage = 0; stage < 4; stage++) {
            call(c, v[0] + share[stage] * step * k[0], v[1] + share[stage] * step * k[1], normal, 0, k);
            for (int i = 0; i < 2; i++) sum[i] += weight[stage] * k[i] / 6;
        }
        for (int i = 0; i < 2; i++) v[i] += step * sum[i];
        const double fall = exp(-state.friction_force * n * step / creep_speed);
        const double exact = creep_speed * asinh(sinh(start / creep_speed) * fall);
        worst = worse(worst, hypot(v[0] - exact * cos(angle), v[1] - exact * sin(angle)) / start);
    }
    return worst;
}

static void demand_message(const contact *c, double vx, double normal, const char *wanted) {
    double force[3];
    call(c, vx, 0, normal, 0, force);
    if (!strstr(stopped, wanted) || stopped_contact != c->adams.contact.ID || force[0] != 0) {
        printf("adams: the message was '%s' of contact %d\n", stopped, stopped_contact);
        fail(wanted);
    }
}

static void check_refusals(const contact *good) {
    contact bad = *good;
    bad.adams.PAR = bad.par;
    bad.adams.contact.ID = 77;
    bad.adams.NPAR = 13;
    demand_message(&bad, 1, 10, "wants 4 numbers");
    bad.adams.NPAR = NUMBERS;
    bad.par[1] = MISSING;
    demand_message(&bad, 1, 10, "must be that of a STRING");
    bad.par[1] = 3;
    demand_message(&bad, 1, 10, "bad.toml: line 1: slip_radius_1 = 1.075e-8: must be at least 1; is it a length?");
    bad.par[1] = 4;
    demand_message(&bad, 1, 10, "missing.toml");
    bad.par[1] = good->par[1];
    bad.par[2] = 0;
    demand_message(&bad, 1, 10, "length = 0: must be");
    bad.par[2] = good->par[2];
    bad.par[0] = 0;
    demand_message(&bad, 1, 10, "v0 must be > 0");
    bad.par[0] = good->par[0];
    demand_message(&bad, INFINITY, 10, "must be finite");
    for (int i = 0; i < 64; i++) {
        double force[3];
        bad.par[2] = 1e-3 * (1.001 + 0.001 * i);
        call(&bad, 1, 0, 10, 0, force);
        if ((i < 62) != (stopped[0] == 0)) fail("the number of surfaces is not 64");
    }
    demand_message(&bad, 1, 10, "more than 64 surfaces");
}

int main(int argc, char **argv) {
    const double start = now();
    const char *bad = "slip_radius_1 = 10.75e-9\n";
    char text[4000];
    if (argc != 2) fail("usage: host FOLDER");
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    asperity_params params;
    asperity_model *model = NULL, *other_model = NULL;
    if (set_surface(&params, nominal_area) != ASPERITY_OK || asperity_create(&params, &model) != ASPERITY_OK)
        fail("no surface");
    if (!surface_holds(model, lightest, heaviest)) fail("the model does not hold for the surface at these loads");
    contact carbon, rougher;
    set_contact(&carbon, 1, 1);
    params.height_std *= 2;
    params.pressure_coefficient = 0.05;
    if (asperity_params_calibrate(&params, 100, 0.2) != ASPERITY_OK) fail("no calibrated surface");
    if (asperity_create(&params, &other_model) != ASPERITY_OK) fail("no second surface");
    if (asperity_params_text(&params, text, sizeof text) >= sizeof text - 100) fail("a text that is too long");
    write_surface(2, argv[1], "rougher.toml", text);
    set_contact(&rougher, 2, 1e-3);
    memmove(text + strlen(bad), text, strlen(text) + 1);
    memcpy(text, bad, strlen(bad));
    write_surface(3, argv[1], "bad.toml", text);
    snprintf(strings[3], sizeof strings[3], "%s/missing.toml", argv[1]);

    double force[3];
    call(&carbon, 1, 0, 10, 1, force);
    if (force[0] != 0 || force[1] != 0 || force[2] != 0 || stopped[0]) fail("a force where dependencies are asked for");
    call(&carbon, 0, 0, 10, 0, force);
    if (force[0] != 0 || force[1] != 0 || stopped[0]) fail("a force without slip");
    const double worst = worse(worst_force(&carbon, model), worst_force(&rougher, other_model));
    const double braking = worst_braking(&carbon, model);
    check_refusals(&carbon);
    asperity_free(model);
    asperity_free(other_model);

    const int pass = worst <= force_limit && braking <= braking_limit;
    printf("adams  %s  max |F - F(N)|/F(N) = %.0e (limit %.0e), braking against its closed form %.0e (limit %.0e)  "
           "%.1f s\n", pass ? "PASS" : "FAIL", worst, force_limit, braking, braking_limit, now() - start);
    return !pass;
}
