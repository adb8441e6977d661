#include "fields/current/kernel_dispatch.h"

namespace slackwater {

std::string_view name_of(KernelPath path) noexcept {
  switch (path) {
    case KernelPath::avx2:
      return "avx2";
    case KernelPath::avx512:
      return "avx512";
    case KernelPath::baseline:
      break;
  }
  return "baseline";
}

std::vector<KernelPath> supported_kernel_paths() {
  std::vector<KernelPath> paths{KernelPath::baseline};
#ifdef SLACKWATER_X86_KERNELS
  if (__builtin_cpu_supports("avx2")) paths.push_back(KernelPath::avx2);
  if (__builtin_cpu_supports("avx512f")) paths.push_back(KernelPath::avx512);
#endif
  return paths;
}

}  // namespace slackwater
