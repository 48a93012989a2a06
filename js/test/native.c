/* What the native library answers, bit by bit, to the questions on standard input.
 *
 *   surface NAME=VALUE ...    a model, the values with 17 digits
 *   load VALUE                friction, slope, force, slope, stiffness; the state; the sensitivities; one line of 64-bit numbers
 *   check LIGHTEST HEAVIEST   the warnings between the two
 *
 * What the library refuses is answered with "refused: " and its message. */
#include <asperity.h>
#include <inttypes.h>
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
    asperity_params_init_unset(&params);
    if (asperity_params_set_values(&params, count, names, values) != ASPERITY_OK ||
        asperity_create(&params, &model) != ASPERITY_OK)
        print_refused();
    else
        puts("made");
    return model;
}

static void answer_load(const asperity_model *model, double load) {
    double batch[5];
    asperity_state state = {.struct_size = sizeof state};
    asperity_sensitivities sensitivities = {.struct_size = sizeof sensitivities};
    asperity_friction_at_loads(model, 1, &load, &batch[0], &batch[1]);
    asperity_friction_force_at_loads(model, 1, &load, &batch[2], &batch[3]);
    batch[4] = asperity_tangential_stiffness_at_load(model, load);
    if (asperity_state_at_load(model, load, &state) != ASPERITY_OK ||
        asperity_sensitivities_at_load(model, load, &sensitivities) != ASPERITY_OK) {
        print_refused();
        return;
    }
    print_bits(batch, 5);
    print_bits((char *)&state + 8, sizeof state / 8 - 1);
    print_bits((char *)&sensitivities + 8, sizeof sensitivities / 8 - 1);
    putchar('\n');
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
        } else {
            return 2;
        }
    }
    asperity_free(model);
}
