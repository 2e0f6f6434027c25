/* Makes a service of the system fail: LD_PRELOAD=faults.so FAULT=write AT=3 ERRNO=28 [EVER=1]
 * loft ... The AT-th call fails, with EVER all from there on. FAULT=short: writes take one byte;
 * FAULT=zero: they take none; FAULT=malloc: no memory; FAULT=count tells on descriptor 2 at the end
 * how many calls of malloc there were. Writing to standard error never fails. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

extern void *__libc_malloc(size_t), *__libc_calloc(size_t, size_t), *__libc_realloc(void *, size_t);
static long calls, at;
static int ready, ever, number;
static const char *fault;

static void prepare(void)
{
    if (ready) return;
    ready = 1;
    fault = getenv("FAULT") ? getenv("FAULT") : "";
    at = getenv("AT") ? atol(getenv("AT")) : 1;
    ever = getenv("EVER") != NULL;
    number = getenv("ERRNO") ? atoi(getenv("ERRNO")) : EIO;
}

static int fails(const char *name)
{
    prepare();
    if (strcmp(fault, name) != 0) return 0;
    calls++;
    if (calls != at && !(ever && calls > at)) return 0;
    errno = number;
    return 1;
}

#define REAL(name) __typeof__(&name) real = (__typeof__(&name)) dlsym(RTLD_NEXT, #name)

ssize_t write(int descriptor, const void *bytes, size_t count)
{
    REAL(write);
    if (descriptor != 2) {
        if (fails("write")) return -1;
        if (fails("zero")) return 0;
        if (strcmp(fault, "short") == 0 && count > 1) count = 1;
    }
    return real(descriptor, bytes, count);
}

ssize_t read(int descriptor, void *bytes, size_t count)
{
    REAL(read);
    return fails("read") ? -1 : real(descriptor, bytes, count);
}

int fsync(int descriptor)
{
    REAL(fsync);
    return fails("fsync") ? -1 : real(descriptor);
}

int fclose(FILE *stream)
{
    REAL(fclose);
    int wrong = fails("fclose"), result = real(stream);
    if (wrong) errno = number;
    return wrong ? -1 : result;
}

int rename(const char *from, const char *to)
{
    REAL(rename);
    return fails("rename") ? -1 : real(from, to);
}

FILE *fopen(const char *path, const char *mode)
{
    REAL(fopen);
    return fails("fopen") ? NULL : real(path, mode);
}

void *malloc(size_t size) { return fails("malloc") ? NULL : __libc_malloc(size); }
void *calloc(size_t n, size_t size) { return fails("malloc") ? NULL : __libc_calloc(n, size); }
void *realloc(void *old, size_t size) { return fails("malloc") ? NULL : __libc_realloc(old, size); }

__attribute__((destructor)) static void tell(void)
{
    prepare();
    if (getenv("COUNT")) dprintf(2, "calls %ld\n", calls);
}
