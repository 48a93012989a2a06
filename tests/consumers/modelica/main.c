/* Calls asperity_modelica.h as a Modelica tool does: constructor, functions, destructor, and errors that do not return.
 * Exit status: 0 where the friction force is that of the C interface and errors arrive. */

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
static int failures;

void ModelicaFormatError(const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(reported, sizeof reported, format, arguments);
    va_end(arguments);
    longjmp(simulation, 1);
}

static void expect(int holds, const char *what)
{
    if (!holds) {
        fprintf(stderr, "does not hold: %s\n", what);
        failures++;
    }
}

static void *polysilicon(double sigma)
{
    return asperity_modelica_create(160e9, 0.22, 160e9, 0.22, 0.063, 0.384e-9, 0.384e-9, sigma, 1e-6, 1e5);
}

static void friction_is_a_function_with_a_derivative(void)
{
    const double load = 1e-3, step = 1e-7;
    void *law = polysilicon(5e-9);
    const double difference =
        (asperity_modelica_force(law, load + step) - asperity_modelica_force(law, load - step)) / (2 * step);

    expect(fabs(asperity_modelica_slope(law, load) / difference - 1) < 1e-6, "the slope is that of the force");
    expect(asperity_modelica_force(law, load) == asperity_friction_at_load(law, load) * load, "F = mu P");
    expect(asperity_modelica_force(law, 0) > 0, "adhesion gives friction at zero load");
    expect(asperity_modelica_force(law, -1) == 0 && asperity_modelica_slope(law, -1) == 0, "a contact that came apart");
    asperity_modelica_free(law);
}

static void errors_reach_the_tool(void)
{
    if (setjmp(simulation) == 0) {
        polysilicon(-1);
        expect(0, "height_std = -1 is refused");
    }
    expect(strncmp(reported, "asperity: height_std = -1: ", 27) == 0, reported);
}

int main(void)
{
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    friction_is_a_function_with_a_derivative();
    errors_reach_the_tool();
    return failures != 0;
}
