/* Friction from the text on standard input at 0, 1 and 100 N: the table, then the text for people. */
#include <asperity.h>
#include <stdio.h>

int main(void)
{
    const double loads[] = {0.0, 1.0, 100.0};
    char surface[4096], text[4096];
    const size_t length = fread(surface, 1, sizeof surface, stdin);
    asperity_estimate found[3];
    int i;

    found[0].struct_size = sizeof found[0];
    if (asperity_estimate_at_loads(surface, length, 3, loads, found) != ASPERITY_OK)
        return 1;
    for (i = 1; i < 3; i++)
        printf("%.12E %.12E %.12E\n", found[i].friction_coefficient, found[i].low, found[i].high);
    asperity_estimate_text(surface, length, 3, loads, text, sizeof text);
    printf("%s", text);
    return 0;
}
