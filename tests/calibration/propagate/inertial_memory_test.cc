#include "calibration/propagate/inertial_memory.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"

namespace slackwater::calibration {
namespace {

using std::chrono::hours;

constexpr double damping_per_h = 1.0 / 48.0;
const UtcTime end_of_day{hours(24)};
const Horizontal constant{0.03, -0.05};
const Horizontal amplitude{0.10, 0.20};

double coriolis_rad_h(double latitude_deg) {
  return 3600 * 2 * constants::earth_rotation_rad_s * std::sin(latitude_deg * constants::pi / 180);
}

/// The exact residual at an instant; lead in hours after the end of D.
Horizontal exact(double lead_h, double latitude_deg) {
  return constant +
         amplitude * std::exp(-Horizontal(damping_per_h, coriolis_rad_h(latitude_deg)) * lead_h);
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

InertialMemory fit(const VectorColumn& residual, double latitude_deg, double prior) {
  return *fit_inertial_memory(residual, 0, end_of_day, damping_per_h, coriolis_rad_h(latitude_deg),
                              prior);
}

TEST(InertialMemory, RecoversConstantAndOscillationInBothHemispheres) {
  for (const double latitude : {46.8, -32.0}) {
    VectorColumn residual = empty_day();
    for (int t = 0; t <= 24; t += 6)
      add(residual, TimeCell::instant(UtcTime(hours(t))), exact(t - 24.0, latitude));
    const InertialMemory memory = fit(residual, latitude, 0);
    EXPECT_LT(std::abs(memory.constant_m_s - constant), 1e-12);
    EXPECT_LT(std::abs(memory.oscillation_m_s - amplitude), 1e-12);
    EXPECT_LT(std::abs(memory.constant_m_s +
                       memory.oscillation_at(13, damping_per_h, coriolis_rad_h(latitude)) -
                       exact(13, latitude)),
              1e-12);
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
  const InertialMemory memory = fit(residual, 43.0, 0);
  EXPECT_LT(std::abs(memory.constant_m_s - constant), 1e-9);
  EXPECT_LT(std::abs(memory.oscillation_m_s - amplitude), 1e-9);
}

TEST(InertialMemory, TurnsWithTheAxes) {
  const Horizontal turn = std::exp(Horizontal(0, 1.1));
  VectorColumn residual = empty_day();
  VectorColumn turned = empty_day();
  for (int t = 0; t <= 24; t += 3) {
    const Horizontal value = exact(t - 24.0, 50.0) + Horizontal(0.01 * t, -0.02 * (t % 5));
    add(residual, TimeCell::instant(UtcTime(hours(t))), value);
    add(turned, TimeCell::instant(UtcTime(hours(t))), turn * value);
  }
  const InertialMemory a = fit(residual, 50.0, 1);
  const InertialMemory b = fit(turned, 50.0, 1);
  EXPECT_LT(std::abs(turn * a.oscillation_m_s - b.oscillation_m_s), 1e-14);
  EXPECT_LT(std::abs(turn * a.constant_m_s - b.constant_m_s), 1e-14);
}

TEST(InertialMemory, OneDailyMeanTellsNothingOfAnOscillation) {
  VectorColumn residual = empty_day();
  add(residual, {UtcTime(hours(0)), UtcTime(hours(24))}, {0.2, 0.1});
  const InertialMemory memory = fit(residual, 46.8, 1);
  EXPECT_LT(std::abs(memory.oscillation_m_s), 1e-15);
  EXPECT_LT(std::abs(memory.constant_m_s - Horizontal(0.2, 0.1)), 1e-15);
}

TEST(InertialMemory, ThePriorShrinksWhatFewValuesSay) {
  VectorColumn residual = empty_day();
  for (const int t : {12, 24})
    add(residual, TimeCell::instant(UtcTime(hours(t))), exact(t - 24.0, 46.8));
  const double few = std::abs(fit(residual, 46.8, 1).oscillation_m_s);
  EXPECT_LT(few, 0.75 * std::abs(amplitude));
  EXPECT_GT(few, 0.1 * std::abs(amplitude));
}

TEST(InertialMemory, ALevelWithoutValuesHasNone) {
  VectorColumn residual = empty_day();
  add(residual, TimeCell::instant(UtcTime(hours(3))), {1, 1});
  residual.status[0] = SampleStatus::missing;
  EXPECT_FALSE(fit_inertial_memory(residual, 0, end_of_day, damping_per_h, coriolis_rad_h(50), 1));
}

}  // namespace
}  // namespace slackwater::calibration
