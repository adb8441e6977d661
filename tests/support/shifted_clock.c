// Preloaded into a program, it puts the program's wall clock off by as many seconds as stand, an
// int64_t, in the file that SLACKWATER_SHIFTED_CLOCK names, which others may write while it runs.
// CLOCK_MONOTONIC stays what it is.
//
// Waits of semaphores and mutexes until a time of the wall clock are put to the kernel without the
// shift, for its clock has not jumped: those of shared memory in Fast DDS, whose locks else give up
// at once or for hours, and whose ports then end in memory that is gone. Other waits of that kind
// are left to the kernel: whoever makes one waits for the shift too, or not at all, for as long as
// it lasts. That is worse than what a clock that is set does, which hurts the waits under way alone.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <semaphore.h>
#include <stdint.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

static const volatile int64_t* shift_s;

// By system calls of its own: those of a sanitizer may not be ready yet. Its arguments are long: an
// int has 32 bits that nobody set, which clang leaves so, and the last one is where in the file.
__attribute__((constructor)) static void find_shift(void) {
  const char* path = getenv("SLACKWATER_SHIFTED_CLOCK");
  if (path == NULL) return;
  const long file = syscall(SYS_openat, (long)AT_FDCWD, path, (long)(O_RDONLY | O_CLOEXEC));
  if (file < 0) return;
  const long at = syscall(SYS_mmap, 0L, sizeof *shift_s, (long)PROT_READ, (long)MAP_SHARED, file, 0L);
  syscall(SYS_close, file);
  if (at != -1) shift_s = (const volatile int64_t*)at;
}

int clock_gettime(clockid_t clock, struct timespec* now) {
  const int failed = (int)syscall(SYS_clock_gettime, (long)clock, now);
  if (failed == 0 && shift_s != NULL && (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE))
    now->tv_sec += *shift_s;
  return failed;
}

int gettimeofday(struct timeval* restrict now, void* restrict zone) {
  (void)zone;
  struct timespec at;
  const int failed = clock_gettime(CLOCK_REALTIME, &at);
  if (failed != 0) return failed;
  now->tv_sec = at.tv_sec;
  now->tv_usec = at.tv_nsec / 1000;
  return 0;
}

time_t time(time_t* told) {
  struct timespec at;
  if (clock_gettime(CLOCK_REALTIME, &at) != 0) return (time_t)-1;
  if (told != NULL) *told = at.tv_sec;
  return at.tv_sec;
}

static struct timespec unshifted(const struct timespec* at) {
  struct timespec of_kernel = *at;
  if (shift_s != NULL) of_kernel.tv_sec -= *shift_s;
  return of_kernel;
}

// POSIX lets a pointer to a function come as one to an object.

int sem_timedwait(sem_t* restrict semaphore, const struct timespec* restrict until) {
  static int (*wait)(sem_t*, const struct timespec*);
  if (wait == NULL) *(void**)&wait = dlsym(RTLD_NEXT, "sem_timedwait");
  const struct timespec at = unshifted(until);
  return wait(semaphore, &at);
}

int pthread_mutex_timedlock(pthread_mutex_t* restrict mutex,
                            const struct timespec* restrict until) {
  static int (*lock)(pthread_mutex_t*, const struct timespec*);
  if (lock == NULL) *(void**)&lock = dlsym(RTLD_NEXT, "pthread_mutex_timedlock");
  const struct timespec at = unshifted(until);
  return lock(mutex, &at);
}
