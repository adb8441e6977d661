// Preloaded into a program, it puts the program's wall clock off by as many seconds as stand, an
// int64_t, in the file that SLACKWATER_SHIFTED_CLOCK names, which others may write while it runs.
// CLOCK_MONOTONIC stays what it is.
//
// Waits until a time of the wall clock are left to the kernel, whose clock has not jumped: whoever
// makes one waits for the shift too, or not at all, for as long as it lasts. That is worse than
// what a clock that is set does, which hurts the waits under way alone.
#define _GNU_SOURCE
#include <fcntl.h>
#include <stdint.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

static const volatile int64_t* shift_s;

// By system calls of its own: those of a sanitizer may not be ready yet.
__attribute__((constructor)) static void find_shift(void) {
  const char* path = getenv("SLACKWATER_SHIFTED_CLOCK");
  if (path == NULL) return;
  const long file = syscall(SYS_openat, AT_FDCWD, path, O_RDONLY | O_CLOEXEC);
  if (file < 0) return;
  const long at = syscall(SYS_mmap, 0, sizeof *shift_s, PROT_READ, MAP_SHARED, file, 0);
  syscall(SYS_close, file);
  if (at != -1) shift_s = (const volatile int64_t*)at;
}

int clock_gettime(clockid_t clock, struct timespec* now) {
  const int failed = (int)syscall(SYS_clock_gettime, clock, now);
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
