/* A host may run with floating-point traps on: a program with this header does, from before main. As a shared library that is
 * preloaded it does the same to programs that know nothing of it. */

#ifndef TRAPS_ON_H
#define TRAPS_ON_H

#include <fenv.h>

#ifndef __GLIBC__
#error "the tests turn floating-point traps on by feenableexcept, which is of the GNU C library"
#endif

int feenableexcept(int exceptions);
int fegetexcept(void);

/* What is trapped: valgrind traps nothing. */
static int traps_at_start;

__attribute__((constructor)) static void traps_on(void)
{
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    traps_at_start = fegetexcept();
}

#endif
