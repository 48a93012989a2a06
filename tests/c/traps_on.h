/* A host may run with floating-point traps on: a program with this header does, from before main, where the GNU C library
 * has functions to turn them on. As a shared library that is preloaded it does the same to programs that know nothing of
 * it. Elsewhere nothing is trapped. */

#ifndef TRAPS_ON_H
#define TRAPS_ON_H

#include <fenv.h>

#ifdef __GLIBC__

int feenableexcept(int exceptions);
int fegetexcept(void);

/* What is trapped: valgrind traps nothing. */
static int traps_at_start;

__attribute__((constructor)) static void traps_on(void)
{
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    traps_at_start = fegetexcept();
}

#else

enum { traps_at_start = 0 };
#define fegetexcept() 0

#endif

#endif
