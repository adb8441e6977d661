#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/error.h"
#include "tests/twin/tether/tether_for_tests.h"

namespace slackwater::twin::tether_at_rest_test {
namespace {

using constants::gravity_m_s2;
using tests::fathom;
using tests::settled_line;
using tests::SettledLine;
using tests::stiff_and_neutral;
using tests::weight_in_water_n_m;

SteadyWater uniform(const Triple<double>& velocity_m_s) {
  return [=](double) { return velocity_m_s; };
}

/// a with 2 a sinh(D/2a) = L: the parameter of the catenary of that length over that distance.
double catenary_parameter(double length_m, double distance_m) {
  double low = 1e-3 * distance_m;
  double high = 1e3 * distance_m;
  for (int i = 0; i < 200; ++i) {
    const double a = std::sqrt(low * high);
    (2 * a * std::sinh(distance_m / (2 * a)) > length_m ? low : high) = a;
  }
  return low;
}

/// twin/docs/vehicles.md: 50 m of tether across 0.5 m/s cost 29.2 N, and with the vehicle's own
/// 13.6 N 42.8 N within 2 %.
TEST(TetherAtRest, TautAcrossTheFlowPassesHalfItsDragToEachEnd) {
  const Tether tether = fathom();
  const double per_m = 0.5 * 1025 * 1.2 * 0.0076 * 0.25;
  EXPECT_NEAR(per_m, 1.1685, 1e-12);
  const SettledLine line =
      settled_line(tether, {0, 0, 0.2}, {0, 0, 50.2}, 50, uniform({0.5, 0, 0}));
  const double vehicle_n = 4.03 * 0.5 + 46.2 * 0.25;
  EXPECT_NEAR(line.pull.on_vehicle_n.x + vehicle_n, 42.8, 0.02 * 42.8);
  EXPECT_NEAR(line.pull.on_vehicle_n.x, line.pull.on_top_n.x, 0.01 * line.pull.on_top_n.x);
  EXPECT_EQ(line.pull.taut, 1);
  // Along itself a line without slack pulls far more. Its bow makes room by stretching, T^3 = EA (q
  // L)^2/24 (parabola).
  const double along_n = std::cbrt(5e4 * std::pow(per_m * 50, 2) / 24);
  EXPECT_NEAR(-line.pull.on_vehicle_n.z, along_n, 0.02 * along_n);
}

/// The drag on a slanting line is that of the flow across it, q cos^2, normal to it: so T is the
/// same everywhere and T d(theta)/ds = q cos^2(theta) is the equation of a catenary of parameter
/// T/q.
TEST(TetherAtRest, InUniformFlowANeutralLineIsACatenaryOfOneTension) {
  const Tether tether = stiff_and_neutral();
  for (const double length_m : {50.5, 55.0, 75.0}) {
    const double a = catenary_parameter(length_m, 50);
    const double tension_n = 1.1685 * a;
    const double half_angle = std::atan(std::sinh(25 / a));
    const SettledLine line =
        settled_line(tether, {0, 0, 5}, {0, 0, 55}, length_m, uniform({0.5, 0, 0}));
    // A polygon of N sides errs by the square of the angle from side to side, and takes up 1/N^2
    // less slack than the curve, which tension follows with the power -1/2.
    const double tolerance =
        std::pow(2 * half_angle / tether_segments, 2) / 3 + 0.5 / std::pow(tether_segments, 2);
    EXPECT_NEAR(line.pull.on_vehicle_n.x, tension_n * std::sin(half_angle), tolerance * tension_n);
    EXPECT_NEAR(-line.pull.on_vehicle_n.z, tension_n * std::cos(half_angle),
                2 * tolerance * tension_n);
    for (const double t : line.state.tension_n) EXPECT_NEAR(t, tension_n, 0.01 * tension_n);
    EXPECT_NEAR(line.state.node_m[7].x, a * (std::cosh(25 / a) - 1), 0.01 * length_m);
  }
}

TEST(TetherAtRest, InStillWaterAHeavyLineHangsInACatenary) {
  Tether tether = stiff_and_neutral();
  tether.mass_per_m_kg = 0.2;
  const double w = weight_in_water_n_m(tether);
  const SettledLine line = settled_line(tether, {0, 0, 5}, {20, 0, 5}, 30, uniform({}), {0, 0, 1});
  const double a = catenary_parameter(30, 20);
  EXPECT_NEAR(line.pull.on_vehicle_n.x, -w * a, 0.01 * w * a);
  EXPECT_NEAR(line.pull.on_vehicle_n.z, 0.5 * w * 30, 1e-9);
  EXPECT_NEAR(line.state.node_m[7].z, 5 + a * (std::cosh(10 / a) - 1), 0.03);
}

TEST(TetherAtRest, ALightLineStandsInAnArchThatTheSurfaceEnds) {
  const Tether tether = fathom();
  EXPECT_LT(weight_in_water_n_m(tether), 0);
  const SettledLine line = settled_line(tether, {0, 0, 1}, {5, 0, 6}, 50, uniform({}), {0, 0, -1});
  for (const Triple<double>& node : line.state.node_m) EXPECT_GT(node.z, -0.1);
  EXPECT_LT(line.pull.on_vehicle_n.z, 0);
}

TEST(TetherAtRest, InAirALineHangsByItsWholeWeight) {
  const Tether tether = fathom();
  const SettledLine line =
      settled_line(tether, {0, 0, -25}, {0, 0, -5}, 20, uniform({9, 9, 9}), {1, 0, 0});
  EXPECT_NEAR(line.pull.on_top_n.z + line.pull.on_vehicle_n.z, 20 * 0.043 * gravity_m_s2, 1e-9);
  EXPECT_EQ(line.pull.on_top_n.x, 0);
}

/// What the line bears, worked out from its shape alone.
Triple<double> load_on(const Tether& tether, const SettledLine& line, const Triple<double>& top_m,
                       const Triple<double>& vehicle_m, const SteadyWater& water) {
  std::vector<Triple<double>> at{top_m};
  at.insert(at.end(), line.state.node_m.begin(), line.state.node_m.end());
  at.push_back(vehicle_m);
  Triple<double> sum{0, 0, weight_in_water_n_m(tether) * line.state.length_m};
  const auto unit = [](const Triple<double>& v) { return (1 / std::sqrt(dot(v, v))) * v; };
  for (std::size_t i = 0; i < at.size(); ++i) {
    const bool first = i == 0, last = i + 1 == at.size();
    const Triple<double> t =
        first  ? unit(1.5 * unit(at[1] - at[0]) - 0.5 * unit(at[2] - at[1]))
        : last ? unit(1.5 * unit(at[i] - at[i - 1]) - 0.5 * unit(at[i - 1] - at[i - 2]))
               : unit(at[i + 1] - at[i - 1]);
    const Triple<double> u = water(at[i].z);
    const Triple<double> along = dot(u, t) * t, across = u - along;
    const double length_m = line.state.length_m / tether_segments * (first || last ? 0.5 : 1);
    const double pressure = 0.5 * tether.water_density_kg_m3 * tether.diameter_m * length_m;
    sum = sum + (pressure * 1.2 * std::sqrt(dot(across, across))) * across +
          (pressure * 0.01 * std::sqrt(dot(along, along))) * along;
  }
  return sum;
}

TEST(TetherAtRest, TheEndsTogetherBearAllDragAndAllWeight) {
  Tether tether = fathom();
  const SteadyWater water = [](double z) { return Triple<double>{0.6 - 0.01 * z, 0.2, 0.05}; };
  for (const double mass : {0.043, 0.3}) {
    tether.mass_per_m_kg = mass;
    const Triple<double> top{1, 2, 3}, vehicle{20, -8, 30};
    const SettledLine line = settled_line(tether, top, vehicle, 45, water);
    const Triple<double> left =
        line.pull.on_top_n + line.pull.on_vehicle_n - load_on(tether, line, top, vehicle, water);
    EXPECT_LT(length_of(left), 1e-9);
  }
}

/// cable_oracle.py beside this file: the continuous equations solved by scipy 1.10.1's solve_bvp to
/// 1e-9. A chain of 16 segments differs by 0.7 % of the greatest tension, one of 32 by 0.2 %, one
/// of 64 by 0.05 % (measured).
TEST(TetherAtRest, InShearedWaterPullsAsAnIndependentSolverSays) {
  Tether tether = fathom();
  tether.axial_stiffness_n = 5e6;
  {
    const SettledLine line = settled_line(tether, {0, 0, 0.2}, {0, 0, 50.2}, 55, [](double z) {
      return Triple<double>{0.5 - 0.006 * z, 0, 0};
    });
    const double tolerance = 0.005 * 20.875880;
    EXPECT_NEAR(line.pull.on_vehicle_n.x, 10.36544492, tolerance);
    EXPECT_NEAR(line.pull.on_vehicle_n.z, -18.12070384, tolerance);
    EXPECT_NEAR(line.pull.on_top_n.x, 14.50156825, tolerance);
    EXPECT_NEAR(line.pull.on_top_n.z, 12.57890988, tolerance);
    EXPECT_NEAR(line.state.node_m[7].x, 9.73947466, 0.1);
  }
  tether.mass_per_m_kg = 0.2;
  const SettledLine line = settled_line(tether, {0, 0, 0.5}, {15, 10, 40}, 55, [](double z) {
    return Triple<double>{0.8 - 0.01 * z, 0.1 + 0.004 * z, 0};
  });
  const double tolerance = 0.008 * 66.619344;
  const Triple<double> on_vehicle{4.65347989, 1.61348471, 4.88384195};
  const Triple<double> on_top{46.02933081, 12.02230576, 46.63584379};
  EXPECT_LT(length_of(line.pull.on_vehicle_n - on_vehicle), tolerance);
  EXPECT_LT(length_of(line.pull.on_top_n - on_top), tolerance);
  EXPECT_LT(length_of(line.state.node_m[7] - Triple<double>{16.54043732, 6.03021911, 21.52681383}),
            0.2);
}

TEST(TetherAtRest, SlackTakesTheTensionAway) {
  const Tether tether = fathom();
  double before = 1e9;
  for (const double length_m : {50.0, 50.5, 52.5, 55.0, 75.0, 100.0}) {
    const SettledLine line =
        settled_line(tether, {0, 0, 0.2}, {0, 0, 50.2}, length_m, uniform({0.5, 0, 0}));
    EXPECT_LT(line.pull.vehicle_tension_n, before) << length_m;
    EXPECT_NEAR(line.pull.slack_m, length_m - 50, 1e-12);
    EXPECT_EQ(line.pull.taut, length_m < 50.5 * 1.0001 ? 1 : 0) << length_m;
    before = line.pull.vehicle_tension_n;
  }
}

TEST(TetherAtRest, LinesThatCannotBeLaidAreRefused) {
  const Tether tether = fathom();
  const auto refusal = [&](double length_m, double depth_m) {
    try {
      (void)laid_out(tether, {}, {0, 0, depth_m}, length_m, {1, 0, 0});
    } catch (const Error& problem) {
      EXPECT_EQ(problem.kind(), ErrorKind::invalid_input);
      return problem.message();
    }
    return std::string();
  };
  EXPECT_NE(refusal(50, 60).find("pay out more"), std::string::npos);
  EXPECT_NE(refusal(200, 60).find("longest_m"), std::string::npos);
  EXPECT_NE(refusal(2, 1).find("resolved"), std::string::npos);
  EXPECT_EQ(refusal(50, 50.5), "");
  EXPECT_EQ(refusal(50, 0), "");
}

}  // namespace
}  // namespace slackwater::twin::tether_at_rest_test
