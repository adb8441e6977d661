#pragma once
#include "fields/wave/sea_kernel.h"

namespace slackwater {

/// A place from the reference of a moment, metres, and how it moves.
struct SeaMomentPlace {
  float east_m = 0;
  float north_m = 0;
  float up_m = 0;  ///< from still water, not from the reference
  float east_m_s = 0;
  float north_m_s = 0;
  float up_m_s = 0;
};

/// Where the kernel puts its sums.
struct SeaMomentSums {
  float elevation_m = 0;
  float rise_m_s = 0;  ///< of the elevation along the way
  float velocity_m_s[3] = {};
  float acceleration_m_s2[3] = {};
};

/// The sea at `count` places about a reference, all at its time; the up of the reference counts for
/// nothing, its factor for all.
using SeaMomentKernel = void (*)(const SeaKernelWaves&, const SeaKernelPlace& reference,
                                 bool stretched, const SeaMomentPlace* places, std::size_t count,
                                 SeaMomentSums*) noexcept;

namespace kernel_baseline {
[[nodiscard]] SeaMomentKernel sea_moment_kernel() noexcept;
}
namespace kernel_avx2 {
[[nodiscard]] SeaMomentKernel sea_moment_kernel() noexcept;
}
namespace kernel_avx512 {
[[nodiscard]] SeaMomentKernel sea_moment_kernel() noexcept;
}

}  // namespace slackwater
