/* Preloaded, fails one allocation: the k-th after failing_malloc_arm(k). Counts all of them meanwhile. */

#include <errno.h>
#include <stddef.h>

extern void *__libc_malloc(size_t size);
extern void *__libc_calloc(size_t count, size_t size);
extern void *__libc_realloc(void *at, size_t size);
extern void *__libc_memalign(size_t alignment, size_t size);

static long countdown, counted;

void failing_malloc_arm(long k);
long failing_malloc_disarm(void);

void failing_malloc_arm(long k)
{
    countdown = k;
    counted = 0;
}

/* How many there were since it was armed. */
long failing_malloc_disarm(void)
{
    const long count = counted;
    countdown = 0;
    counted = 0;
    return count;
}

static int fails(void)
{
    if (countdown == 0)
        return 0;
    counted++;
    if (counted != countdown)
        return 0;
    errno = ENOMEM;
    return 1;
}

void *malloc(size_t size)
{
    return fails() ? NULL : __libc_malloc(size);
}

void *calloc(size_t count, size_t size)
{
    return fails() ? NULL : __libc_calloc(count, size);
}

void *realloc(void *at, size_t size)
{
    return fails() ? NULL : __libc_realloc(at, size);
}

void *aligned_alloc(size_t alignment, size_t size)
{
    return fails() ? NULL : __libc_memalign(alignment, size);
}

int posix_memalign(void **out, size_t alignment, size_t size)
{
    void *at = fails() ? NULL : __libc_memalign(alignment, size);

    if (at == NULL)
        return ENOMEM;
    *out = at;
    return 0;
}
