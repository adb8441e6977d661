// Compiled once per instruction set, see cmake/SlackwaterKernels.cmake; SLACKWATER_KERNEL names the
// namespace.
#include "fields/current/steady_column_kernel.h"

#ifndef SLACKWATER_KERNEL
#error "compile this file through slackwater_kernels (cmake/SlackwaterKernels.cmake)"
#endif

namespace slackwater::SLACKWATER_KERNEL {

void evaluate_steady_kernel(const SteadyKernelArguments& arguments) noexcept {
  const double* __restrict a_re = arguments.interior_re;
  const double* __restrict a_im = arguments.interior_im;
  const double* __restrict b_re = arguments.stress_re;
  const double* __restrict b_im = arguments.stress_im;
  const double w_re = arguments.flow_re;
  const double w_im = arguments.flow_im;
  const std::size_t levels = arguments.levels;
  for (std::size_t t = 0; t < arguments.times; ++t) {
    const double t_re = arguments.stress[2 * t];
    const double t_im = arguments.stress[2 * t + 1];
    double* __restrict out = arguments.out + 2 * levels * t;
    for (std::size_t k = 0; k < levels; ++k) {
      out[2 * k] = (w_re * a_re[k] - w_im * a_im[k]) + (t_re * b_re[k] - t_im * b_im[k]);
      out[2 * k + 1] = (w_re * a_im[k] + w_im * a_re[k]) + (t_re * b_im[k] + t_im * b_re[k]);
    }
  }
}

}  // namespace slackwater::SLACKWATER_KERNEL
