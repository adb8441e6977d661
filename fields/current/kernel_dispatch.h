#pragma once
#include <string_view>
#include <vector>

namespace slackwater {

/// The instruction sets for which batch kernels are compiled (cmake/SlackwaterKernels.cmake). The
/// arithmetic of a kernel is the same sequence of IEEE operations per value on all of them (no
/// fused multiply-add, no reordering), hence the same bits.
enum class KernelPath { baseline, avx2, avx512 };
[[nodiscard]] std::string_view name_of(KernelPath path) noexcept;

/// The paths that this machine can run, narrowest first; never empty.
[[nodiscard]] std::vector<KernelPath> supported_kernel_paths();

}  // namespace slackwater
