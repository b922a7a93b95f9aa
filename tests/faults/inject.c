/* Makes the n-th call of one kind fail in the program that it is loaded into (LD_PRELOAD).
 *
 *   SUPERSTEP_FAIL=write:3    the third write of the process fails; write:3+ = that one and all that follow
 *   SUPERSTEP_HIDE=TEXT       files with this text in their names cannot be opened
 *   SUPERSTEP_COUNT=FILE      at the end: one line "kind number" for each kind of call
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

enum kind { open_call, write_call, pwrite_call, rename_call, fsync_call, malloc_call, kinds };
static const char* const names[kinds] = {"open", "write", "pwrite", "rename", "fsync", "malloc"};
static atomic_long calls[kinds];
static long failing[kinds]; /* number of the call that fails; 0 = none */
static int from_then_on;
static int ready;

__attribute__((constructor)) static void begin(void) {
  const char* wish = getenv("SUPERSTEP_FAIL");
  for (int k = 0; wish && k < kinds; ++k) {
    const size_t length = strlen(names[k]);
    if (strncmp(wish, names[k], length) != 0 || wish[length] != ':') continue;
    char* end = NULL;
    failing[k] = strtol(wish + length + 1, &end, 10);
    from_then_on = end && *end == '+';
  }
  for (int k = 0; k < kinds; ++k) calls[k] = 0;
  ready = 1;
}

__attribute__((destructor)) static void finish(void) {
  const char* file = getenv("SUPERSTEP_COUNT");
  long counted[kinds];
  for (int k = 0; k < kinds; ++k) counted[k] = calls[k];
  ready = 0;
  FILE* out = file ? fopen(file, "w") : NULL;
  for (int k = 0; out && k < kinds; ++k) fprintf(out, "%s %ld\n", names[k], counted[k]);
  if (out) fclose(out);
}

static int hidden(const char* path) {
  const char* text = getenv("SUPERSTEP_HIDE");
  return ready && text && strstr(path, text);
}

static int fails(enum kind k) {
  if (!ready) return 0;
  const long number = atomic_fetch_add(&calls[k], 1) + 1;
  return failing[k] > 0 && (number == failing[k] || (from_then_on && number > failing[k]));
}

/* The function of the C library behind ours. */
static void* behind(void** known, const char* name) {
  if (!*known) *known = dlsym(RTLD_NEXT, name);
  return *known;
}
#define REAL(type, name) ((type)behind(&real_##name, #name))

static void *real_open, *real_open64, *real_openat, *real_fopen, *real_fopen64, *real_write, *real_rename,
    *real_fsync, *real_pwrite, *real_pwrite64, *real_pwritev, *real_pwritev64;

static mode_t mode_of(int flags, va_list more) {
  return flags & O_CREAT ? va_arg(more, mode_t) : 0;
}

#define OPEN(name)                                                           \
  int name(const char* path, int flags, ...) {                               \
    va_list more;                                                            \
    va_start(more, flags);                                                   \
    const mode_t mode = mode_of(flags, more);                                \
    va_end(more);                                                            \
    if (hidden(path)) {                                                      \
      errno = ENOENT;                                                        \
      return -1;                                                             \
    }                                                                        \
    if (fails(open_call)) {                                                  \
      errno = EMFILE;                                                        \
      return -1;                                                             \
    }                                                                        \
    return REAL(int (*)(const char*, int, mode_t), name)(path, flags, mode); \
  }
OPEN(open)
OPEN(open64)

int openat(int folder, const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = mode_of(flags, more);
  va_end(more);
  if (fails(open_call)) {
    errno = EMFILE;
    return -1;
  }
  return REAL(int (*)(int, const char*, int, mode_t), openat)(folder, path, flags, mode);
}

#define FOPEN(name)                                                      \
  FILE* name(const char* path, const char* mode) {                       \
    if (fails(open_call)) {                                              \
      errno = EMFILE;                                                    \
      return NULL;                                                       \
    }                                                                    \
    return REAL(FILE * (*)(const char*, const char*), name)(path, mode); \
  }
FOPEN(fopen)
FOPEN(fopen64)

ssize_t write(int file, const void* bytes, size_t count) {
  if (fails(write_call)) {
    errno = ENOSPC;
    return -1;
  }
  return REAL(ssize_t(*)(int, const void*, size_t), write)(file, bytes, count);
}

/* Writes at a place of a file, as MPI makes them. */
#define PWRITE(name, bytes, size, place)                                                 \
  ssize_t name(int file, bytes source, size count, place offset) {                       \
    if (fails(pwrite_call)) {                                                            \
      errno = ENOSPC;                                                                    \
      return -1;                                                                         \
    }                                                                                    \
    return REAL(ssize_t(*)(int, bytes, size, place), name)(file, source, count, offset); \
  }
PWRITE(pwrite, const void*, size_t, off_t)
PWRITE(pwrite64, const void*, size_t, off64_t)
PWRITE(pwritev, const struct iovec*, int, off_t)
PWRITE(pwritev64, const struct iovec*, int, off64_t)

int rename(const char* from, const char* to) {
  if (fails(rename_call)) {
    errno = EIO;
    return -1;
  }
  return REAL(int (*)(const char*, const char*), rename)(from, to);
}

int fsync(int file) {
  if (fails(fsync_call)) {
    errno = EIO;
    return -1;
  }
  return REAL(int (*)(int), fsync)(file);
}

/* dlsym itself allocates, so that the allocator is reached by its other name. */
extern void* __libc_malloc(size_t size);

/* SUNDIALS 6.4.1 takes what N_VClone allocates without a look at it, and dies in its own code: left out. */
static int is_of_sundials(const void* caller) {
  Dl_info where;
  return dladdr(caller, &where) != 0 && where.dli_fname && strstr(where.dli_fname, "libsundials");
}

void* malloc(size_t size) {
  if (ready && !is_of_sundials(__builtin_return_address(0)) && fails(malloc_call)) {
    errno = ENOMEM;
    return NULL;
  }
  return __libc_malloc(size);
}
