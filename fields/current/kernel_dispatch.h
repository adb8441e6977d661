#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "fields/current/steady_column.h"

namespace slackwater {

/// The instruction sets for which the batch evaluation is compiled (cmake/SlackwaterKernels.cmake).
enum class KernelPath { baseline, avx2, avx512 };
[[nodiscard]] std::string_view name_of(KernelPath path) noexcept;

/// The paths that this machine can run, narrowest first; never empty.
[[nodiscard]] std::vector<KernelPath> supported_kernel_paths();

/// `evaluate_steady` on one path. The arithmetic is the same sequence of IEEE operations per value
/// on all of them (no fused multiply-add, no reordering), hence the same bits. The path must be
/// supported.
void evaluate_steady_on(KernelPath path, const LevelResponses& responses, Horizontal interior_m_s,
                        std::span<const Horizontal> stress_pa, std::span<Horizontal> out);

}  // namespace slackwater
