/* Calls asperity_modelica.h as a Modelica tool does: constructor, functions, destructor, and errors that do not return.
 * Exit status: 0 where the friction force is that of the C interface, and errors and warnings arrive. */

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

/* A surface with a line more. */
static const char *text_with(const char *line)
{
    static char text[1000];

    snprintf(text, sizeof text,
             "work_of_adhesion = 0.063\nadhesion_range = 0.384e-9\nburgers_vector = 0.384e-9\nsummit_radius = 1e-6\n"
             "asperity_count = 1e5\n%s\n[materials]\nE1 = 160e9\nnu1 = 0.22\nE2 = 160e9\nnu2 = 0.22\n",
             line);
    return text;
}

static void *changed(const char *line)
{
    return asperity_modelica_create("", text_with(line));
}

static void *polysilicon(void)
{
    return changed("height_std = 5e-9");
}

static void friction_is_a_function_with_a_derivative(void)
{
    const double load = 1e-3, step = 1e-7;
    void *law = polysilicon();
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

static void warnings_are_told_once(void)
{
    void *law = polysilicon();

    told[0] = '\0';
    for (int i = 0; i < 100; i++)
        asperity_modelica_force(law, 1e-3 + 1e-5 * i);
    expect(times_told("asperity: warning at a load of 0.001 N: the strength of the interface is the default") == 1, told);
    expect(times_told("fewer than 20 asperities") == 0, told);
    asperity_modelica_force(law, 1e-6);
    expect(times_told("warning at a load of 1e-06 N: fewer than 20 asperities") == 1, told);
    asperity_modelica_free(law);
}

static void errors_reach_the_tool(void)
{
    if (setjmp(simulation) == 0) {
        changed("height_std = -1");
        expect(0, "height_std = -1 is refused");
    }
    expect(strncmp(reported, "asperity: line 6: height_std = -1: ", 35) == 0, reported);
    if (setjmp(simulation) == 0) {
        changed("calibration_load = 1e-3");
        expect(0, "a load without what was measured at it is refused");
    }
    expect(strncmp(reported, "asperity: line 6: calibration_load: must be given together", 58) == 0, reported);
    if (setjmp(simulation) == 0) {
        asperity_modelica_create("missing.toml", "");
        expect(0, "a file that is missing is refused");
    }
    expect(strncmp(reported, "asperity: missing.toml: ", 24) == 0, reported);
}

static void a_text_changes_a_file(const char *program)
{
    char path[4096];
    FILE *file;
    void *law;

    snprintf(path, sizeof path, "%s.toml", program);
    file = fopen(path, "w");

    expect(file != NULL && fputs("pair = \"steel/steel\"\nheight_std = 0.3e-6\nsummit_radius = 1e-5\nasperity_count = 1e6\n", file) >= 0 &&
           fclose(file) == 0, "a surface file");
    told[0] = '\0';
    law = asperity_modelica_create(path, "calibration_load = 100\ncalibration_friction_coefficient = 0.16\n");
    expect(fabs(asperity_modelica_force(law, 100) / 16 - 1) < 1e-6, "the measured friction of a file and a text");
    expect(times_told("strength of the interface") == 0, "a calibrated law has no warning of its strength");
    asperity_modelica_free(law);
}

/* Each line changed once, beside a law that stays: each has the law of its own text, and the first is as before. */
static void each_altered_line_has_its_own_law(void)
{
    static const char *const lines[] = {
        "height_std = 8e-9", "height_std = 5e-9\nskew = -0.5", "height_std = 5e-9\npressure_coefficient = 0.05",
        "height_std = 5e-9\ncalibration_load = 1e-3\ncalibration_friction_force = 3e-4",
        "height_std = 5e-9\ncalibration_load = 1e-3\ncalibration_friction_coefficient = 0.2",
    };
    const double loads[] = {1e-4, 1e-2};
    void *first = polysilicon();

    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        void *law = changed(lines[i]);
        asperity_params params;
        asperity_model *model = NULL;

        expect(asperity_params_init(&params, sizeof params) == ASPERITY_OK &&
               asperity_params_set_text(&params, text_with(lines[i]), strlen(text_with(lines[i]))) == ASPERITY_OK &&
               asperity_create(&params, &model) == ASPERITY_OK, lines[i]);
        for (int k = 0; k < 2; k++)
            expect(asperity_modelica_force(law, loads[k]) == asperity_friction_force_at_load(model, loads[k]), lines[i]);
        expect(asperity_modelica_force(law, 1e-4) != asperity_modelica_force(first, 1e-4), lines[i]);
        asperity_free(model);
        asperity_modelica_free(law);
    }
    void *again = polysilicon();
    expect(asperity_modelica_force(again, 1e-4) == asperity_modelica_force(first, 1e-4), "the first law is as before");
    asperity_modelica_free(again);
    asperity_modelica_free(first);
}

int main(int argc, char **argv)
{
    (void)argc;
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    friction_is_a_function_with_a_derivative();
    a_text_changes_a_file(argv[0]);
    warnings_are_told_once();
    each_altered_line_has_its_own_law();
    errors_reach_the_tool();
    return failures != 0;
}
