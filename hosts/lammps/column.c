/* A packed column of grains in LAMMPS, between smooth walls on a belt that starts to move, on any number of MPI ranks
 * (SI units). Normal contact and friction are computed in a callback of fix external; friction never exceeds the law at
 * the pressure of the contact. The grains are softened, so that the time step may be long; the law is asked at the
 * pressure that the real grain would have. Every rank has its own model.
 *
 * usage: column FIGURES.txt [MU]              runs, with a constant mu if given, and writes figures
 *        column compare ONE.txt TWO.txt MU.txt      judges the runs on one rank, on two, and with a constant mu */
#define _GNU_SOURCE
#define LAMMPS_LIB_MPI
#include <mpi.h>

#include <fenv.h>
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <lammps/library.h>

#include "../surface.h"

enum { NX = 10, NY = 4, NZ = 10, GRAINS = NX * NY * NZ, SETTLE_STEPS = 15000, SHEAR_STEPS = 5000, SAMPLE_EVERY = 500 };
/* Acrylic glass with a hard film: E = 3 GPa, nu = 0.38 of both grains. */
static const double diameter = 0.01, density = 1190, gravity = 9.81, time_step = 1e-5;
static const double real_modulus = 3e9 / (2 * (1 - 0.38 * 0.38));
static const double soft_modulus = 5e6;           /* as is usual with grains: the time step depends on it */
static const double belt_speed = 0.3;
static const double spacing = 0.0105, width = NX * 0.0105, depth = NY * 0.0105;

/* Grains amplify rounding, which differs with the number of ranks: by some ten decades in this run. */
static const double law_limit = 1e-6, least_held = 0.99;
static const double balance_limit = 1e-9, energy_limit = 1e-2, agreement_limit = 1e-3;

static _Noreturn void fail(const char *format, ...) {
    int running = 0, rank = 0, over = 0;
    MPI_Initialized(&running);
    if (running) MPI_Finalized(&over);
    running = running && !over;
    if (running) MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    va_list arguments;
    va_start(arguments, format);
    if (running) printf("column: rank %d: ", rank);    /* run.sh says FAIL once, whatever the number of ranks */
    else printf("lammps  FAIL  ");
    vprintf(format, arguments);
    printf("\n");
    fflush(stdout);
    va_end(arguments);
    if (running) MPI_Abort(MPI_COMM_WORLD, 1);
    exit(1);
}

/* The model is that of one m2 of nominal contact: its load is then a pressure, its force a shear stress, and a contact
 * of area A that carries N has the friction A F(N/A), however A changes with N. */
static asperity_model *film_per_area(void) {
    asperity_params params;
    asperity_model *model = NULL;
    char message[400];
    if (set_surface(&params, 1) == ASPERITY_OK && asperity_create(&params, &model) == ASPERITY_OK) return model;
    asperity_last_error(message, sizeof message);
    fail("%s", message);
}

/* Sums over the contacts of this rank; a contact between two ranks counts half on each. */
typedef struct sums {
    double elastic_energy;                   /* now */
    double floor_normal, floor_shear;        /* forces of the belt on the grains, now */
    double wall_force;                       /* of both walls along x, now */
    double friction_loss, damping_loss, belt_work;    /* power, now */
    double contacts, sliding;                /* numbers, now */
} sums;

enum { SUMS = sizeof(sums) / sizeof(double) };

typedef struct column {
    void *lammps;
    asperity_model *model;
    double constant_mu;                      /* used where model is NULL */
    double belt;                             /* speed */
    int rank, ranks, neighbours;
    sums now;
    sums integral;                           /* over time, by the trapezoidal rule of the integrator */
    int64_t first_step, last_step;           /* of the integral */
    double excess;                           /* largest friction over the exact law, less 1 */
    double sampled, held;                    /* load that the exact law was asked at; of that where the model holds */
    double contacting;                       /* summits that touch, times the load that was sampled */
    double checking;                         /* seconds spent on finding it */
} column;

typedef struct contact {
    double radius, mass;                     /* effective ones */
    double overlap, normal[3], velocity[3];  /* of the first body against the second, at the contact */
    double share;                            /* of the sums: 1, or 1/2 where another rank has it too */
    double load, friction[3];                /* on the first body */
} contact;

/* Processor time, in which other programs have no part. */
static double now(void) { return (double)clock() / CLOCKS_PER_SEC; }

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void cross(const double *a, const double *b, double *c) {
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

/* Greatest friction of a contact: the law at the mean pressure on the Hertzian area pi (3 N R/(4 E))^(2/3) on which the
 * real grain carries the load. That of the soft one is (E_real/E_soft)^(2/3) times as large. */
static double greatest_friction(const column *c, double load, double radius) {
    if (!c->model) return c->constant_mu * load;
    const double a = cbrt(0.75 * load * radius / real_modulus), area = M_PI * a * a;
    return area > 0 ? area * asperity_friction_force_at_load(c->model, load / area) : 0;
}

/* Compares with the exact law at the area of the soft contact, pi R overlap, made that of the real one. What damping
 * adds to the load, or takes, the real grain too would carry on an area that goes with N^(2/3). */
static void note_contact(column *c, const contact *k, double elastic, double friction) {
    asperity_state state = {0};
    const double start = now(), softened = real_modulus / soft_modulus * elastic / k->load;
    const double area = M_PI * k->radius * k->overlap / pow(softened, 2.0 / 3), pressure = k->load / area;
    state.struct_size = sizeof state;
    if (asperity_state_at_load(c->model, pressure, &state) != ASPERITY_OK) fail("no exact state at %g Pa", pressure);
    const int holds = state.warnings == 0 && state.contacting * area >= 20;   /* the model is of 1 m2 */
    c->excess = fmax(c->excess, friction / (area * state.friction_force) - 1);
    c->sampled += k->share * k->load;
    c->held += holds ? k->share * k->load : 0;
    c->contacting += k->share * k->load * state.contacting * area;
    c->checking += now() - start;
}

/* Hertz with a damping ratio of 0.3; friction is viscous while it is below the law, without memory of the slip. */
static void set_forces(column *c, contact *k, int sample) {
    const double stiffness = soft_modulus * sqrt(k->radius * k->overlap);    /* of overlap, times 4/3; dN = 2 */
    const double approach = -dot(k->velocity, k->normal);
    const double elastic = 4.0 / 3 * stiffness * k->overlap;
    k->load = fmax(0, elastic + 2 * 0.3 * sqrt(2 * stiffness * k->mass) * approach);
    double slip[3];
    for (int a = 0; a < 3; a++) slip[a] = k->velocity[a] + approach * k->normal[a];
    const double speed = sqrt(dot(slip, slip));
    const double viscous = 0.05 * k->mass / time_step * speed, most = greatest_friction(c, k->load, k->radius);
    const double friction = fmin(viscous, most);
    for (int a = 0; a < 3; a++) k->friction[a] = speed > 0 ? -friction * slip[a] / speed : 0;
    if (sample && c->model && k->load > 0) note_contact(c, k, elastic, friction);

    c->now.elastic_energy += k->share * 0.4 * elastic * k->overlap;
    c->now.friction_loss += k->share * friction * speed;
    c->now.damping_loss += k->share * (k->load - elastic) * approach;
    c->now.contacts += k->share;
    c->now.sliding += viscous > most ? k->share : 0;
}

/* The grains as LAMMPS has them on this rank: owned ones first, then ghosts. */
typedef struct grains {
    int owned;
    double **x, **v, **omega, **torque, *radius, *mass, **force;
} grains;

/* Force of contact k on grain i, for which the contact lies along direction * normal from its centre. */
static void apply(const grains *g, int i, const contact *k, double sign) {
    double twist[3];
    cross(k->normal, k->friction, twist);
    for (int a = 0; a < 3; a++) {
        g->force[i][a] += sign * (k->load * k->normal[a] + k->friction[a]);
        g->torque[i][a] -= g->radius[i] * twist[a];
    }
}

static void meet_grain(column *c, const grains *g, int i, int j, int sample) {
    contact k = {.share = j < g->owned ? 1 : 0.5};
    double apart[3], spin[3], turning[3];
    for (int a = 0; a < 3; a++) apart[a] = g->x[i][a] - g->x[j][a];
    const double distance = sqrt(dot(apart, apart));
    k.overlap = g->radius[i] + g->radius[j] - distance;
    if (k.overlap <= 0) return;
    for (int a = 0; a < 3; a++) {
        k.normal[a] = apart[a] / distance;
        spin[a] = g->radius[i] * g->omega[i][a] + g->radius[j] * g->omega[j][a];
    }
    cross(spin, k.normal, turning);
    for (int a = 0; a < 3; a++) k.velocity[a] = g->v[i][a] - g->v[j][a] - turning[a];
    k.radius = g->radius[i] * g->radius[j] / (g->radius[i] + g->radius[j]);
    k.mass = g->mass[i] * g->mass[j] / (g->mass[i] + g->mass[j]);
    set_forces(c, &k, sample);
    apply(g, i, &k, 1);
    if (j < g->owned) apply(g, j, &k, -1);     /* a ghost gets its force where it is owned */
}

static void meet_plane(column *c, const grains *g, int i, double overlap, const double *normal, int sample) {
    if (overlap <= 0) return;
    contact k = {.share = 1, .overlap = overlap, .radius = g->radius[i], .mass = g->mass[i]};
    const int is_floor = normal[2] != 0;
    double turning[3];
    memcpy(k.normal, normal, sizeof k.normal);
    cross(g->omega[i], normal, turning);
    for (int a = 0; a < 3; a++) k.velocity[a] = g->v[i][a] - g->radius[i] * turning[a];
    if (is_floor) k.velocity[0] -= c->belt;
    if (!is_floor) k.velocity[1] = k.velocity[2] = 0;    /* smooth: no slip, no friction */
    set_forces(c, &k, is_floor && sample);
    apply(g, i, &k, 1);
    if (is_floor) {
        c->now.floor_normal += k.load;
        c->now.floor_shear += k.friction[0];
        c->now.belt_work += k.friction[0] * c->belt;
    } else {
        c->now.wall_force += k.load * normal[0];
    }
}

static void add_to_integral(column *c, int64_t step) {
    const double weight = step == c->first_step || step == c->last_step ? 0.5 * time_step : time_step;
    const double *now = (const double *)&c->now;
    double *integral = (double *)&c->integral;
    for (int s = 0; s < SUMS; s++) integral[s] += weight * now[s];
}

/* Of fix external: ids and positions of the owned grains; their forces are set here. */
static void contact_forces(void *data, int64_t step, int owned, int *ids, double **x, double **force) {
    (void)ids;
    column *c = data;
    const grains g = {.owned = owned, .x = x, .force = force,
                      .v = lammps_extract_atom(c->lammps, "v"), .omega = lammps_extract_atom(c->lammps, "omega"),
                      .torque = lammps_extract_atom(c->lammps, "torque"),
                      .radius = lammps_extract_atom(c->lammps, "radius"),
                      .mass = lammps_extract_atom(c->lammps, "rmass")};
    const int sample = step % SAMPLE_EVERY == 0;
    static const double up[3] = {0, 0, 1}, right[3] = {1, 0, 0}, left[3] = {-1, 0, 0};
    memset(&c->now, 0, sizeof c->now);
    for (int i = 0; i < owned; i++) force[i][0] = force[i][1] = force[i][2] = 0;
    const int listed = lammps_neighlist_num_elements(c->lammps, c->neighbours);
    for (int n = 0; n < listed; n++) {
        int i, count, *neighbour;
        lammps_neighlist_element_neighbors(c->lammps, c->neighbours, n, &i, &count, &neighbour);
        for (int m = 0; m < count; m++) meet_grain(c, &g, i, neighbour[m] & 0x3fffffff, sample);
    }
    for (int i = 0; i < owned; i++) {
        meet_plane(c, &g, i, g.radius[i] - x[i][2], up, sample);
        meet_plane(c, &g, i, g.radius[i] - x[i][0], right, sample);
        meet_plane(c, &g, i, x[i][0] + g.radius[i] - width, left, sample);
    }
    add_to_integral(c, step);
}

/* A lattice, loosened a little so that it packs as it settles; grains of unlike size, so that no crystal forms. */
static void create_grains(void *lammps) {
    static double x[3 * GRAINS];
    static int id[GRAINS], type[GRAINS];
    for (int n = 0; n < GRAINS; n++) {
        const int place[3] = {n % NX, n / NX % NY, n / (NX * NY)};
        id[n] = n + 1;
        type[n] = 1;
        for (int a = 0; a < 3; a++)
            x[3 * n + a] = spacing * (place[a] + 0.5) + 0.02 * diameter * sin(12.9898 * n + 78.233 * a);
    }
    const int created = lammps_create_atoms(lammps, GRAINS, id, type, x, NULL, NULL, 0);
    if (created != GRAINS) fail("%d of %d grains created", created, GRAINS);
}

static void command(void *lammps, const char *format, ...) {
    char text[300];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    lammps_command(lammps, text);
}

static void set_up(column *c) {
    char *arguments[] = {"column", "-log", "none", "-screen", "none"};
    void *lammps = c->lammps = lammps_open(5, arguments, MPI_COMM_WORLD, NULL);
    if (!lammps) fail("LAMMPS does not start");
    if (lammps_extract_setting(lammps, "tagint") != sizeof(int) || lammps_extract_setting(lammps, "bigint") != 8)
        fail("LAMMPS was built with other integer widths than this program");
    command(lammps, "units si");
    command(lammps, "atom_style sphere");
    command(lammps, "atom_modify map array");
    command(lammps, "newton off");                   /* both ranks compute a contact between them, each for its grain */
    command(lammps, "comm_modify vel yes");          /* ghosts know how fast they move and turn */
    command(lammps, "processors %d 1 1", c->ranks);
    command(lammps, "boundary f p f");
    command(lammps, "region box block %.17g %.17g 0 %.17g %.17g %.17g", -diameter, width + diameter, depth, -diameter,
            (NZ + 2) * spacing);
    command(lammps, "create_box 1 box");
    create_grains(lammps);
    command(lammps, "variable size atom %.17g*(1+0.08*sin(0.7*id*id))", diameter);
    command(lammps, "set group all diameter v_size");
    command(lammps, "set group all density %.17g", density);
    command(lammps, "pair_style zero %.17g nocoeff", 1.1 * diameter);
    command(lammps, "pair_coeff * *");
    command(lammps, "neighbor %.17g bin", 0.2 * diameter);
    command(lammps, "neigh_modify every 1 delay 0 check yes");
    command(lammps, "timestep %.17g", time_step);
    command(lammps, "fix move all nve/sphere");
    command(lammps, "fix weight all gravity %.17g vector 0 0 -1", gravity);
    command(lammps, "fix contact all external pf/callback 1 1");
    command(lammps, "compute kinetic all ke");
    command(lammps, "compute turning all erotate/sphere");
    command(lammps, "variable height equal xcm(all,z)");
    command(lammps, "variable weight equal mass(all)");
    command(lammps, "variable px equal vcm(all,x)*mass(all)");
    command(lammps, "variable pz equal vcm(all,z)*mass(all)");
    lammps_set_fix_external_callback(lammps, "contact", contact_forces, c);
    command(lammps, "run 0 post no");                /* makes the neighbour list */
    c->neighbours = lammps_find_pair_neighlist(lammps, "zero", 1, 0, 0);
    if (c->neighbours < 0) fail("no neighbour list");
}

static double variable(void *lammps, const char *name) {
    double *value = lammps_extract_variable(lammps, name, NULL);
    if (!value) fail("no variable %s", name);
    const double copy = *value;
    lammps_free(value);
    return copy;
}

static double compute(void *lammps, const char *name) {
    const double *value = lammps_extract_compute(lammps, name, 0, 0);
    if (!value) fail("no compute %s", name);
    return *value;
}

/* Runs, with the sums over time started anew. */
static void run(column *c, int64_t *step, int steps) {
    c->first_step = *step;
    c->last_step = *step + steps;
    memset(&c->integral, 0, sizeof c->integral);
    command(c->lammps, "run %d post no", steps);
    *step += steps;
}

static sums over_ranks(const sums *mine) {
    sums all;
    MPI_Allreduce(mine, &all, SUMS, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return all;
}

typedef struct energies {
    double kinetic, turning, elastic, height;
} energies;

static energies energies_of(column *c) {
    const double weight = variable(c->lammps, "weight") * gravity;
    return (energies){compute(c->lammps, "kinetic"), compute(c->lammps, "turning"), over_ranks(&c->now).elastic_energy,
                      weight * variable(c->lammps, "height")};
}

static double total(energies e) { return e.kinetic + e.turning + e.elastic + e.height; }

typedef struct figure {
    const char *name;
    double value;
} figure;

enum { FIGURES = 14 };

static void write_figures(const char *path, const figure *f) {
    FILE *file = fopen(path, "w");
    if (!file) fail("cannot write %s", path);
    for (int i = 0; i < FIGURES; i++) fprintf(file, "%s %.17g\n", f[i].name, f[i].value);
    if (fclose(file) != 0) fail("cannot write %s", path);
}

static void run_column(const char *path, column *c) {
    int64_t step = 0;
    set_up(c);
    const double start = now();
    run(c, &step, SETTLE_STEPS);
    const energies before = energies_of(c);
    const double px = variable(c->lammps, "px"), pz = variable(c->lammps, "pz");
    c->belt = belt_speed;
    run(c, &step, SHEAR_STEPS);
    const double seconds = now() - start - c->checking;
    const energies after = energies_of(c);
    const sums moved = over_ranks(&c->integral), now = over_ranks(&c->now);
    const double weight = variable(c->lammps, "weight") * gravity, duration = SHEAR_STEPS * time_step;
    double excess, sampled[3] = {c->sampled, c->held, c->contacting};
    MPI_Allreduce(&c->excess, &excess, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    MPI_Allreduce(MPI_IN_PLACE, sampled, 3, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    /* What the belt gives and gravity takes must be the change of momentum, whatever the grains do to each other. */
    const double x_gap = variable(c->lammps, "px") - px - moved.floor_shear - moved.wall_force;
    const double z_gap = variable(c->lammps, "pz") - pz - moved.floor_normal + weight * duration;
    const double gap = moved.belt_work - moved.friction_loss - moved.damping_loss - (total(after) - total(before));
    const figure figures[FIGURES] = {
        {"ranks", c->ranks}, {"seconds", seconds},
        {"kinetic_energy", after.kinetic + after.turning}, {"elastic_energy", after.elastic},
        {"height_energy", after.height}, {"shear_to_normal", moved.floor_shear / moved.floor_normal},
        {"contacts", now.contacts},
        {"sliding", moved.sliding / moved.contacts}, {"law_excess", excess},
        {"momentum_gap", hypot(x_gap, z_gap) / (weight * duration)}, {"energy_gap", fabs(gap) / moved.belt_work},
        {"friction_loss", moved.friction_loss}, {"held", c->model ? sampled[1] / sampled[0] : 0},
        {"summits", c->model ? sampled[2] / sampled[0] : 0},
    };
    if (c->rank == 0) write_figures(path, figures);
    lammps_close(c->lammps);
}

static void read_figures(const char *path, figure *f) {
    static char names[3 * FIGURES][32];
    static int used;
    FILE *file = fopen(path, "r");
    if (!file) fail("cannot read %s", path);
    for (int i = 0; i < FIGURES; i++) {
        if (fscanf(file, "%31s %lf", names[used], &f[i].value) != 2) fail("%s is cut off", path);
        f[i].name = names[used++];
    }
    fclose(file);
}

static double value_of(const figure *f, const char *name) {
    for (int i = 0; i < FIGURES; i++)
        if (strcmp(f[i].name, name) == 0) return f[i].value;
    fail("no figure %s", name);
}

static int judge(char **path) {
    static const char *const same[] = {"kinetic_energy", "elastic_energy", "height_energy", "shear_to_normal",
                                       "friction_loss", "contacts", "sliding"};
    figure one[FIGURES], two[FIGURES], constant[FIGURES];
    read_figures(path[0], one);
    read_figures(path[1], two);
    read_figures(path[2], constant);
    if (value_of(one, "ranks") != 1 || value_of(two, "ranks") != 2) fail("not runs on one and two ranks");
    double disagreement = 0;
    for (size_t i = 0; i < sizeof same / sizeof *same; i++) {
        const double a = value_of(one, same[i]), b = value_of(two, same[i]);
        printf("column: %-16s %.12g on one rank, %.12g on two\n", same[i], a, b);
        if (!isfinite(b / a)) fail("%s is not a number, or 0", same[i]);
        disagreement = fmax(disagreement, fabs(b / a - 1));
    }
    const double excess = fmax(value_of(one, "law_excess"), value_of(two, "law_excess"));
    const double momentum = fmax(value_of(one, "momentum_gap"), value_of(two, "momentum_gap"));
    const double energy = fmax(value_of(one, "energy_gap"), value_of(two, "energy_gap"));
    printf("column: momentum off by %.1e (limit %.0e), energy by %.1e (limit %.0e)\n", momentum, balance_limit, energy,
           energy_limit);
    printf("column: friction over the exact law by %.1e (limit %.0e)\n", excess, law_limit);
    const double held = fmin(value_of(one, "held"), value_of(two, "held"));
    printf("column: the model holds for contacts that carry %.4f of the load (at least %.2f); mean number of summits "
           "that touch, weighted by load: %.0f\n", held, least_held, value_of(one, "summits"));
    printf("lammps  cost  constant mu %.2f s; the law x %.2f\n", value_of(constant, "seconds"),
           value_of(one, "seconds") / value_of(constant, "seconds"));
    const int pass = disagreement <= agreement_limit && excess <= law_limit && excess > -0.01 &&
                     held >= least_held && momentum <= balance_limit && energy <= energy_limit &&
                     value_of(one, "sliding") > 0.1;
    printf("lammps  %s  one and two ranks differ by %.1e  (limit %.0e)  %.1f s\n", pass ? "PASS" : "FAIL", disagreement,
           agreement_limit, value_of(one, "seconds") + value_of(two, "seconds") + value_of(constant, "seconds"));
    return !pass;
}

int main(int count, char **arguments) {
    if (count == 5 && strcmp(arguments[1], "compare") == 0) return judge(arguments + 2);
    if (count < 2 || count > 3) fail("usage: column FIGURES.txt [MU] | column compare ONE.txt TWO.txt MU.txt");
    MPI_Init(&count, &arguments);
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    column c = {.excess = -1};
    MPI_Comm_rank(MPI_COMM_WORLD, &c.rank);
    MPI_Comm_size(MPI_COMM_WORLD, &c.ranks);
    if (count == 3) c.constant_mu = atof(arguments[2]);
    else c.model = film_per_area();
    run_column(arguments[1], &c);
    asperity_free(c.model);
    MPI_Finalize();
    return 0;
}
