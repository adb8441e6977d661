#include "fields/current/kernel_dispatch.h"

#include "fields/current/steady_column_kernel.h"

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

void evaluate_steady_on(KernelPath path, const LevelResponses& responses, Horizontal interior_m_s,
                        std::span<const Horizontal> stress_pa, std::span<Horizontal> out) {
  expects(out.size() == stress_pa.size() * responses.levels(),
          "out must hold times x levels values");
  SteadyKernelArguments arguments;
  arguments.levels = responses.levels();
  arguments.interior_re = responses.interior_re.data();
  arguments.interior_im = responses.interior_im.data();
  arguments.stress_re = responses.stress_re.data();
  arguments.stress_im = responses.stress_im.data();
  arguments.flow_re = interior_m_s.real();
  arguments.flow_im = interior_m_s.imag();
  arguments.times = stress_pa.size();
  // std::complex<double> is an array of two doubles by [complex.numbers.general].
  arguments.stress = reinterpret_cast<const double*>(stress_pa.data());
  arguments.out = reinterpret_cast<double*>(out.data());
  switch (path) {
#ifdef SLACKWATER_X86_KERNELS
    case KernelPath::avx2:
      kernel_avx2::evaluate_steady_kernel(arguments);
      return;
    case KernelPath::avx512:
      kernel_avx512::evaluate_steady_kernel(arguments);
      return;
#endif
    default:
      kernel_baseline::evaluate_steady_kernel(arguments);
  }
}

}  // namespace slackwater
