/* Preloaded, fails allocations: the k-th after failing_malloc_arm(k, 0), the k-th and all later ones after (k, 1). Counts all
 * of them meanwhile, and the blocks that are not freed. */

#include <errno.h>
#include <stddef.h>

extern void *__libc_malloc(size_t size);
extern void *__libc_calloc(size_t count, size_t size);
extern void *__libc_realloc(void *at, size_t size);
extern void *__libc_memalign(size_t alignment, size_t size);
extern void __libc_free(void *at);

static long countdown, counted, blocks;
static int later_ones_too;

void failing_malloc_arm(long k, int all);
long failing_malloc_disarm(long *left);

void failing_malloc_arm(long k, int all)
{
    countdown = k;
    later_ones_too = all;
    counted = blocks = 0;
}

/* How many there were since it was armed; how many blocks are left of them. */
long failing_malloc_disarm(long *left)
{
    countdown = 0;
    *left = blocks;
    return counted;
}

static int fails(void)
{
    if (countdown == 0)
        return 0;
    counted++;
    if (counted != countdown && !(later_ones_too && counted > countdown))
        return 0;
    errno = ENOMEM;
    return 1;
}

static void *gained(void *at)
{
    blocks += countdown != 0 && at != NULL;
    return at;
}

void *malloc(size_t size)
{
    return fails() ? NULL : gained(__libc_malloc(size));
}

void *calloc(size_t count, size_t size)
{
    return fails() ? NULL : gained(__libc_calloc(count, size));
}

void *realloc(void *at, size_t size)
{
    if (fails())
        return NULL;
    return at == NULL ? gained(__libc_realloc(at, size)) : __libc_realloc(at, size);
}

void *aligned_alloc(size_t alignment, size_t size)
{
    return fails() ? NULL : gained(__libc_memalign(alignment, size));
}

int posix_memalign(void **out, size_t alignment, size_t size)
{
    void *at = fails() ? NULL : gained(__libc_memalign(alignment, size));

    if (at == NULL)
        return ENOMEM;
    *out = at;
    return 0;
}

void free(void *at)
{
    blocks -= countdown != 0 && at != NULL;
    __libc_free(at);
}
