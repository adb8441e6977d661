#pragma once
#include <cstddef>

namespace slackwater {

/// The sinusoids of a sea as the kernel reads them: arrays of `count` values, a multiple of 8,
/// by ascending wavenumber (waves of no height that fill up the last eight stand anywhere). Plain
/// pointers on purpose: a kernel is compiled once for each instruction set, and inline functions of
/// library types would be taken from one of them by all.
struct SeaKernelWaves {
  std::size_t count = 0;
  double depth_m = 0;
  const double* east_turns_m = nullptr;  ///< k/(2 pi)
  const double* north_turns_m = nullptr;
  const double* turns_s = nullptr;      ///< omega/(2 pi), absolute
  const double* phase_turns = nullptr;  ///< epsilon/(2 pi)
  const double* amplitude_m = nullptr;  ///< a
  const double* decay_per_m = nullptr;  ///< k log2(e)
  const double* reflection = nullptr;   ///< B = e^(-2kh)
  const double* east_m_s = nullptr;     ///< a sigma/(1 - B) times the east of the direction
  const double* north_m_s = nullptr;
  const double* up_m_s = nullptr;           ///< a sigma/(1 - B)
  const double* intrinsic_rad_s = nullptr;  ///< sigma
  const double* pressure_pa = nullptr;      ///< rho g a/(1 + B)
};

struct SeaKernelPlace {
  double east_m = 0;
  double north_m = 0;
  double up_m = 0;  ///< from still water
  double t_s = 0;
  double height_factor = 1;  ///< on the elevation and all that moves, at that time
};

/// Where the kernel puts its sums.
struct SeaKernelSums {
  double elevation_m = 0;
  double evaluated_up_m = 0;  ///< the level after stretching, in [-h, 0]
  double velocity_m_s[3] = {};
  double acceleration_m_s2[3] = {};
  double pressure_pa = 0;
};

/// The most sinusoids that the scratch space on the stack holds.
inline constexpr std::size_t most_kernel_waves = 1024;

/// What is asked for: each does all that the one before it does.
using SeaKernel = void (*)(const SeaKernelWaves&, const SeaKernelPlace&, bool stretched,
                           SeaKernelSums&) noexcept;
/// All that there is at `count` places in a row, of which the first and the step from one to the
/// next are given (the time and the factor of the step count for nothing).
using SeaRowKernel = void (*)(const SeaKernelWaves&, const SeaKernelPlace& first,
                              const SeaKernelPlace& step, std::size_t count, bool stretched,
                              SeaKernelSums*) noexcept;
struct SeaKernels {
  SeaKernel elevation = nullptr;
  SeaKernel motion = nullptr;  ///< and velocity
  SeaKernel all = nullptr;     ///< and acceleration and pressure
  SeaRowKernel row = nullptr;
};

namespace kernel_baseline {
[[nodiscard]] SeaKernels sea_kernels() noexcept;
}
namespace kernel_avx2 {
[[nodiscard]] SeaKernels sea_kernels() noexcept;
}
namespace kernel_avx512 {
[[nodiscard]] SeaKernels sea_kernels() noexcept;
}

}  // namespace slackwater
