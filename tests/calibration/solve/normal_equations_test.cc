#include "calibration/solve/normal_equations.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/numbers/random.h"

namespace slackwater::calibration::normal_equations_test {
namespace {

constexpr int times = 9;
constexpr int levels = 6;

/// Nine hourly means under a veering wind.
ColumnDay windy_day(SteadyForm form) {
  ColumnDay day;
  day.layout.form = form;
  day.layout.is_unsteady = true;
  day.latitude = Angle::from_degrees(49.0);
  day.water_depth_m = 60.0;
  day.start = parse_utc("2024-03-10T00:00:00Z");
  for (int k = 0; k < levels; ++k) day.depth_m.push_back(1.0 + 11.0 * k);
  day.hourly.first = add_hours(day.start, -12.0);
  for (int h = -12; h <= times; ++h) {
    day.hourly.stress_pa.push_back(std::polar(0.1 + 0.05 * std::sin(0.8 * h), 0.2 * h));
    day.hourly.is_known.push_back(true);
  }
  for (int h = 0; h < times; ++h) {
    day.time.push_back({add_hours(day.start, h), add_hours(day.start, h + 1)});
    day.stress_pa.push_back(0.5 * (day.hourly.stress_pa[static_cast<std::size_t>(h + 12)] +
                                   day.hourly.stress_pa[static_cast<std::size_t>(h + 13)]));
  }
  return day;
}

/// Values of 0.2 m/s at two thirds of the times and levels.
std::vector<Pair> scattered_pairs() {
  Rng random(3, "tests/normal_equations");
  std::vector<Pair> pairs;
  for (std::size_t t = 0; t < times; ++t) {
    for (std::size_t k = 0; k < levels; ++k) {
      if ((t + k) % 3 == 0) continue;
      const double east = 0.2 * random.normal();
      pairs.push_back({{east, 0.2 * random.normal()}, t, k});
    }
  }
  return pairs;
}

std::vector<double> some_estimate(const ParameterLayout& layout) {
  std::vector<double> estimate(layout.count());
  for (std::size_t i = 0; i < estimate.size(); ++i)
    estimate[i] = 0.1 * std::sin(1.0 + static_cast<double>(i));
  estimate[ParameterLayout::log_viscosity] = std::log(0.02);
  estimate[ParameterLayout::log_bottom] = std::log(6e-4);
  if (layout.has_layer()) estimate[layout.log_layer()] = std::log(30.0);
  return estimate;
}

class OfForm : public testing::TestWithParam<SteadyForm> {};

TEST_P(OfForm, TheGradientIsThatOfTheRobustCost) {
  const ColumnDay day = windy_day(GetParam());
  DayMisfit misfit(day, scattered_pairs());
  const std::vector<double> at = some_estimate(day.layout);
  const PairWeighing weighing{0.1, 0.7, Loss::huber};
  const Eigen::VectorXd gradient = misfit.normal_equations(at, weighing).gradient;
  constexpr double step = 1e-5;  // cube root of rounding; the error goes with its square
  for (std::size_t i = 0; i < at.size(); ++i) {
    const auto cost_at = [&](double offset) {
      std::vector<double> moved = at;
      moved[i] += offset;
      return misfit.normal_equations(moved, weighing).cost;
    };
    const double difference = (cost_at(step) - cost_at(-step)) / (2.0 * step);
    EXPECT_NEAR(gradient(static_cast<Eigen::Index>(i)), difference,
                1e-6 * (1.0 + gradient.cwiseAbs().maxCoeff()))
        << "parameter " << i;
  }
}

TEST_P(OfForm, EveryDerivativeOfTheModelIsThatOfFiniteDifferences) {
  const ColumnDay day = windy_day(GetParam());
  ColumnRows rows(day);
  const std::vector<double> at = some_estimate(day.layout);
  rows.evaluate(at.data(), true);
  ColumnRows moved(day);
  constexpr double step = 1e-5;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const auto model_at = [&](double offset) {
      std::vector<double> estimate = at;
      estimate[i] += offset;
      moved.evaluate(estimate.data(), false);
      return moved.model();
    };
    const ColumnRows::Matrix high = model_at(step);
    const ColumnRows::Matrix difference = (high - model_at(-step)) / (2.0 * step);
    EXPECT_LT((rows.derivative(i) - difference).cwiseAbs().maxCoeff(), 1e-8) << "parameter " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(DayMisfit, OfForm,
                         testing::Values(SteadyForm::finite_depth, SteadyForm::mixed_layer));

TEST(DayMisfit, PlainSquaresGiveTheWeightedSumOverThePairsAlone) {
  const ColumnDay day = windy_day(SteadyForm::finite_depth);
  const std::vector<Pair> pairs = scattered_pairs();
  DayMisfit misfit(day, pairs);
  const std::vector<double> at = some_estimate(day.layout);
  const NormalEquations found = misfit.normal_equations(at, {0.1, 0.7, Loss::plain});
  ColumnRows rows(day);
  rows.evaluate(at.data(), true);
  double cost = 0;
  double corner = 0;
  for (const Pair& pair : pairs) {
    const auto t = static_cast<Eigen::Index>(pair.time);
    const auto k = static_cast<Eigen::Index>(pair.level);
    cost += 0.5 * 0.7 * std::norm(rows.model()(t, k) - pair.observed_m_s) / (0.1 * 0.1);
    corner +=
        0.7 / (0.1 * 0.1) * (std::conj(rows.derivative(2)(t, k)) * rows.derivative(4)(t, k)).real();
  }
  EXPECT_NEAR(found.cost, cost, 1e-12 * cost);
  EXPECT_NEAR(found.information(2, 4), corner, 1e-10 * std::abs(corner));
  EXPECT_EQ(found.information(2, 4), found.information(4, 2));
}

TEST(DayMisfit, GoingBackAndForthChangesNothing) {
  const ColumnDay day = windy_day(SteadyForm::mixed_layer);
  DayMisfit misfit(day, scattered_pairs());
  std::vector<double> other = some_estimate(day.layout);
  const std::vector<double> at = other;
  other[2] += 0.3;
  const PairWeighing weighing{0.1, 1.0, Loss::huber};
  const NormalEquations first = misfit.normal_equations(at, weighing);
  for (int i = 0; i < 3; ++i) {
    static_cast<void>(misfit.normal_equations(other, weighing));
    static_cast<void>(misfit.at(at, false));
    other[3] += 0.1;
  }
  const NormalEquations again = misfit.normal_equations(at, weighing);
  EXPECT_EQ(first.cost, again.cost);
  EXPECT_EQ(first.gradient, again.gradient);
  EXPECT_EQ(first.information, again.information);
}

}  // namespace
}  // namespace slackwater::calibration::normal_equations_test
