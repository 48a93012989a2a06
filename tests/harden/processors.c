/* Answers of models made on this processor, to a file, or against the file that another processor wrote, at its loads.
 *
 * usage: processors write|compare FILE */

#include "answers.h"

#include <stdint.h>
#include <stdlib.h>

enum { SEVERAL = 5 };
/* By so many units the forces may differ where the system's exponentials and logarithms have no FMA. */
enum { MOST_ULPS = 8 };
static const int WHICH[SEVERAL] = { 0, 1, 3, 4, 8 };

static int64_t ulps(double a, double b)
{
    int64_t x, y;

    memcpy(&x, &a, sizeof x);
    memcpy(&y, &b, sizeof y);
    return llabs(x - y);
}

int main(int argc, char **argv)
{
    static answers here[SEVERAL], there[SEVERAL];
    const int writes = argc > 2 && strcmp(argv[1], "write") == 0;
    FILE *file = argc > 2 ? fopen(argv[2], writes ? "wb" : "rb") : NULL;
    int64_t most = 0;
    long differing = 0;
    double worst = 0;

    if (file == NULL) {
        fprintf(stderr, "usage: processors write|compare FILE\n");
        return 2;
    }
    if (!writes)
        CHECK(fread(there, sizeof there, 1, file) == 1, "cannot read");
    for (int s = 0; s < SEVERAL; s++) {
        const asperity_params p = surface(WHICH[s]);
        asperity_model *model = NULL;

        CHECK(asperity_create(&p, &model) == ASPERITY_OK, "surface %s", SURFACE_NAMES[WHICH[s]]);
        answer(model, &here[s]);
        if (!writes) {
            memcpy(here[s].load, there[s].load, sizeof here[s].load);
            answer_at(model, &here[s]);
        }
        /* The vectors of this processor against its scalar call. */
        CHECK(memcmp(here[s].batch, here[s].force, sizeof here[s].batch) == 0, "%s: a batch has other bits than its calls",
            SURFACE_NAMES[WHICH[s]]);
        asperity_free(model);
    }
    if (writes) {
        CHECK(fwrite(here, sizeof here, 1, file) == 1, "cannot write");
    } else {
        for (int s = 0; s < SEVERAL; s++) {
            worst = fmax(worst, difference(&here[s], &there[s]));
            for (int i = 0; i < LOADS; i++) {
                const int64_t off = ulps(here[s].force[i], there[s].force[i]);
                differing += off != 0;
                most = off > most ? off : most;
            }
        }
        CHECK(most <= MOST_ULPS && worst <= 4e-15, "off by %g", worst);
        printf("%ld of %d forces differ, by %lld ulp at most (%.1e)\n", differing, SEVERAL * LOADS, (long long)most, worst);
    }
    fclose(file);
    return checks_report("processors");
}
