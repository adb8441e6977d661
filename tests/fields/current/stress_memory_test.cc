#include "fields/current/stress_memory.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/numbers/random.h"

namespace slackwater::stress_memory_test {
namespace {

using std::chrono::hours;
using std::chrono::minutes;

const UtcTime start{hours(0)};
const Horizontal lambda{1.0 / 30.0, 0.4};

HourlyStress random_stress(int n) {
  Rng rng(5, "tests/stress_memory");
  HourlyStress stress;
  stress.first = start;
  for (int i = 0; i < n; ++i) {
    stress.stress_pa.emplace_back(0.2 * rng.normal(), 0.2 * rng.normal());
    stress.is_known.push_back(true);
  }
  return stress;
}

TEST(StressMemory, AStepDecaysAndTurns) {
  HourlyStress stress;
  stress.first = start;
  stress.stress_pa.assign(40, Horizontal(0.1, 0.3));
  stress.stress_pa[0] = 0;
  stress.is_known.assign(40, true);
  const StressMemory memory(stress, lambda);
  // The mean of e^{-lambda (t - s)} over the hour in which the stress rises.
  const Horizontal rise = (1.0 - std::exp(-lambda)) / lambda * Horizontal(0.1, 0.3);
  for (int h = 1; h < 40; ++h) {
    EXPECT_LT(std::abs(memory.over(TimeCell::instant(UtcTime(hours(h)))).memory_pa -
                       rise * std::exp(-lambda * (h - 1.0))),
              1e-15);
  }
}

TEST(StressMemory, ItsDefinitionAsAnIntegralHoldsAtAnyMinute) {
  const HourlyStress stress = random_stress(30);
  const StressMemory memory(stress, lambda);
  for (const double t_h : {0.0, 0.25, 7.5, 12.0, 28.9}) {
    Horizontal sum{};
    constexpr double step_h = 1.0 / 2000;  // midpoint rule: error of a relative 1e-8
    for (double s_h = 0.5 * step_h; s_h < t_h; s_h += step_h) {
      const auto i = static_cast<std::size_t>(s_h);
      sum += step_h * std::exp(-lambda * (t_h - s_h)) *
             (stress.stress_pa[i + 1] - stress.stress_pa[i]);
    }
    EXPECT_LT(std::abs(memory.over(TimeCell::instant(add_hours(start, t_h))).memory_pa - sum),
              1e-6);
  }
}

TEST(StressMemory, AMeanIsTheMeanOfInstants) {
  const StressMemory memory(random_stress(30), lambda);
  for (const auto& [from_h, to_h] : {std::pair{3.0, 4.0}, {3.5, 9.5}, {0.0, 24.0}, {27.0, 33.0}}) {
    const int parts = 20000;
    Horizontal sum{};
    for (int i = 0; i < parts; ++i) {
      const double t_h = from_h + (to_h - from_h) * (i + 0.5) / parts;
      sum += memory.over(TimeCell::instant(add_hours(start, t_h))).memory_pa;
    }
    EXPECT_LT(std::abs(memory.over({add_hours(start, from_h), add_hours(start, to_h)}).memory_pa -
                       sum / static_cast<double>(parts)),
              1e-6);
  }
}

TEST(StressMemory, AConstantWindAndAGapLeaveNothingToRemember) {
  HourlyStress stress;
  stress.first = start;
  stress.stress_pa.assign(20, Horizontal(0.1, 0.3));
  stress.is_known.assign(20, true);
  for (std::size_t i = 5; i < 8; ++i) {
    stress.stress_pa[i] = 0;
    stress.is_known[i] = false;
  }
  for (std::size_t i = 8; i < 20; ++i) stress.stress_pa[i] = {0.5, -0.2};
  const StressMemory memory(stress, lambda);
  for (int m = -90; m < 30 * 60; m += 17)
    EXPECT_EQ(memory.over(TimeCell::instant(UtcTime(minutes(m)))).memory_pa, Horizontal(0, 0));
}

TEST(StressMemory, OnceTheWindIsConstantItsModulusOnlyFalls) {
  HourlyStress stress = random_stress(40);
  for (std::size_t i = 10; i < 40; ++i) stress.stress_pa[i] = stress.stress_pa[10];
  const StressMemory memory(stress, lambda);
  double before = std::abs(memory.over(TimeCell::instant(UtcTime(hours(10)))).memory_pa);
  EXPECT_GT(before, 0.01);
  for (int m = 620; m < 50 * 60; m += 20) {
    const double now = std::abs(memory.over(TimeCell::instant(UtcTime(minutes(m)))).memory_pa);
    EXPECT_LT(now, before);
    before = now;
  }
}

TEST(StressMemory, ItsDerivativeByLambdaAgreesWithCentralDifferences) {
  // Holomorphic: a step along the real and one along the imaginary axis give the same derivative.
  HourlyStress stress = random_stress(30);
  stress.is_known[17] = false;
  stress.stress_pa[17] = 0;
  for (const Horizontal rate : {lambda, Horizontal(1e-3, -0.5), Horizontal(11.0, 0.4)}) {
    const StressMemory memory(stress, rate);
    for (const Horizontal step : {Horizontal(1e-5, 0), Horizontal(0, 1e-5)}) {
      const StressMemory more(stress, rate + step);
      const StressMemory less(stress, rate - step);
      for (const auto& [from_h, to_h] : {std::pair{7.25, 7.25},
                                         {12.0, 12.0},
                                         {29.0, 29.0},
                                         {35.5, 35.5},
                                         {3.5, 9.5},
                                         {0.0, 24.0},
                                         {27.0, 33.0}}) {
        const TimeCell cell{add_hours(start, from_h), add_hours(start, to_h)};
        const Horizontal difference =
            (more.over(cell).memory_pa - less.over(cell).memory_pa) / (2.0 * step);
        // Truncation: h^2/6 = 2e-11 times the cube of 30 h; rounding: 1e-16/1e-5.
        EXPECT_LT(std::abs(memory.over(cell).by_lambda_pa_h - difference), 2e-6)
            << rate << ' ' << from_h << ' ' << to_h;
      }
    }
  }
}

}  // namespace
}  // namespace slackwater::stress_memory_test
