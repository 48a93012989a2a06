/* When is a lagged normal force stable? A hinged arm in ODE presses its tip on a moving belt (SI units). The belt pulls
 * the tip towards the hinge, a leading brake shoe: the balance of moments, N l = M + F H, makes N grow with mu, and mu
 * falls with N. With mu taken from the force of the step before, each step multiplies the error by the gain
 *     g = -dln(mu)/dln(N) * mu H/(l - mu H),     positive, with an alternating sign: unstable where g > 1.
 * A trailing shoe has l + mu H there: its gain is below 1 as long as F grows with N, so it is always stable.
 *
 * usage: arm [FILE.svg]        measures the gains; draws the errors step by step */
#define _GNU_SOURCE
#include <fenv.h>
#include <math.h>

#define HOST "ode"
#include "../verdict.h"
#include "law_step.h"

enum { STEPS = 60, CASES = 4 };
static const double hinge_height = 0.1, tip_radius = 0.005, belt_speed = 1, normal_force = 500;

typedef struct arm_case {
    double gain;                   /* wanted; negative: the belt runs the other way, a trailing shoe */
    double lagged[STEPS], current[STEPS];   /* |N/N* - 1| after each step */
    double measured_gain;
} arm_case;

/* The arm's reach and the moment on it, such that N* = normal_force has the gain wanted. */
static void reach_and_moment(const asperity_model *model, double gain, double *reach, double *moment) {
    asperity_state state = {.struct_size = sizeof state};
    if (asperity_state_at_load(model, normal_force, &state) != ASPERITY_OK) fail("no state at %g N", normal_force);
    const double mu = state.friction_coefficient;
    const double elasticity = -state.dmu_dload * state.load / mu;      /* -dln(mu)/dln(N) */
    *reach = hinge_height * mu * (1 + elasticity / gain);              /* of gain < 0: l + mu H in place of l - mu H */
    if (gain < 0) *reach = hinge_height * mu * (elasticity / -gain - 1);
    *moment = normal_force * (*reach - (gain > 0 ? 1 : -1) * mu * hinge_height);
}

/* Steps an arm from a normal force off by 1e-3, and notes how far off it is after each step. */
static void run_arm(const asperity_model *model, double gain, int max_passes, double *error) {
    double reach, moment;
    dMass inertia;
    reach_and_moment(model, gain, &reach, &moment);
    if (reach <= 0) fail("no arm has the gain %g", gain);
    const dWorldID world = dWorldCreate();
    const dSpaceID space = dHashSpaceCreate(0);
    dWorldSetCFM(world, 0);
    dWorldSetERP(world, 0);              /* the tip stays where it is: nothing but N changes */
    dCreatePlane(space, 0, 0, 1, 0);
    const dBodyID arm = dBodyCreate(world);
    dMassSetSphereTotal(&inertia, 1, 0.05);
    dBodySetMass(arm, &inertia);
    dGeomSetBody(dCreateSphere(space, tip_radius), arm);
    dBodySetPosition(arm, reach, 0, tip_radius - 1e-12);
    const dJointID hinge = dJointCreateHinge(world, 0);
    dJointAttach(hinge, arm, 0);
    dJointSetHingeAnchor(hinge, 0, 0, hinge_height);
    dJointSetHingeAxis(hinge, 0, 1, 0);

    law_stepper stepper;
    law_stepper_init(&stepper, world, space);
    stepper.body[0] = arm;
    stepper.bodies = 1;
    stepper.quick = 1;
    dWorldSetQuickStepNumIterations(world, 20000);   /* near jamming it converges slowly */
    stepper.model = model;
    stepper.max_passes = max_passes;
    stepper.first_load = normal_force * 1.001;
    stepper.surface_velocity = gain > 0 ? -belt_speed : belt_speed;
    for (int step = 0; step < STEPS; step++) {
        dBodyAddTorque(arm, 0, moment, 0);
        if (law_stepper_step(&stepper, 1e-4) == 0) fail("%s", stepper.failure);
        const double found = stepper.pairs == 1 ? stepper.pair[0].normal_force : 0;   /* 0: thrown off the belt */
        error[step] = fabs(found / normal_force - 1);
    }
    law_stepper_destroy(&stepper);
    dSpaceDestroy(space);
    dWorldDestroy(world);
}

static double x_of(int step) { return 62 + 340.0 * step / (STEPS - 1); }

static double y_of(double error) { return 44 + 250.0 * (1 - log10(fmax(error, 1e-12))) / 13; }

/* A line with its label next to the error after the step label_step, raised by some points. It ends where the arm has left
 * the belt. */
static void draw_line(FILE *svg, const double *error, const char *colour, const char *dash, int label_step,
                      int rise, const char *label) {
    int last = 0;
    while (last < STEPS - 1 && error[last] < 1) last++;
    fprintf(svg, "<polyline fill=\"none\" stroke=\"%s\" stroke-width=\"1.5\" stroke-dasharray=\"%s\" points=\"",
            colour, dash);
    for (int step = 0; step <= last; step++) fprintf(svg, "%.1f,%.1f ", x_of(step), y_of(fmin(error[step], 10)));
    fprintf(svg, "\"/>\n");
    if (error[last] >= 1)
        fprintf(svg, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\"/>\n", x_of(last),
                y_of(fmin(error[last], 10)), colour);
    if (label_step > last) label_step = last;
    fprintf(svg, "<text x=\"%.1f\" y=\"%.1f\" fill=\"%s\">%s</text>\n", x_of(label_step) + 8,
            y_of(fmin(error[label_step], 10)) + 4 - rise, colour, label);
}

static void draw(const char *path, const arm_case *cases) {
    static const char *const power[] = {"1", "10⁻²", "10⁻⁴", "10⁻⁶", "10⁻⁸", "10⁻¹⁰", "10⁻¹²"};
    FILE *svg = fopen(path, "w");
    if (!svg) fail("cannot write %s", path);
    fprintf(svg, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 420 350\" font-family=\"DejaVu Sans, sans-serif\" "
                 "font-size=\"12\">\n<rect width=\"420\" height=\"350\" fill=\"white\"/>\n");
    for (int i = 0; i < 7; i++) {
        const double y = y_of(pow(10, -2 * i));
        fprintf(svg, "<line x1=\"62\" x2=\"402\" y1=\"%.1f\" y2=\"%.1f\" stroke=\"#ddd\"/>\n", y, y);
        fprintf(svg, "<text x=\"56\" y=\"%.1f\" text-anchor=\"end\">%s</text>\n", y + 4, power[i]);
    }
    for (int step = 0; step < STEPS; step += 10)
        fprintf(svg, "<text x=\"%.1f\" y=\"316\" text-anchor=\"middle\">%d</text>\n", x_of(step), step);
    fprintf(svg, "<text x=\"232\" y=\"338\" text-anchor=\"middle\">time step [–]</text>\n"
                 "<text x=\"8\" y=\"16\" font-weight=\"bold\">A lagged normal force is stable for gains below 1</text>\n"
                 "<text x=\"8\" y=\"32\">relative error of the normal force |N/N* − 1| [–]; gain g</text>\n");
    draw_line(svg, cases[0].lagged, "#009e73", "none", 22, 8, "trailing, g = 0.03");
    draw_line(svg, cases[1].lagged, "#0072b2", "none", 15, 2, "lagged, g = 0.5");
    draw_line(svg, cases[2].lagged, "#b37f00", "none", 36, 12, "lagged, g = 0.9");
    draw_line(svg, cases[3].lagged, "#d55e00", "none", STEPS - 1, 0, "g = 1.2: leaves the belt");
    draw_line(svg, cases[3].current, "#d55e00", "2 4", 36, 9, "current, g = 1.2");
    fprintf(svg, "</svg>\n");
    if (fclose(svg) != 0) fail("cannot write %s", path);
}

int main(int count, char **arguments) {
    arm_case cases[CASES] = {{.gain = -0.03}, {.gain = 0.5}, {.gain = 0.9}, {.gain = 1.2}};
    int good = 1;
    dInitODE2(0);
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    asperity_model *model = law_of_contact();
    if (!surface_holds(model, 0.1 * normal_force, 10 * normal_force))
        fail("the model does not hold for the surface at these loads");
    for (int i = 0; i < CASES; i++) {
        arm_case *c = &cases[i];
        run_arm(model, c->gain, 1, c->lagged);
        run_arm(model, c->gain, 30, c->current);
        c->measured_gain = c->lagged[3] / c->lagged[2];
        /* An error e off the fixed point changes the gain by some multiple of e, here 1e-3 at most. */
        good &= fabs(c->measured_gain / fabs(c->gain) - 1) < 0.02 && c->current[STEPS - 1] < 1e-9;
        printf("arm: gain %.2f, measured %.4f; after %d steps N is off by %.0e, with the current force by %.0e\n",
               fabs(c->gain), c->measured_gain, STEPS, c->lagged[STEPS - 1], c->current[STEPS - 1]);
    }
    if (count > 1) draw(arguments[1], cases);
    asperity_free(model);
    dCloseODE();
    if (!good) fail("the arm's gain of lagged forces, or its current force, is not as mechanics has it");
    return 0;
}
