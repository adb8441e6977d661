#include "calibration/propagate/inertial_memory.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/random.h"

namespace slackwater::calibration {
namespace {

using std::chrono::hours;

const UtcTime end_of_day{hours(24)};
const Horizontal constant{0.03, -0.05};
const Horizontal amplitude{0.10, 0.20};
/// No belief: plain least squares.
const MemoryPrior none{.unexplained_m_s = 1e-9};

Horizontal lambda(double latitude_deg) {
  return {1.0 / 48.0, 3600 * 2 * constants::earth_rotation_rad_s *
                          std::sin(latitude_deg * constants::pi / 180)};
}

InertialBasis free_basis(double latitude_deg) { return {end_of_day, lambda(latitude_deg)}; }

/// The exact residual at an instant; lead in hours after the end of D.
Horizontal exact(double lead_h, double latitude_deg) {
  return constant + amplitude * std::exp(-lambda(latitude_deg) * lead_h);
}

VectorColumn empty_day() {
  VectorColumn residual;
  residual.levels_m = {10};
  residual.vertical = VerticalKind::depth_m;
  return residual;
}

void add(VectorColumn& residual, const TimeCell& cell, Horizontal value) {
  residual.time.push_back(cell);
  residual.value.push_back(value);
  residual.status.push_back(SampleStatus::ok);
  residual.source.push_back(DataStatus::analysis);
}

TimeCell instant(double hour) { return TimeCell::instant(add_hours(UtcTime(hours(0)), hour)); }

/// A wind that freshens and veers, from two days before D to two after.
VectorColumn wind(Horizontal turn = 1.0) {
  VectorColumn column;
  for (int h = -48; h <= 72; ++h) {
    const double speed = 8 + 5 * std::tanh((h - 6) / 6.0);
    add(column, TimeCell::instant(UtcTime(hours(h))),
        turn * std::polar(speed, 0.3 + 0.02 * h + 0.8 * std::sin(0.2 * h)));
  }
  return column;
}

InertialBasis driven_basis(double latitude_deg, Horizontal turn = 1.0) {
  const StressSeries series(wind(turn), DragLaw::paper_linear);
  return {end_of_day, lambda(latitude_deg), series,
          HourlyStress::sample(series, end_of_day, 48, 48)};
}

TEST(InertialMemory, RecoversConstantAndOscillationInBothHemispheres) {
  for (const double latitude : {46.8, -32.0}) {
    VectorColumn residual = empty_day();
    for (int t = 0; t <= 24; t += 6) add(residual, instant(t), exact(t - 24.0, latitude));
    const InertialBasis basis = free_basis(latitude);
    const InertialMemory memory = *fit_inertial_memory(residual, 0, basis, none);
    EXPECT_LT(std::abs(memory.coefficients(0) - constant), 1e-9);
    EXPECT_LT(std::abs(memory.coefficients(2) - amplitude), 1e-9);
    EXPECT_LT(std::abs(memory.at(basis.over(instant(37))) - exact(13, latitude)), 1e-9);
    EXPECT_LT(memory.left_over_m_s, 1e-9);
  }
}

TEST(InertialMemory, FitsMeansAsMeans) {
  VectorColumn residual = empty_day();
  for (int t = 0; t < 24; ++t) {
    // The mean over the hour by Simpson's rule on 60 parts: its error is far below 1e-10.
    Horizontal mean{};
    for (int i = 0; i <= 60; ++i) {
      const double weight = (i == 0 || i == 60 ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) / 180.0;
      mean += weight * exact(t - 24.0 + i / 60.0, 43.0);
    }
    add(residual, {UtcTime(hours(t)), UtcTime(hours(t + 1))}, mean);
  }
  const InertialMemory memory = *fit_inertial_memory(residual, 0, free_basis(43.0), none);
  EXPECT_LT(std::abs(memory.coefficients(0) - constant), 1e-9);
  EXPECT_LT(std::abs(memory.coefficients(2) - amplitude), 1e-9);
}

TEST(InertialBasis, TheSlabSolvesItsEquationOfMotion) {
  // Central differences of s against -lambda s + T/(rho h); 1 minute, error 1e-7 of the rate.
  const InertialBasis basis = driven_basis(50);
  const StressSeries series(wind(), DragLaw::paper_linear);
  const double per_pa = 3600.0 / (constants::sea_water_density_kg_m3 * InertialBasis::slab_depth_m);
  for (const double t_h : {1.5, 9.25, 30.5}) {
    const double step_h = 1.0 / 60;
    const auto slab = [&](double h) { return basis.over(instant(h))(1); };
    const Horizontal rate = (slab(t_h + step_h) - slab(t_h - step_h)) / (2 * step_h);
    const Horizontal forcing = per_pa * *series.at(instant(t_h).start);
    EXPECT_LT(std::abs(rate + lambda(50) * slab(t_h) - forcing), 1e-5 * std::abs(forcing));
  }
}

TEST(InertialMemory, TellsAFreeFromADrivenMotion) {
  const InertialBasis basis = driven_basis(50);
  const Horizontal share(0.5, -0.2);
  VectorColumn residual = empty_day();
  for (int t = 0; t < 24; ++t) {
    const TimeCell hour{UtcTime(hours(t)), UtcTime(hours(t + 1))};
    const Eigen::Vector3cd row = basis.over(hour);
    add(residual, hour, constant * row(0) + share * row(1) + amplitude * row(2));
  }
  const InertialMemory memory = *fit_inertial_memory(residual, 0, basis, none);
  EXPECT_LT(std::abs(memory.coefficients(0) - constant), 1e-6);
  EXPECT_LT(std::abs(memory.coefficients(1) - share), 1e-6);
  EXPECT_LT(std::abs(memory.coefficients(2) - amplitude), 1e-6);
}

TEST(InertialMemory, TurnsWithTheAxes) {
  const Horizontal turn = std::exp(Horizontal(0, 1.1));
  VectorColumn residual = empty_day();
  VectorColumn turned = empty_day();
  for (int t = 0; t <= 24; t += 3) {
    const Horizontal value = exact(t - 24.0, 50.0) + Horizontal(0.01 * t, -0.02 * (t % 5));
    add(residual, instant(t), value);
    add(turned, instant(t), turn * value);
  }
  const auto a = *fit_inertial_memory(residual, 0, driven_basis(50), {});
  const auto b = *fit_inertial_memory(turned, 0, driven_basis(50, turn), {});
  EXPECT_LT(std::abs(turn * a.coefficients(0) - b.coefficients(0)), 1e-13);
  EXPECT_LT(std::abs(a.coefficients(1) - b.coefficients(1)), 1e-12);
  EXPECT_LT(std::abs(turn * a.coefficients(2) - b.coefficients(2)), 1e-13);
}

TEST(InertialMemory, OneDailyMeanTellsNothingOfAnOscillation) {
  VectorColumn residual = empty_day();
  add(residual, {UtcTime(hours(0)), UtcTime(hours(24))}, {0.2, 0.1});
  const InertialMemory memory = *fit_inertial_memory(residual, 0, driven_basis(46.8), {});
  EXPECT_LT(std::abs(memory.coefficients(0) - Horizontal(0.2, 0.1)), 1e-15);
  EXPECT_EQ(memory.coefficients(1), Horizontal(0, 0));
  EXPECT_EQ(memory.coefficients(2), Horizontal(0, 0));
  EXPECT_FALSE(memory.has_motion);
}

TEST(InertialMemory, ThreeValuesGiveAMeanAndFourAMotionThatThePriorShrinks) {
  VectorColumn residual = empty_day();
  for (const int t : {6, 12, 18}) add(residual, instant(t), exact(t - 24.0, 46.8));
  const InertialBasis basis = free_basis(46.8);
  EXPECT_EQ(fit_inertial_memory(residual, 0, basis, {})->coefficients(2), Horizontal(0, 0));
  add(residual, instant(24), exact(0, 46.8));
  const double found = std::abs(fit_inertial_memory(residual, 0, basis, {})->coefficients(2));
  EXPECT_LT(found, std::abs(amplitude));
  EXPECT_GT(found, 0.8 * std::abs(amplitude));
}

TEST(InertialMemory, ItsErrorsAreAsLargeAsItSays) {
  // Slow noise: constant over 6 h, of the size the prior expects, about random motions.
  Rng rng(8, "tests/inertial_memory");
  const InertialBasis basis = free_basis(50);
  const MemoryPrior prior;
  const Eigen::Vector3cd later = basis.over(instant(34));
  double squares = 0;
  double said = 0;
  for (int i = 0; i < 400; ++i) {
    const Horizontal c = prior.oscillation_m_s * Horizontal(rng.normal(), rng.normal());
    VectorColumn residual = empty_day();
    Horizontal noise{};
    for (int t = 0; t < 24; ++t) {
      if (t % 6 == 0) noise = prior.unexplained_m_s * Horizontal(rng.normal(), rng.normal());
      const TimeCell hour{UtcTime(hours(t)), UtcTime(hours(t + 1))};
      add(residual, hour, c * basis.over(hour)(2) + noise);
    }
    const InertialMemory memory = *fit_inertial_memory(residual, 0, basis, prior);
    squares += 0.5 * std::norm(memory.at(later) - c * later(2));
    said += memory.variance_at(later);
  }
  // 400 draws: 4 %; block noise is a little less harmful than the independent values it stands for.
  EXPECT_NEAR(std::sqrt(squares / said), 1.0, 0.25);
}

TEST(InertialMemory, ALevelWithoutValuesHasNone) {
  VectorColumn residual = empty_day();
  add(residual, instant(3), {1, 1});
  residual.status[0] = SampleStatus::missing;
  EXPECT_FALSE(fit_inertial_memory(residual, 0, free_basis(50), {}));
}

}  // namespace
}  // namespace slackwater::calibration
