/* A disk that fails at the n-th change of a file below one folder; tests load it before the C library.
 *
 * LOLE_FAULT_UNDER: the folder. LOLE_FAULT_AT: n, from 1; 0 counts only.
 * LOLE_FAULT_MODE: "kill" ends the process before the n-th change; "once" fails it alone; "full" fails from it on
 * whatever makes a file or lets it grow; "denied" fails from it on whatever makes, moves or removes a name.
 * LOLE_FAULT_LOG: a file that gets the name of every change, a line each. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

enum kind { GROWS = 1, NAMES = 2, FLUSHES = 4 };

static long counted = 0;

static int is_below(const char *path) {
    const char *under = getenv("LOLE_FAULT_UNDER");
    return under && path && strncmp(path, under, strlen(under)) == 0;
}

static int is_fd_below(int fd) {
    char link[64], path[PATH_MAX];
    snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
    ssize_t length = readlink(link, path, sizeof path - 1);
    if (length < 0) return 0;
    path[length] = 0;
    return is_below(path);
}

static int is_at_below(int fd, const char *path) {
    return path && path[0] == '/' ? is_below(path) : fd != AT_FDCWD && is_fd_below(fd);
}

/* The error of this change, or 0. */
static int fault(const char *name, int kind) {
    long number = __atomic_add_fetch(&counted, 1, __ATOMIC_SEQ_CST);
    const char *log = getenv("LOLE_FAULT_LOG"), *at = getenv("LOLE_FAULT_AT"), *mode = getenv("LOLE_FAULT_MODE");
    if (log) {
        int fd = syscall(SYS_openat, AT_FDCWD, log, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
        char line[64];
        int length = snprintf(line, sizeof line, "%s\n", name);
        if (fd >= 0) {
            if (syscall(SYS_write, fd, line, length) != length) abort();
            syscall(SYS_close, fd);
        }
    }
    long wanted = at ? atol(at) : 0;
    if (!mode || wanted == 0 || number < wanted) return 0;
    if (strcmp(mode, "kill") == 0) {
        syscall(SYS_kill, getpid(), SIGKILL);
        for (;;) pause();
    }
    if (strcmp(mode, "once") == 0) return number == wanted ? EIO : 0;
    if (strcmp(mode, "full") == 0) return kind & (GROWS | FLUSHES) ? ENOSPC : 0;
    if (strcmp(mode, "denied") == 0) return kind & NAMES ? EACCES : 0;
    return 0;
}

#define NEXT(name) static __typeof__(name) *next; if (!next) next = (__typeof__(name) *)dlsym(RTLD_NEXT, #name)
#define FAIL_IF(below, label, kind) \
    do { if (below) { int error = fault(label, kind); if (error) { errno = error; return -1; } } } while (0)

static int makes(int flags) { return (flags & O_CREAT) != 0; }

#define OPEN(name) \
    int name(const char *path, int flags, ...) { \
        NEXT(name); va_list more; va_start(more, flags); mode_t mode = va_arg(more, mode_t); va_end(more); \
        FAIL_IF(makes(flags) && is_below(path), "open", GROWS | NAMES); \
        return next(path, flags, mode); \
    }
#define OPENAT(name) \
    int name(int fd, const char *path, int flags, ...) { \
        NEXT(name); va_list more; va_start(more, flags); mode_t mode = va_arg(more, mode_t); va_end(more); \
        FAIL_IF(makes(flags) && is_at_below(fd, path), "open", GROWS | NAMES); \
        return next(fd, path, flags, mode); \
    }
OPEN(open)
OPEN(open64)
OPENAT(openat)
OPENAT(openat64)

ssize_t write(int fd, const void *bytes, size_t count) {
    NEXT(write);
    if (is_fd_below(fd)) {
        int error = fault("write", GROWS);
        if (error) {
            /* A disk that gets full takes what still fits. */
            if (error == ENOSPC && count > 1) { if (next(fd, bytes, count / 2) < 0) return -1; }
            errno = error;
            return -1;
        }
    }
    return next(fd, bytes, count);
}
ssize_t writev(int fd, const struct iovec *parts, int count) {
    NEXT(writev);
    FAIL_IF(is_fd_below(fd), "write", GROWS);
    return next(fd, parts, count);
}
ssize_t copy_file_range(int from, off64_t *from_at, int to, off64_t *to_at, size_t count, unsigned flags) {
    NEXT(copy_file_range);
    FAIL_IF(is_fd_below(to), "write", GROWS);
    return next(from, from_at, to, to_at, count, flags);
}
int fsync(int fd) { NEXT(fsync); FAIL_IF(is_fd_below(fd), "fsync", FLUSHES); return next(fd); }
int fdatasync(int fd) { NEXT(fdatasync); FAIL_IF(is_fd_below(fd), "fsync", FLUSHES); return next(fd); }
int mkdir(const char *path, mode_t mode) {
    NEXT(mkdir);
    struct stat data;
    /* Asking for a folder that is there changes nothing. */
    FAIL_IF(is_below(path) && stat(path, &data) != 0, "mkdir", GROWS | NAMES);
    return next(path, mode);
}
int rename(const char *from, const char *to) { NEXT(rename); FAIL_IF(is_below(to), "rename", NAMES); return next(from, to); }
int linkat(int from_fd, const char *from, int to_fd, const char *to, int flags) {
    NEXT(linkat);
    FAIL_IF(is_at_below(to_fd, to), "link", GROWS | NAMES);
    return next(from_fd, from, to_fd, to, flags);
}
int link(const char *from, const char *to) { NEXT(link); FAIL_IF(is_below(to), "link", GROWS | NAMES); return next(from, to); }
int unlink(const char *path) { NEXT(unlink); FAIL_IF(is_below(path), "unlink", NAMES); return next(path); }
int unlinkat(int fd, const char *path, int flags) {
    NEXT(unlinkat);
    FAIL_IF(is_at_below(fd, path), "unlink", NAMES);
    return next(fd, path, flags);
}
int rmdir(const char *path) { NEXT(rmdir); FAIL_IF(is_below(path), "rmdir", NAMES); return next(path); }
