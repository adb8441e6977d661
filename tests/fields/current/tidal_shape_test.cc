#include "fields/current/tidal_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fields/current/coriolis.h"

namespace slackwater {
namespace {

constexpr double m2_rad_s = 1.405189e-4;

double coriolis(double latitude_deg) {
  return coriolis_parameter_rad_s(Angle::from_degrees(latitude_deg));
}

Horizontal shape(double viscosity, double friction, double f, double speed, double depth_m,
                 double d) {
  return to_horizontal(TidalShape<double>(viscosity, friction, f, speed, depth_m).at_depth(d));
}

/// nu W'' = i s (W - 1) on a grid, no stress on top, nu W' = r W at the bed, over its own mean.
std::vector<Horizontal> on_a_grid(double viscosity, double friction, double s, double depth_m,
                                  std::size_t cells) {
  const double dz = depth_m / static_cast<double>(cells);
  const double exchange = viscosity / (dz * dz);
  const double drag = 1.0 / (1.0 / friction + 0.5 * dz / viscosity) / dz;
  std::vector<Horizontal> upper(cells), w(cells);
  for (std::size_t j = 0; j < cells; ++j) {
    const double leaves = exchange * ((j > 0 ? 1.0 : 0.0) + (j + 1 < cells ? 1.0 : 0.0)) +
                          (j + 1 == cells ? drag : 0.0);
    const Horizontal above = j > 0 ? -exchange * upper[j - 1] : Horizontal{};
    const Horizontal pivot = Horizontal(leaves, s) - above;
    upper[j] = -exchange / pivot;
    w[j] = (Horizontal(0, s) + (j > 0 ? exchange * w[j - 1] : Horizontal{})) / pivot;
  }
  for (std::size_t j = cells - 1; j-- > 0;) w[j] -= upper[j] * w[j + 1];
  Horizontal mean{};
  for (const Horizontal& x : w) mean += x / static_cast<double>(cells);
  for (Horizontal& x : w) x /= mean;
  return w;
}

TEST(TidalShape, AgreesWithFiniteDifferencesInBothSensesAndHemispheres) {
  constexpr std::size_t cells = 2000;  // second order: 1e-6 of the thinnest layer's curvature
  for (const double latitude : {48.9, -30.0, 5.0}) {
    for (const double speed : {m2_rad_s, -m2_rad_s}) {
      for (const double friction : {1e-5, 1e-3}) {
        const double f = coriolis(latitude);
        const auto grid = on_a_grid(0.02, friction, f + speed, 40, cells);
        for (std::size_t j = 0; j < cells; j += 37) {
          const double d = 40.0 * (static_cast<double>(j) + 0.5) / static_cast<double>(cells);
          EXPECT_LT(std::abs(shape(0.02, friction, f, speed, 40, d) - grid[j]), 1e-5)
              << latitude << ' ' << speed << ' ' << d;
        }
      }
    }
  }
}

TEST(TidalShape, HasNoStressAtTheSurfaceAndTheLinearDragAtTheBed) {
  const double nu = 0.01;
  const double friction = 8e-4;
  const double step_m = 1e-3;
  for (const double speed : {m2_rad_s, -m2_rad_s}) {
    const TidalShape<double> tide(nu, friction, coriolis(54), speed, 30);
    const auto at = [&](double d) { return to_horizontal(tide.at_depth(d)); };
    // One-sided differences of first order: step times curvature, i (f + w)/nu of order 0.03.
    EXPECT_LT(std::abs(at(step_m) - at(0)) / step_m, 1e-4);
    EXPECT_LT(std::abs(nu * (at(30 - step_m) - at(30)) / step_m - friction * at(30)), 1e-6);
  }
}

TEST(TidalShape, ItsMeanOverDepthIsOne) {
  for (const double latitude : {60.0, -20.0}) {
    for (const double speed : {m2_rad_s, -m2_rad_s, 7.29e-5}) {
      const TidalShape<double> tide(0.005, 1e-3, coriolis(latitude), speed, 50);
      Horizontal sum{};
      constexpr int parts = 20000;  // midpoint rule
      for (int i = 0; i < parts; ++i)
        sum += to_horizontal(tide.at_depth(50 * (i + 0.5) / parts)) / static_cast<double>(parts);
      EXPECT_LT(std::abs(sum - 1.0), 1e-7);
    }
  }
}

TEST(TidalShape, AtTheInertialFrequencyItIsTheParabolaOfFlowThatDoesNotTurn) {
  // nu W'' = -G, nu W' = r W at the bed: S = [H/r + (H^2 - d^2)/(2 nu)]/[H/r + H^2/(3 nu)].
  const double nu = 0.02;
  const double r = 5e-4;
  const double depth_m = 35;
  for (const double latitude : {45.0, -45.0}) {
    const double f = coriolis(latitude);
    for (const double off : {0.0, 1e-12, -1e-12, 1e-8, 2e-7, -2e-7}) {
      for (const double d : {0.0, 10.0, 30.0, 35.0}) {
        const double parabola = (depth_m / r + (depth_m * depth_m - d * d) / (2 * nu)) /
                                (depth_m / r + depth_m * depth_m / (3 * nu));
        // First order in (f + w) H^2/nu, at most 0.012, times a tenth for the shape.
        EXPECT_LT(std::abs(shape(nu, r, f, -f + off, depth_m, d) - parabola), 2.5e-3);
      }
    }
  }
}

TEST(TidalShape, TheSenseThatTurnsWithTheEarthHasTheThickerLayer) {
  // Height above the bed at which 95 % of the surface value are reached.
  const auto thickness_m = [](double latitude, double speed) {
    const TidalShape<double> tide(0.005, 2e-3, coriolis(latitude), speed, 200);
    const double surface = std::abs(to_horizontal(tide.at_depth(0)));
    double height = 0;
    while (std::abs(to_horizontal(tide.at_depth(200 - height))) < 0.95 * surface) height += 0.1;
    return height;
  };
  EXPECT_GT(thickness_m(50, -m2_rad_s), 1.5 * thickness_m(50, m2_rad_s));
  EXPECT_GT(thickness_m(-50, m2_rad_s), 1.5 * thickness_m(-50, -m2_rad_s));
}

TEST(TidalShape, MirrorsBetweenTheHemispheres) {
  for (const double d : {0.0, 12.0, 29.0}) {
    EXPECT_LT(std::abs(shape(0.01, 1e-3, coriolis(40), m2_rad_s, 30, d) -
                       std::conj(shape(0.01, 1e-3, coriolis(-40), -m2_rad_s, 30, d))),
              1e-14);
  }
}

TEST(TidalShape, WithoutFrictionItIsOneAtAllDepths) {
  for (const double d : {0.0, 12.0, 30.0})
    EXPECT_LT(std::abs(shape(0.01, 1e-12, coriolis(40), m2_rad_s, 30, d) - 1.0), 1e-7);
}

}  // namespace
}  // namespace slackwater
