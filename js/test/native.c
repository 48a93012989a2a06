/* What the native library answers, bit by bit, to the questions on standard input.
 *
 *   surface NAME=VALUE ...    a model, the values with 17 digits
 *   load VALUE                friction, slope, force, slope, stiffness, sum of contact radii, slope; the state; the sensitivities; one line of 64-bit numbers
 *   check LIGHTEST HEAVIEST   the warnings between the two
 *   materials, pairs, interfaces
 *                             a line for each: name, reference and the numbers, with tabs between
 *   material NAME, pair NAME, interface NAME
 *                             such a line
 *   contact PAIR VALUE ...    the parameters of asperity_params_set_pair, of the values height_std, summit_radius,
 *                             asperity_count: one line of 64-bit numbers
 *   mccool M0 M2 M4 AREA      the parameters of asperity_params_set_mccool_summits, as the line before
 *
 * What the library refuses is answered with "refused: " and its message. */
#include <asperity.h>
#include <inttypes.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void print_bits(const void *words, size_t count) {
    for (size_t i = 0; i < count; i++) {
        uint64_t bits;
        memcpy(&bits, (const char *)words + 8 * i, 8);
        printf(" %016" PRIx64, bits);
    }
}

static void print_refused(void) {
    char message[1024];
    asperity_last_error(message, sizeof message);
    printf("refused: %s\n", message);
}

static asperity_model *made(char *line) {
    const char *names[64];
    double values[64];
    size_t count = 0;
    for (char *word = strtok(line, " \n"); word && count < 64; word = strtok(NULL, " \n")) {
        char *value = strchr(word, '=');
        if (!value)
            exit(2);
        *value = '\0';
        names[count] = word;
        values[count++] = strtod(value + 1, NULL);
    }
    asperity_params params;
    asperity_model *model = NULL;
    asperity_params_init(&params, sizeof params);
    if (asperity_params_set_values(&params, count, names, values) != ASPERITY_OK ||
        asperity_create(&params, &model) != ASPERITY_OK)
        print_refused();
    else
        puts("made");
    return model;
}

static void answer_load(const asperity_model *model, double load) {
    double batch[7];
    asperity_state state = {.struct_size = sizeof state};
    asperity_sensitivities sensitivities = {.struct_size = sizeof sensitivities};
    asperity_friction_at_loads(model, 1, &load, &batch[0], &batch[1]);
    asperity_friction_force_at_loads(model, 1, &load, &batch[2], &batch[3]);
    batch[4] = asperity_tangential_stiffness_at_load(model, load);
    asperity_contact_radius_sum_at_loads(model, 1, &load, &batch[5], &batch[6]);
    if (asperity_state_at_load(model, load, &state) != ASPERITY_OK ||
        asperity_sensitivities_at_load(model, load, &sensitivities) != ASPERITY_OK) {
        print_refused();
        return;
    }
    print_bits(batch, 7);
    print_bits((char *)&state + 8, sizeof state / 8 - 1);
    print_bits((char *)&sensitivities + 8, sizeof sensitivities / 8 - 1);
    putchar('\n');
}

static void answer_material(const char *name) {
    asperity_material_data data = {.struct_size = sizeof data};
    if (asperity_material(name, &data) != ASPERITY_OK) {
        print_refused();
        return;
    }
    printf("%s\t%s\t", data.name, data.reference);
    print_bits(&data.young, (offsetof(asperity_material_data, name) - offsetof(asperity_material_data, young)) / 8);
    putchar('\n');
}

static void answer_pair(const char *name) {
    asperity_pair_data data = {.struct_size = sizeof data};
    if (asperity_pair(name, &data) != ASPERITY_OK) {
        print_refused();
        return;
    }
    printf("%s\t%s\t", data.name, data.reference);
    print_bits(&data.work_of_adhesion, (offsetof(asperity_pair_data, name) - offsetof(asperity_pair_data, work_of_adhesion)) / 8);
    putchar('\n');
}

static void answer_interface(const char *name) {
    asperity_interface_data data = {.struct_size = sizeof data};
    if (asperity_interface(name, &data) != ASPERITY_OK) {
        print_refused();
        return;
    }
    printf("%s\t%s\t", data.name, data.reference);
    print_bits(&data.shear_strength, (offsetof(asperity_interface_data, name) - offsetof(asperity_interface_data, shear_strength)) / 8);
    putchar('\n');
}

static void answer_names(const char *(*name_of)(size_t), void (*answer)(const char *)) {
    const char *name;
    for (size_t i = 0; (name = name_of(i)) != NULL; ++i)
        answer(name);
}

/* Eight bytes for each parameter of roughness and material, as numbers. */
static void print_params(const asperity_params *params) {
    const double values[] = {params->composite_modulus, params->effective_shear_modulus, params->tangential_modulus,
        params->work_of_adhesion, params->adhesion_range, params->burgers_vector, params->hardness,
        params->slip_stress_1, params->height_std, params->summit_radius, params->asperity_count,
        params->nominal_area, params->bandwidth, params->skew, params->kurtosis, params->radius_amplitude, params->radius_rate,
        params->summit_mean_height, params->rms_slope};
    print_bits(values, sizeof values / sizeof *values);
    putchar('\n');
}

static void answer_contact(char *line) {
    asperity_params params;
    asperity_params_init(&params, sizeof params);
    const char *name = strtok(line, " ");
    if (asperity_params_set_pair(&params, name) != ASPERITY_OK) {
        print_refused();
        return;
    }
    params.height_std = strtod(strtok(NULL, " "), NULL);
    params.summit_radius = strtod(strtok(NULL, " "), NULL);
    params.asperity_count = strtod(strtok(NULL, " "), NULL);
    asperity_model *model = NULL;
    if (asperity_create(&params, &model) != ASPERITY_OK || asperity_get_params(model, &params) != ASPERITY_OK)
        print_refused();
    else
        print_params(&params);
    asperity_free(model);
}

static void answer_mccool(char *line) {
    double values[4];
    for (int i = 0; i < 4; ++i)
        values[i] = strtod(line, &line);
    asperity_params params;
    asperity_params_init(&params, sizeof params);
    if (asperity_params_set_mccool_summits(&params, values[0], values[1], values[2], values[3]) != ASPERITY_OK)
        print_refused();
    else
        print_params(&params);
}

/* Of the questions without a model; 0 if it is none. */
static int answer_table(char *line) {
    line[strcspn(line, "\n")] = '\0';
    if (!strcmp(line, "materials"))
        answer_names(asperity_material_name, answer_material);
    else if (!strcmp(line, "pairs"))
        answer_names(asperity_pair_name, answer_pair);
    else if (!strcmp(line, "interfaces"))
        answer_names(asperity_interface_name, answer_interface);
    else if (!strncmp(line, "material ", 9))
        answer_material(line + 9);
    else if (!strncmp(line, "pair ", 5))
        answer_pair(line + 5);
    else if (!strncmp(line, "interface ", 10))
        answer_interface(line + 10);
    else if (!strncmp(line, "contact ", 8))
        answer_contact(line + 8);
    else if (!strncmp(line, "mccool ", 7))
        answer_mccool(line + 7);
    else
        return 0;
    return 1;
}

int main(void) {
    static char line[4096];
    asperity_model *model = NULL;
    while (fgets(line, sizeof line, stdin)) {
        if (!strncmp(line, "surface ", 8)) {
            asperity_free(model);
            model = made(line + 8);
        } else if (!strncmp(line, "load ", 5)) {
            answer_load(model, strtod(line + 5, NULL));
        } else if (!strncmp(line, "check ", 6)) {
            char *rest;
            double lightest = strtod(line + 6, &rest);
            uint64_t warnings = 0;
            if (asperity_check_loads(model, lightest, strtod(rest, NULL), &warnings) != ASPERITY_OK)
                print_refused();
            else
                printf(" %016" PRIx64 "\n", warnings);
        } else if (!strncmp(line, "warning ", 8)) {
            double loads[2];
            if (asperity_warning_loads(model, strtoull(line + 8, NULL, 10), &loads[0], &loads[1]) != ASPERITY_OK) {
                print_refused();
            } else {
                print_bits(loads, 2);
                putchar('\n');
            }
        } else if (!strncmp(line, "text ", 5)) {
            char text[8192];
            asperity_warnings_text(strtoull(line + 5, NULL, 10), text, sizeof text);
            for (char *end = text; (end = strchr(end, '\n')) != NULL;)
                *end = '\t';
            puts(text);
        } else if (!answer_table(line)) {
            return 2;
        }
    }
    asperity_free(model);
}
