/* Calls asperity_modelica.h as a Modelica tool does: constructor, functions, destructor, and errors that do not return.
 * Exit status: 0 where the friction force is that of the C interface, a measured point is met, and errors and warnings arrive. */

#define _GNU_SOURCE

#include <asperity_modelica.h>

#include <fenv.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static jmp_buf simulation;
static char reported[512];
static char told[4096];
static int failures;

void ModelicaFormatError(const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(reported, sizeof reported, format, arguments);
    va_end(arguments);
    longjmp(simulation, 1);
}

void ModelicaFormatMessage(const char *format, ...)
{
    va_list arguments;
    const size_t length = strlen(told);

    va_start(arguments, format);
    vsnprintf(told + length, sizeof told - length, format, arguments);
    va_end(arguments);
}

static void expect(int holds, const char *what)
{
    if (!holds) {
        fprintf(stderr, "does not hold: %s\n", what);
        failures++;
    }
}

static void *measured(double sigma, double load, double coefficient, double force)
{
    return asperity_modelica_create(160e9, 0.22, 160e9, 0.22, 0.063, 0.384e-9, 0.384e-9, sigma, 1e-6, 1e5, 0, load, coefficient,
                                    force);
}

static void *polysilicon(double sigma)
{
    return measured(sigma, 0, 0, 0);
}

static void friction_is_a_function_with_a_derivative(void)
{
    const double load = 1e-3, step = 1e-7;
    void *law = polysilicon(5e-9);
    const double difference =
        (asperity_modelica_force(law, load + step) - asperity_modelica_force(law, load - step)) / (2 * step);

    expect(fabs(asperity_modelica_slope(law, load) / difference - 1) < 1e-6, "the slope is that of the force");
    expect(asperity_modelica_force(law, load) == asperity_friction_at_load(((asperity_modelica_law *)law)->model, load) * load, "F = mu P");
    expect(asperity_modelica_force(law, 0) > 0, "adhesion gives friction at zero load");
    expect(asperity_modelica_force(law, -1) == 0 && asperity_modelica_slope(law, -1) == 0, "a contact that came apart");
    asperity_modelica_free(law);
}

/* How often a text was told. */
static int times_told(const char *text)
{
    int times = 0;

    for (const char *at = told; (at = strstr(at, text)) != NULL; at++)
        times++;
    return times;
}

static void a_measured_point_is_met(void)
{
    void *laws[] = {measured(5e-9, 1e-3, 0.2, 0), measured(5e-9, 1e-3, 0, 2e-4)};

    told[0] = '\0';
    for (int i = 0; i < 2; i++) {
        expect(fabs(asperity_modelica_force(laws[i], 1e-3) / 2e-4 - 1) < 1e-9, "the measured force");
        asperity_modelica_free(laws[i]);
    }
    expect(times_told("strength of the interface") == 0, "a calibrated law has no warning of its strength");
}

static void warnings_are_told_once(void)
{
    void *law = polysilicon(5e-9);

    told[0] = '\0';
    for (int i = 0; i < 100; i++)
        asperity_modelica_force(law, 1e-3 + 1e-5 * i);
    expect(times_told("asperity: warning at a load of 0.001 N: the strength of the interface is the default") == 1, told);
    expect(times_told("fewer than 20 summits") == 0, told);
    asperity_modelica_force(law, 1e-6);
    expect(times_told("warning at a load of 1e-06 N: fewer than 20 summits") == 1, told);
    asperity_modelica_free(law);
}

static void errors_reach_the_tool(void)
{
    if (setjmp(simulation) == 0) {
        polysilicon(-1);
        expect(0, "height_std = -1 is refused");
    }
    expect(strncmp(reported, "asperity: height_std = -1: ", 27) == 0, reported);
    if (setjmp(simulation) == 0) {
        measured(5e-9, 1e-3, 0, 0);
        expect(0, "a load without what was measured at it is refused");
    }
    expect(strncmp(reported, "asperity: calibration_load: must be given together", 50) == 0, reported);
}

int main(void)
{
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    friction_is_a_function_with_a_derivative();
    a_measured_point_is_met();
    warnings_are_told_once();
    errors_reach_the_tool();
    return failures != 0;
}
