/* Friction coefficient of a polysilicon MEMS contact against normal load, in SI units.
 *
 * usage: friction_curve [FIGURE [LOADS [LOWEST [HIGHEST]]]]
 *   FIGURE   SVG file to draw the curve in; "-" or nothing for none
 *   LOADS    number of loads, 2 to 100000 (33)
 *   LOWEST   lowest load [N], > 0 (2e-4)
 *   HIGHEST  highest load [N], > LOWEST (0.1)
 *
 * The table goes to standard output, one load a line, messages to standard error. Among these are warnings if the model
 * does not hold somewhere between the two loads; at those that are taken if none is given it holds. The figure begins
 * farther below, and is grey where fewer than 20 summits touch: there one pair of surfaces differs from another.
 * Exit status: 0, 1 if the library or a file refuses, 2 for a wrong command line. */

#include <asperity.h>

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FAILED = 1, USAGE = 2, MAX_LOADS = 100000 };

typedef struct options {
    const char *figure;
    int loads;
    double lowest, highest;
} options;

typedef struct row {
    double load, mu, friction, area, contacts;
} row;

/* Two polysilicon surfaces that touch over a nominal area of 100 um x 100 um.
 *
 * E, nu: 152 to 164 GPa for films of four makers (Sharpe, Jackson, Coles and LaVan, IMECE 2000, MEMS, 255-259);
 *   0.22 (Sharpe, Yuan, Vaidyanathan and Edwards, Proc. IEEE MEMS 1997, 424-429). Both bodies are of it.
 * H: 12 GPa, at which silicon changes phase (Domnich, Aratyn, Kriven and Gogotsi, Rev. Adv. Mater. Sci. 17 (2008), 33).
 * b: silicon slips along <110>/2, 0.5431 nm/sqrt 2 (Hirth and Lothe, Theory of Dislocations).
 * w: van der Waals attraction of the oxide skins, A/(12 pi D^2) with A = 6.5e-20 J, silica, and D = 0.165 nm
 *   (Israelachvili, Intermolecular and Surface Forces). That van der Waals forces hold such surfaces together was
 *   measured by DelRio, de Boer, Knapp, Reedy, Clews and Dunn, Nature Materials 4 (2005), 629-634.
 * h: the same as b, as in Adams and Muftu, J. Phys. D: Appl. Phys. 38 (2005) 1402-1409.
 * sigma: 5 nm, amid the rms roughness of a few to ten nanometres of the films of DelRio et al.
 * summit density: one a grain, of about 0.3 um across, so 10 per um^2: an assumption about the film.
 * R: such that density R sigma = 0.05, as on the surfaces of Greenwood and Williamson, Proc. R. Soc. A 295 (1966), 300.
 *
 * Density and R depend on the resolution of the microscope (Bora et al., Tribology Letters 19 (2005), 37-48): for
 * a device of your own, measure them at the scale of the contacts, and replace these. */
static const double E = 160e9;              /* [Pa] */
static const double NU = 0.22;
static const double HARDNESS = 12e9;        /* H [Pa] */
static const double BURGERS = 0.384e-9;     /* [m] */
static const double ADHESION = 0.063;       /* w [J/m^2] */
static const double SIGMA = 5e-9;           /* [m] */
static const double RADIUS = 1e-6;          /* R [m] */
static const double DENSITY = 1e13;         /* summits [1/m^2] */
static const double NOMINAL_AREA = 1e-8;    /* [m^2] */

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

    asperity_params_init(&params, sizeof params); /* what is forgotten below is refused by name */
    if (asperity_params_set_materials(&params, E, NU, E, NU) != ASPERITY_OK)
        return library_failed("asperity_params_set_materials");
    params.work_of_adhesion = ADHESION;
    params.adhesion_range = BURGERS;
    params.burgers_vector = BURGERS;
    params.height_std = SIGMA;
    params.summit_radius = RADIUS;
    params.asperity_count = DENSITY * NOMINAL_AREA;
    params.nominal_area = NOMINAL_AREA; /* this and the hardness are for warnings alone */
    params.hardness = HARDNESS;
    if (asperity_create(&params, model) != ASPERITY_OK)
        return library_failed("asperity_create");
    return 0;
}

/* Loads are evenly spaced in the logarithm. */
static double load_of(const options *o, int i)
{
    return o->lowest * pow(o->highest / o->lowest, (double)i / (o->loads - 1));
}

static int evaluate(const asperity_model *model, const options *o, row *rows)
{
    for (int i = 0; i < o->loads; i++) {
        const double load = load_of(o, i);
        asperity_state state;

        state.struct_size = sizeof state;
        if (asperity_state_at_load(model, load, &state) != ASPERITY_OK)
            return library_failed("asperity_state_at_load");
        rows[i].load = load;
        rows[i].mu = asperity_friction_at_load(model, load);
        rows[i].friction = asperity_friction_force_at_load(model, load);
        rows[i].area = state.real_area;
        rows[i].contacts = state.contacting;
    }
    return 0;
}

/* Says what of the model does not hold at the loads of the table, and what to do about it. */
static int print_warnings(const asperity_model *model, const options *o)
{
    uint64_t warnings;

    if (asperity_check_loads(model, o->lowest, o->highest, &warnings) != ASPERITY_OK)
        return library_failed("asperity_check_loads");
    for (uint64_t bit = 1; bit <= warnings; bit *= 2)
        if (warnings & bit)
            fprintf(stderr, "friction_curve: warning: %s\n", asperity_warning_string(bit));
    return 0;
}

static int print_table(const row *rows, int n)
{
    printf("# load [N], mu, friction force [N], real area [m^2], contacts\n");
    for (int i = 0; i < n; i++)
        printf("%.9e %.9e %.9e %.9e %.9e\n", rows[i].load, rows[i].mu, rows[i].friction, rows[i].area,
               rows[i].contacts);
    if (fflush(stdout) != 0 || ferror(stdout)) {
        fprintf(stderr, "friction_curve: cannot write the table: %s\n", strerror(errno));
        return FAILED;
    }
    return 0;
}

/* ---- The figure ---- */

enum { WIDTH = 480, HEIGHT = 400, LEFT = 62, RIGHT = 452, TOP = 46, BOTTOM = 336 };
enum { EXTRA_LOADS = 20 }; /* below LOWEST, in the figure alone */
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
        top = fmax(top, rows[i].mu);
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
    fprintf(svg, "<text x=\"%d\" y=\"%d\" font-size=\"13\">fewer than 20 contacts:</text>\n", LEFT + 8, BOTTOM - 28);
    fprintf(svg, "<text x=\"%d\" y=\"%d\" font-size=\"13\">specimens differ</text>\n", LEFT + 8, BOTTOM - 10);
}

static void draw_curve(FILE *svg, const axes *a, const char *class, const row *rows, int n)
{
    fprintf(svg, "<path class=\"%s\" d=\"", class);
    for (int i = 0; i < n; i++)
        fprintf(svg, "%s%.2f %.2f", i == 0 ? "M" : " L", x_of(a, rows[i].load), y_of(a, rows[i].mu));
    fprintf(svg, "\"/>\n");
}

static void draw_legend(FILE *svg, double constant, double middle)
{
    const int x = RIGHT - 372, y = BOTTOM - 118;

    fprintf(svg, "<rect x=\"%d\" y=\"%d\" width=\"367\" height=\"56\" fill=\"white\" stroke=\"#999\"/>\n", x, y);
    fprintf(svg, "<path class=\"law\" d=\"M%d %d h36\"/>\n", x + 10, y + 18);
    fprintf(svg, "<text x=\"%d\" y=\"%d\">contact physics (asperity)</text>\n", x + 56, y + 23);
    fprintf(svg, "<path class=\"constant\" d=\"M%d %d h36\"/>\n", x + 10, y + 40);
    fprintf(svg, "<text x=\"%d\" y=\"%d\">constant &#956; = %.3f, right at %.3g N</text>\n", x + 56, y + 45, constant,
            middle);
}

/* The first EXTRA_LOADS rows are those below LOWEST. */
static void draw(FILE *svg, const row *rows, int n, double enough, double constant, double middle)
{
    const axes a = choose_axes(rows, n, constant);

    fprintf(svg, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\" "
                 "font-family=\"DejaVu Sans, sans-serif\" font-size=\"15\">\n", WIDTH, HEIGHT, WIDTH, HEIGHT);
    fprintf(svg, "<style>path { fill: none } .grid { stroke: #ddd } .law { stroke: #0072b2; stroke-width: 2.5 } "
                 ".below { stroke: #0072b2; stroke-width: 1.2 } "
                 ".constant { stroke: #d55e00; stroke-width: 2; stroke-dasharray: 9 6 }</style>\n");
    fprintf(svg, "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n");
    draw_too_few(svg, &a, enough);
    draw_axes(svg, &a);
    fprintf(svg, "<path class=\"constant\" d=\"M%d %.2f H%d\"/>\n", LEFT, y_of(&a, constant), RIGHT);
    draw_curve(svg, &a, "below", rows, EXTRA_LOADS + 1);
    draw_curve(svg, &a, "law", rows + EXTRA_LOADS, n - EXTRA_LOADS);
    draw_legend(svg, constant, middle);
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

/* Beside the law the figure has what a solver takes today: one number. It is chosen fairly, as the law's own
 * coefficient at the middle of the loads on the logarithmic axis, so that both agree there. */
static int draw_in_file(const asperity_model *model, const options *o, row *rows)
{
    const double middle = sqrt(o->lowest) * sqrt(o->highest);
    const options below = { NULL, EXTRA_LOADS + 1, BELOW_LOWEST * o->lowest, o->lowest };
    double enough;
    FILE *svg;
    int failed;

    if (evaluate(model, &below, rows) != 0 || evaluate(model, o, rows + EXTRA_LOADS) != 0 ||
        find_enough(model, below.lowest, o->highest, &enough) != 0)
        return FAILED;
    svg = fopen(o->figure, "w");
    if (svg == NULL) {
        fprintf(stderr, "friction_curve: cannot write %s: %s\n", o->figure, strerror(errno));
        return FAILED;
    }
    draw(svg, rows, EXTRA_LOADS + o->loads, enough, asperity_friction_at_load(model, middle), middle);
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
    fprintf(stderr, "\nusage: friction_curve [FIGURE.svg|- [LOADS [LOWEST [HIGHEST]]]]\n");
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
    double loads = o->loads;

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
    row *rows = malloc(((size_t)EXTRA_LOADS + (size_t)o->loads) * sizeof *rows);
    int status;

    if (rows == NULL) {
        fprintf(stderr, "friction_curve: out of memory for %d loads\n", o->loads);
        return FAILED;
    }
    status = evaluate(model, o, rows);
    if (status == 0)
        status = print_table(rows, o->loads);
    if (status == 0)
        status = print_warnings(model, o);
    if (status == 0 && o->figure != NULL)
        status = draw_in_file(model, o, rows);
    free(rows);
    return status;
}

int main(int argc, char **argv)
{
    options o = { NULL, 33, 2e-4, 0.1 };
    asperity_model *model = NULL;
    int status = read_options(argc, argv, &o);

    if (status == 0)
        status = make_contact(&model);
    if (status == 0)
        status = run(model, &o);
    asperity_free(model);
    return status;
}
