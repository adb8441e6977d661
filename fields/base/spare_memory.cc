#include "fields/base/spare_memory.h"

#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace slackwater {

void give_back_spare_memory() noexcept {
#ifdef __GLIBC__
  (void)::malloc_trim(0);
#endif
}

void hold_little_spare_memory() noexcept {
#ifdef __GLIBC__
  constexpr int mega = 1 << 20;
  (void)::mallopt(M_TRIM_THRESHOLD, 8 * mega);
  (void)::mallopt(M_MMAP_THRESHOLD, 32 * mega);
#endif
}

}  // namespace slackwater
