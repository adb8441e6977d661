#include "fields/current/kernel_dispatch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "fields/base/random.h"

namespace slackwater {
namespace {

TEST(KernelDispatch, EveryPathOfThisMachineGivesTheSameBits) {
  Rng rng(3, "kernel_dispatch");
  const auto paths = supported_kernel_paths();
  ASSERT_EQ(paths.front(), KernelPath::baseline);
  // Level counts around the vector widths, so that bodies and remainders of the loops are both met.
  for (const std::size_t levels : {0u, 1u, 2u, 3u, 4u, 7u, 8u, 9u, 15u, 16u, 17u, 35u, 50u, 131u}) {
    for (const std::size_t times : {0u, 1u, 5u}) {
      LevelResponses r;
      for (std::size_t k = 0; k < levels; ++k) {
        const double scale =
            std::exp(rng.uniform(-300, 5));  // degenerate scales: down to denormals
        r.depth_m.push_back(static_cast<double>(k));
        r.interior_re.push_back(rng.normal());
        r.interior_im.push_back(scale * rng.normal());
        r.stress_re.push_back(scale * rng.normal());
        r.stress_im.push_back(rng.normal());
      }
      std::vector<Horizontal> stress(times);
      for (Horizontal& s : stress) s = {rng.normal(), rng.normal()};
      const Horizontal flow{rng.normal(), rng.normal()};
      std::vector<Horizontal> reference(times * levels);
      evaluate_steady_on(KernelPath::baseline, r, flow, stress, reference);
      for (const KernelPath path : paths) {
        std::vector<Horizontal> out(times * levels, Horizontal{-9, -9});
        evaluate_steady_on(path, r, flow, stress, out);
        if (out.empty()) continue;
        EXPECT_EQ(std::memcmp(out.data(), reference.data(), out.size() * sizeof(Horizontal)), 0)
            << name_of(path) << ' ' << levels << ' ' << times;
      }
    }
  }
}

TEST(KernelDispatch, TheKernelIsTheFormula) {
  LevelResponses r;
  r.depth_m = {0, 1};
  r.interior_re = {1, 0.5};
  r.interior_im = {0, -0.25};
  r.stress_re = {2, 1};
  r.stress_im = {-1, 3};
  const std::vector<Horizontal> stress{{1, 0}, {0.5, -2}};
  const Horizontal flow{0.3, 0.7};
  for (const KernelPath path : supported_kernel_paths()) {
    std::vector<Horizontal> out(4);
    evaluate_steady_on(path, r, flow, stress, out);
    for (std::size_t t = 0; t < 2; ++t) {
      for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_LT(std::abs(out[2 * t + k] - (flow * r.interior(k) + stress[t] * r.stress(k))),
                  1e-15);
      }
    }
  }
}

TEST(KernelDispatch, AWrongOutputSizeIsAContractViolation) {
  LevelResponses r;
  std::vector<Horizontal> out(1);
  EXPECT_THROW(evaluate_steady_on(KernelPath::baseline, r, {}, {}, out), ContractViolation);
}

}  // namespace
}  // namespace slackwater
