/* Friction coefficient of a polysilicon MEMS contact against normal load, with its band, in SI units.
 *
 * usage: friction_curve [--table] [FIGURE [LOADS [LOWEST [HIGHEST]]]]
 *   --table  every digit of load, friction coefficient, its band, friction force, real area and contacts
 *   FIGURE   SVG file to draw the curve in; "-" or nothing for none
 *   LOADS    number of loads, 2 to 100000 (5, or 33 with --table)
 *   LOWEST   lowest load [N], > 0 (1e-4)
 *   HIGHEST  highest load [N], > LOWEST (1)
 *
 * Numbers go to standard output; warnings, if the model does not hold somewhere between the two loads, to standard error.
 * The figure begins farther below, and is grey where fewer than 20 asperities touch: there one pair of surfaces differs from
 * another. Exit status: 0, 1 if the library or a file refuses, 2 for a wrong command line. */

#include <asperity.h>

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FAILED = 1, USAGE = 2, MAX_LOADS = 100000, SUMMARY_LOADS = 5, TABLE_LOADS = 33 };

typedef struct options {
    int table;
    const char *figure;
    int loads;
    double lowest, highest;
} options;

typedef struct row {
    double load, mu, low, high, friction, area, contacts;
} row;

/* A rough and a smooth body of polysilicon that touch over a nominal area of 100 um x 100 um.
 *
 * measured: an ASSUMPTION, friction coefficient 0.3 at 10 mN to 5 %. No model predicts the strength of an interface: measure
 *   yours once, and write it here.
 * E, nu: 152 to 164 GPa for films of four makers (Sharpe, Jackson, Coles and LaVan, IMECE 2000, MEMS, 255-259);
 *   0.22 (Sharpe, Yuan, Vaidyanathan and Edwards, Proc. IEEE MEMS 1997, 424-429).
 * hardness: 12 GPa, at which silicon changes phase (Domnich, Aratyn, Kriven and Gogotsi, Rev. Adv. Mater. Sci. 17 (2008), 33).
 * burgers_vector: silicon slips along <110>/2, 0.5431 nm/sqrt 2 (Hirth and Lothe, Theory of Dislocations).
 * work_of_adhesion: van der Waals attraction of the oxide skins, A/(12 pi D^2) with A = 6.5e-20 J, silica, and D = 0.165 nm
 *   (Israelachvili, Intermolecular and Surface Forces). That van der Waals forces hold such surfaces together was
 *   measured by DelRio, de Boer, Knapp, Reedy, Clews and Dunn, Nature Materials 4 (2005), 629-634.
 * adhesion_range: the same as the Burgers vector, as in Adams and Muftu, J. Phys. D: Appl. Phys. 38 (2005) 1402-1409.
 * Sq: 5 nm, amid the rms roughness of a few to ten nanometres of the films of DelRio et al.
 * Sdq: 0.08, an assumption about such a film. It depends on the resolution of the microscope: measure it at the scale of the
 *   contacts. */
static const char SURFACE[] =
    "measured = [1e-2, 0.3, 0.05]    # load [N], friction coefficient, relative error\n"
    "work_of_adhesion = 0.063        # [J/m^2]\n"
    "adhesion_range = 0.384e-9       # [m]\n"
    "burgers_vector = 0.384e-9       # [m]\n"
    "hardness = 12e9                 # [Pa], for warnings\n"
    "nominal_area = 1e-8             # [m^2]\n"
    "[materials]\n"
    "E1 = 160e9                      # [Pa]\n"
    "nu1 = 0.22\n"
    "E2 = 160e9\n"
    "nu2 = 0.22\n"
    "[roughness]\n"
    "Sq = 5e-9                       # [m], root mean square height\n"
    "Sdq = 0.08                      # root mean square slope\n";
static const double MEASURED_LOAD = 1e-2; /* [N], as above */

/* ---- The contact ---- */

static int library_failed(const char *call)
{
    char message[512];
    asperity_last_error(message, sizeof message);
    fprintf(stderr, "friction_curve: %s: %s\n", call, message);
    return FAILED;
}

static int make_contact(asperity_model **model)
{
    asperity_params params;

    asperity_params_init(&params, sizeof params);
    if (asperity_params_set_text(&params, SURFACE, sizeof SURFACE - 1) != ASPERITY_OK)
        return library_failed("asperity_params_set_text");
    if (asperity_create(&params, model) != ASPERITY_OK)
        return library_failed("asperity_create");
    return 0;
}

/* `n` loads evenly spaced in the logarithm, with the band of friction at each. */
static int evaluate(const asperity_model *model, double lowest, double highest, int n, row *rows)
{
    double *loads = malloc((size_t)n * sizeof *loads);
    asperity_estimate *estimates = malloc((size_t)n * sizeof *estimates);
    int failed = 0;

    if (loads == NULL || estimates == NULL) {
        fprintf(stderr, "friction_curve: out of memory for %d loads\n", n);
        failed = FAILED;
    }
    for (int i = 0; i < n && !failed; i++) {
        loads[i] = lowest * pow(highest / lowest, (double)i / (n - 1));
        estimates[i].struct_size = sizeof *estimates;
    }
    if (!failed && asperity_estimate_at_loads(SURFACE, sizeof SURFACE - 1, (size_t)n, loads, estimates) != ASPERITY_OK)
        failed = library_failed("asperity_estimate_at_loads");
    for (int i = 0; i < n && !failed; i++) {
        asperity_state state;

        state.struct_size = sizeof state;
        if (asperity_state_at_load(model, loads[i], &state) != ASPERITY_OK)
            failed = library_failed("asperity_state_at_load");
        rows[i].load = loads[i];
        rows[i].mu = estimates[i].friction_coefficient;
        rows[i].low = estimates[i].low;
        rows[i].high = estimates[i].high;
        rows[i].friction = estimates[i].friction_force;
        rows[i].area = state.real_area;
        rows[i].contacts = state.contacting;
    }
    free(estimates);
    free(loads);
    return failed;
}

/* Says what of the model does not hold at the loads of the table, and what to do about it. */
static int print_warnings(const asperity_model *model, const options *o)
{
    uint64_t warnings;
    char text[512];

    if (asperity_check_loads(model, o->lowest, o->highest, &warnings) != ASPERITY_OK)
        return library_failed("asperity_check_loads");
    for (uint64_t bit = 1; bit <= warnings; bit *= 2) {
        if (!(warnings & bit))
            continue;
        asperity_warnings_text(bit, text, sizeof text);
        fprintf(stderr, "friction_curve: warning: %s\n", text);
    }
    return 0;
}

static void print_table(const row *rows, int n)
{
    printf("# load [N], mu, low, high, friction force [N], real area [m^2], contacts\n");
    for (int i = 0; i < n; i++)
        printf("%.9e %.9e %.9e %.9e %.9e %.9e %.9e\n", rows[i].load, rows[i].mu, rows[i].low, rows[i].high, rows[i].friction,
               rows[i].area, rows[i].contacts);
}

static void print_summary(const row *rows, int n, double constant)
{
    printf("Polysilicon on polysilicon, 0.01 mm^2, one friction coefficient given: %.3f at %g N (assumed; measure yours)\n\n",
           constant, MEASURED_LOAD);
    printf("  load [N]      mu     low    high   contacts\n");
    for (int i = 0; i < n; i++)
        printf("%10.3g  %6.3f  %6.3f  %6.3f  %9.0f\n", rows[i].load, rows[i].mu, rows[i].low, rows[i].high, rows[i].contacts);
    printf("\nThe friction coefficient mu falls from %.3f to %.3f as the load grows: the constant %.3f would be %.0f %% %s\n"
           "at the lowest load and %.0f %% %s at the highest. low and high enclose mu with 95 %% probability.\n",
           rows[0].mu, rows[n - 1].mu, constant, 100 * fabs(constant / rows[0].mu - 1), constant < rows[0].mu ? "low" : "high",
           100 * fabs(constant / rows[n - 1].mu - 1), constant < rows[n - 1].mu ? "low" : "high");
}

static int print(const options *o, const row *rows, double constant)
{
    if (o->table)
        print_table(rows, o->loads);
    else
        print_summary(rows, o->loads, constant);
    if (fflush(stdout) != 0 || ferror(stdout)) {
        fprintf(stderr, "friction_curve: cannot write the table: %s\n", strerror(errno));
        return FAILED;
    }
    return 0;
}

/* ---- The figure ---- */

enum { WIDTH = 480, HEIGHT = 400, LEFT = 62, RIGHT = 452, TOP = 46, BOTTOM = 336 };
enum { EXTRA_LOADS = 20, DRAWN_LOADS = EXTRA_LOADS + TABLE_LOADS }; /* the extra ones are below LOWEST */
static const double BELOW_LOWEST = 1.0 / 20; /* where they begin, over LOWEST */

typedef struct axes {
    int first_decade, last_decade;
    double mu_step, mu_top;
} axes;

/* 1, 2 or 5 times a power of ten: about five steps up to `top`. */
static double tick_step(double top)
{
    const double raw = top / 5;
    const double decade = pow(10, floor(log10(raw)));
    const double digit = raw / decade;
    return decade * (digit > 5 ? 10 : digit > 2 ? 5 : digit > 1 ? 2 : 1);
}

static axes choose_axes(const row *rows, int n, double constant)
{
    double top = constant;
    axes a;

    for (int i = 0; i < n; i++)
        top = fmax(top, rows[i].high);
    a.first_decade = (int)floor(log10(rows[0].load) + 1e-9);
    a.last_decade = (int)ceil(log10(rows[n - 1].load) - 1e-9);
    if (a.last_decade == a.first_decade)
        a.last_decade++;
    a.mu_step = tick_step(top);
    a.mu_top = a.mu_step * ceil(top / a.mu_step);
    return a;
}

static double x_of(const axes *a, double load)
{
    return LEFT + (RIGHT - LEFT) * (log10(load) - a->first_decade) / (a->last_decade - a->first_decade);
}

static double y_of(const axes *a, double mu)
{
    return BOTTOM - (BOTTOM - TOP) * mu / a->mu_top;
}

static void draw_axes(FILE *svg, const axes *a)
{
    const int every = 1 + (a->last_decade - a->first_decade) / 12;

    for (int k = a->first_decade; k <= a->last_decade; k += every) {
        const double x = x_of(a, pow(10, k));
        fprintf(svg, "<path class=\"grid\" d=\"M%.2f %d V%d\"/>\n", x, TOP, BOTTOM);
        fprintf(svg, "<text x=\"%.2f\" y=\"%d\" text-anchor=\"middle\">10<tspan dy=\"-6\" font-size=\"11\">%s%d</tspan>"
                     "</text>\n", x, BOTTOM + 22, k < 0 ? "&#8722;" : "", abs(k));
    }
    for (int k = 0; k * a->mu_step <= a->mu_top * (1 + 1e-9); k++) {
        const double y = y_of(a, k * a->mu_step);
        fprintf(svg, "<path class=\"grid\" d=\"M%d %.2f H%d\"/>\n", LEFT, y, RIGHT);
        fprintf(svg, "<text x=\"%d\" y=\"%.2f\" text-anchor=\"end\">%g</text>\n", LEFT - 8, y + 5, k * a->mu_step);
    }
    fprintf(svg, "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" fill=\"none\" stroke=\"black\"/>\n",
            LEFT, TOP, RIGHT - LEFT, BOTTOM - TOP);
    fprintf(svg, "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\">normal load P [N]</text>\n", (LEFT + RIGHT) / 2,
            BOTTOM + 52);
    fprintf(svg, "<text transform=\"translate(20 %d) rotate(-90)\" text-anchor=\"middle\">friction coefficient "
                 "&#956; = F/P [&#8211;]</text>\n", (TOP + BOTTOM) / 2);
    fprintf(svg, "<text x=\"10\" y=\"%d\" font-weight=\"bold\">Friction falls with load: polysilicon on polysilicon</text>\n",
            TOP - 20);
}

/* Grey from the left up to the load from which enough summits touch. */
static void draw_too_few(FILE *svg, const axes *a, double enough)
{
    const double right = fmin(x_of(a, enough), RIGHT);

    if (right <= LEFT)
        return;
    fprintf(svg, "<rect x=\"%d\" y=\"%d\" width=\"%.2f\" height=\"%d\" fill=\"#e6e6e6\"/>\n", LEFT, TOP, right - LEFT,
            BOTTOM - TOP);
    fprintf(svg, "<text y=\"%d\" font-size=\"13\"><tspan x=\"%d\">fewer than 20</tspan><tspan x=\"%d\" dy=\"17\">contacts:</tspan>"
                 "<tspan x=\"%d\" dy=\"17\">specimens differ</tspan></text>\n", BOTTOM - 44, LEFT + 8, LEFT + 8, LEFT + 8);
}

static void draw_curve(FILE *svg, const axes *a, const char *class, const row *rows, int n)
{
    fprintf(svg, "<path class=\"%s\" d=\"", class);
    for (int i = 0; i < n; i++)
        fprintf(svg, "%s%.2f %.2f", i == 0 ? "M" : " L", x_of(a, rows[i].load), y_of(a, rows[i].mu));
    fprintf(svg, "\"/>\n");
}

/* From `low` to `high`. */
static void draw_band(FILE *svg, const axes *a, const row *rows, int n)
{
    fprintf(svg, "<path class=\"band\" d=\"");
    for (int i = 0; i < n; i++)
        fprintf(svg, "%s%.2f %.2f", i == 0 ? "M" : " L", x_of(a, rows[i].load), y_of(a, rows[i].low));
    for (int i = n - 1; i >= 0; i--)
        fprintf(svg, " L%.2f %.2f", x_of(a, rows[i].load), y_of(a, rows[i].high));
    fprintf(svg, " Z\"/>\n");
}

static void draw_legend(FILE *svg, double constant)
{
    const int x = LEFT + 130, y = TOP + 6;

    fprintf(svg, "<path class=\"band\" d=\"M%d %d h36 v16 h-36 Z\"/>\n", x, y + 4);
    fprintf(svg, "<path class=\"law\" d=\"M%d %d h36\"/>\n", x, y + 12);
    fprintf(svg, "<text x=\"%d\" y=\"%d\">contact physics, 95 %% band</text>\n", x + 46, y + 17);
    fprintf(svg, "<path class=\"constant\" d=\"M%d %d h36\"/>\n", x, y + 36);
    fprintf(svg, "<text x=\"%d\" y=\"%d\">constant &#956; = %.3f</text>\n", x + 46, y + 41, constant);
    fprintf(svg, "<circle r=\"4\" cx=\"%d\" cy=\"%d\"/>\n", x + 18, y + 60);
    fprintf(svg, "<text x=\"%d\" y=\"%d\">given: %.3f at %g N</text>\n", x + 46, y + 65, constant, MEASURED_LOAD);
}

/* The first EXTRA_LOADS rows are those below LOWEST. */
static void draw(FILE *svg, const row *rows, double enough, double constant)
{
    const axes a = choose_axes(rows, DRAWN_LOADS, constant);

    fprintf(svg, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\" "
                 "font-family=\"DejaVu Sans, sans-serif\" font-size=\"15\">\n", WIDTH, HEIGHT, WIDTH, HEIGHT);
    fprintf(svg, "<style>path { fill: none } .grid { stroke: #ddd } .law { stroke: #0072b2; stroke-width: 2.5 } "
                 ".band { fill: #0072b2; fill-opacity: 0.2 } "
                 ".below { stroke: #0072b2; stroke-width: 1.2 } "
                 ".constant { stroke: #d55e00; stroke-width: 2; stroke-dasharray: 9 6 }</style>\n");
    fprintf(svg, "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n");
    draw_too_few(svg, &a, enough);
    draw_axes(svg, &a);
    fprintf(svg, "<path class=\"constant\" d=\"M%d %.2f H%d\"/>\n", LEFT, y_of(&a, constant), RIGHT);
    draw_band(svg, &a, rows, DRAWN_LOADS);
    draw_curve(svg, &a, "below", rows, EXTRA_LOADS + 1);
    draw_curve(svg, &a, "law", rows + EXTRA_LOADS, TABLE_LOADS);
    if (MEASURED_LOAD >= rows[0].load && MEASURED_LOAD <= rows[DRAWN_LOADS - 1].load)
        fprintf(svg, "<circle r=\"4\" cx=\"%.2f\" cy=\"%.2f\"/>\n", x_of(&a, MEASURED_LOAD), y_of(&a, constant));
    draw_legend(svg, constant);
    fprintf(svg, "</svg>\n");
}

/* The lightest load, from `lowest` to `highest`, at which enough summits touch for a mean. */
static int find_enough(const asperity_model *model, double lowest, double highest, double *enough)
{
    double few = lowest;
    asperity_state state;

    *enough = lowest;
    for (int i = 0; i < 60; i++) {
        state.struct_size = sizeof state;
        if (asperity_state_at_load(model, *enough, &state) != ASPERITY_OK)
            return library_failed("asperity_state_at_load");
        if (i == 0 && !(state.warnings & ASPERITY_WARNING_FEW))
            return 0;
        if (state.warnings & ASPERITY_WARNING_FEW)
            few = *enough;
        else
            highest = *enough;
        *enough = sqrt(few) * sqrt(highest);
    }
    return 0;
}

/* Beside the law the figure has what a solver takes today: the measured coefficient at every load. */
static int draw_in_file(const asperity_model *model, const options *o, double constant)
{
    const double lowest = BELOW_LOWEST * o->lowest;
    row rows[DRAWN_LOADS];
    double enough;
    FILE *svg;
    int failed;

    if (evaluate(model, lowest, o->lowest, EXTRA_LOADS + 1, rows) != 0 ||
        evaluate(model, o->lowest, o->highest, TABLE_LOADS, rows + EXTRA_LOADS) != 0 ||
        find_enough(model, lowest, o->highest, &enough) != 0)
        return FAILED;
    svg = fopen(o->figure, "w");
    if (svg == NULL) {
        fprintf(stderr, "friction_curve: cannot write %s: %s\n", o->figure, strerror(errno));
        return FAILED;
    }
    draw(svg, rows, enough, constant);
    failed = ferror(svg);
    if (fclose(svg) != 0 || failed) {
        fprintf(stderr, "friction_curve: cannot write %s: %s\n", o->figure, strerror(errno));
        return FAILED;
    }
    return 0;
}

/* ---- The command line ---- */

static int refuse(const char *format, ...)
{
    va_list arguments;

    fprintf(stderr, "friction_curve: ");
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fprintf(stderr, "\nusage: friction_curve [--table] [FIGURE.svg|- [LOADS [LOWEST [HIGHEST]]]]\n");
    return USAGE;
}

static int read_number(const char *name, const char *text, double *number)
{
    char *end;

    *number = strtod(text, &end);
    if (end == text || *end != '\0' || !isfinite(*number))
        return refuse("%s = '%s': must be a finite number", name, text);
    return 0;
}

static int read_options(int argc, char **argv, options *o)
{
    double loads;

    if (argc > 1 && strcmp(argv[1], "--table") == 0) {
        o->table = 1;
        argc--;
        argv++;
    }
    loads = o->table ? TABLE_LOADS : SUMMARY_LOADS;
    if (argc > 5)
        return refuse("%d arguments: at most 4", argc - 1);
    if (argc > 1 && strcmp(argv[1], "-") != 0)
        o->figure = argv[1];
    if ((argc > 2 && read_number("LOADS", argv[2], &loads)) ||
        (argc > 3 && read_number("LOWEST", argv[3], &o->lowest)) ||
        (argc > 4 && read_number("HIGHEST", argv[4], &o->highest)))
        return USAGE;
    if (loads < 2 || loads > MAX_LOADS || loads != floor(loads))
        return refuse("LOADS = %s: must be a whole number, 2 to %d", argv[2], MAX_LOADS);
    if (o->lowest <= 0)
        return refuse("LOWEST = %g N: must be > 0, the axis is logarithmic", o->lowest);
    if (o->highest <= o->lowest)
        return refuse("HIGHEST = %g N: must be above LOWEST = %g N", o->highest, o->lowest);
    if (!isfinite(o->highest / o->lowest))
        return refuse("HIGHEST = %g N: too far above LOWEST = %g N", o->highest, o->lowest);
    o->loads = (int)loads;
    return 0;
}

static int run(const asperity_model *model, const options *o)
{
    const double constant = asperity_friction_at_load(model, MEASURED_LOAD);
    row *rows = malloc((size_t)o->loads * sizeof *rows);
    int status;

    if (rows == NULL) {
        fprintf(stderr, "friction_curve: out of memory for %d loads\n", o->loads);
        return FAILED;
    }
    status = evaluate(model, o->lowest, o->highest, o->loads, rows);
    if (status == 0)
        status = print(o, rows, constant);
    if (status == 0)
        status = print_warnings(model, o);
    if (status == 0 && o->figure != NULL)
        status = draw_in_file(model, o, constant);
    free(rows);
    return status;
}

int main(int argc, char **argv)
{
    options o = { 0, NULL, 0, 1e-4, 1.0 };
    asperity_model *model = NULL;
    int status = read_options(argc, argv, &o);

    if (status == 0)
        status = make_contact(&model);
    if (status == 0)
        status = run(model, &o);
    asperity_free(model);
    return status;
}
