#pragma once
#include <cstddef>

namespace slackwater {

/// What the batch kernel reads and writes. Plain pointers and sizes on purpose: the kernel is
/// compiled once per instruction set, and an inline function shared with other files could be taken
/// by the linker from the object that needs AVX-512 and run where there is none.
struct SteadyKernelArguments {
  std::size_t levels = 0;
  const double* interior_re = nullptr;  ///< A, levels
  const double* interior_im = nullptr;
  const double* stress_re = nullptr;  ///< B, levels
  const double* stress_im = nullptr;
  double flow_re = 0;  ///< W_interior
  double flow_im = 0;
  std::size_t times = 0;
  const double* stress = nullptr;  ///< T, times x (east, north)
  double* out = nullptr;           ///< times x levels x (east, north)
};

namespace kernel_baseline {
void evaluate_steady_kernel(const SteadyKernelArguments& arguments) noexcept;
}
namespace kernel_avx2 {
void evaluate_steady_kernel(const SteadyKernelArguments& arguments) noexcept;
}
namespace kernel_avx512 {
void evaluate_steady_kernel(const SteadyKernelArguments& arguments) noexcept;
}

}  // namespace slackwater
