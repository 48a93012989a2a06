/* How much memory the process holds. */

#ifndef RESIDENT_H
#define RESIDENT_H

#include <stdio.h>

/* Pages in memory; -1 if that cannot be told. */
static inline long resident(void)
{
    long size = 0, pages = 0;
    FILE *file = fopen("/proc/self/statm", "r");

    if (file == NULL || fscanf(file, "%ld %ld", &size, &pages) != 2)
        pages = -1;
    if (file != NULL)
        fclose(file);
    return pages;
}

#endif
