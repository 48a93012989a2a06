/* Answers of models made on this processor, to a file, or against the file that another processor wrote: bit for bit, with
 * tables, slopes, exact states and summaries.
 *
 * usage: processors write|compare FILE */

#include "answers.h"

int main(int argc, char **argv)
{
    static answers here, there;
    const int writes = argc > 2 && strcmp(argv[1], "write") == 0;
    FILE *file = argc > 2 ? fopen(argv[2], writes ? "wb" : "rb") : NULL;

    if (file == NULL) {
        fprintf(stderr, "usage: processors write|compare FILE\n");
        return 2;
    }
    for (int s = 0; s < SURFACES; s++) {
        const asperity_params p = surface(s);
        asperity_model *model = NULL;

        CHECK(asperity_create(&p, &model) == ASPERITY_OK, "surface %s", SURFACE_NAMES[s]);
        answer(model, &here);
        asperity_free(model);
        /* The vectors of this processor against its scalar call. */
        CHECK(memcmp(here.batch, here.force, sizeof here.batch) == 0, "%s: a batch has other bits than its calls",
            SURFACE_NAMES[s]);
        if (writes) {
            CHECK(fwrite(&here, sizeof here, 1, file) == 1, "cannot write");
        } else {
            CHECK(fread(&there, sizeof there, 1, file) == 1, "cannot read");
            CHECK(same(&here, &there), "%s: other bits than on the other processor, forces off by %g", SURFACE_NAMES[s],
                difference(&here, &there));
        }
    }
    fclose(file);
    return checks_report("processors");
}
