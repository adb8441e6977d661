#include "twin/step/step_dispatch.h"

namespace slackwater::twin {

StepBlock step_block_on(KernelPath path) noexcept {
#ifdef SLACKWATER_X86_KERNELS
  if (path == KernelPath::avx512) return kernel_avx512::step_block();
  if (path == KernelPath::avx2) return kernel_avx2::step_block();
#endif
  (void)path;
  return kernel_baseline::step_block();
}

PullBlock pull_block_on(KernelPath path) noexcept {
#ifdef SLACKWATER_X86_KERNELS
  if (path == KernelPath::avx512) return kernel_avx512::pull_block();
  if (path == KernelPath::avx2) return kernel_avx2::pull_block();
#endif
  (void)path;
  return kernel_baseline::pull_block();
}

PullBlock pull_block() noexcept { return pull_block_on(supported_kernel_paths().back()); }

StepBlock step_block() noexcept { return step_block_on(supported_kernel_paths().back()); }

}  // namespace slackwater::twin
