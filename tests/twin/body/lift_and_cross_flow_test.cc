#include "twin/body/lift_and_cross_flow.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/body_for_tests.h"
#include "twin/body/body_dynamics.h"

namespace slackwater::twin::lift_and_cross_flow_test {
namespace {

using tests::at_rest;
using tests::body_of;
using tests::MadeUpHull;
using tests::random_triple;

std::array<double, 6> numbers_of(const Spatial<double>& a) {
  return {a.linear.x, a.linear.y, a.linear.z, a.angular.x, a.angular.y, a.angular.z};
}
double power_w(const Spatial<double>& force, const Spatial<double>& nu) {
  return dot(force.linear, nu.linear) + dot(force.angular, nu.angular);
}
SpatialMatrix any_symmetric(Rng& random) {
  SpatialMatrix m;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j <= i; ++j) m.entry[i][j] = m.entry[j][i] = random.normal();
  return m;
}

TEST(SpeedLift, OfEachDerivativeIsOneForceByOneMotion) {
  struct Term {
    double SpeedLift::*derivative;
    std::size_t force;
    std::size_t motion;
  };
  const Term terms[] = {
      {&SpeedLift::y_uv, 1, 1}, {&SpeedLift::y_ur, 1, 5}, {&SpeedLift::n_uv, 5, 1},
      {&SpeedLift::n_ur, 5, 5}, {&SpeedLift::z_uw, 2, 2}, {&SpeedLift::z_uq, 2, 4},
      {&SpeedLift::m_uw, 4, 2}, {&SpeedLift::m_uq, 4, 4}, {&SpeedLift::k_up, 3, 3}};
  for (const double ahead_m_s : {2.0, -2.0}) {
    const Spatial<double> nu{{ahead_m_s, 0.3, 0.5}, {0.7, 1.1, 1.3}};
    for (const Term& term : terms) {
      SpeedLift lift;
      lift.*term.derivative = -3;
      std::array<double, 6> expected{};
      expected[term.force] = -3 * 2 * numbers_of(nu)[term.motion];
      const std::array<double, 6> found = numbers_of(lift_with_speed(lift, nu));
      for (std::size_t i = 0; i < 6; ++i)
        EXPECT_NEAR(found[i], expected[i], 1e-14) << term.force << term.motion << " in " << i;
    }
  }
}

/// CA(5,1..3), CA(1..3,5), CA(6,1..2) and CA(1..2,6) of Fossen's Coriolis matrix are noughts in his
/// model of a REMUS 100: what is left turns with p alone or by the angular momentum.
TEST(MunkTakenOff, LeavesNoForceOfPitchAndYawAndDoesNoWork) {
  Rng random(1, "tests/munk");
  for (int i = 0; i < 200; ++i) {
    const SpatialMatrix mass = any_symmetric(random);
    Spatial<double> nu{random_triple(random), random_triple(random)};
    EXPECT_NEAR(power_w(munk_taken_off(mass, nu), nu), 0, 1e-12);
    nu.angular.x = 0;
    const Spatial<double> left = munk_taken_off(mass, nu) - coriolis(mass, nu);
    const Triple<double> h = (mass * nu).angular;
    const double scale = 1e-12;
    EXPECT_NEAR(left.linear.x, 0, scale);
    EXPECT_NEAR(left.linear.y, 0, scale);
    EXPECT_NEAR(left.linear.z, 0, scale);
    EXPECT_NEAR(left.angular.y, -nu.angular.z * h.x, scale);
    EXPECT_NEAR(left.angular.z, nu.angular.y * h.x, scale);
  }
}

/// A hull from -1 to 1 m with the same drag all along, rho/2 C_d T = 100 in sway and 60 in heave.
CrossFlow even_flow(std::size_t strips) {
  CrossFlow flow;
  flow.is_there = true;
  flow.strips = strips;
  for (std::size_t i = 0; i < strips; ++i) {
    const double length = 2.0 / static_cast<double>(strips);
    flow.x_m[i] = -1 + length * (static_cast<double>(i) + 0.5);
    flow.sway_n_s2_m2[i] = 100 * length;
    flow.heave_n_s2_m2[i] = 60 * length;
  }
  return flow;
}
Spatial<double> level_drag(const CrossFlow& flow, const Spatial<double>& nu) {
  return drag_of_cross_flow(flow, rotation_of(at_rest().attitude), nu, {});
}

/// With c = v + x r from c_0 at the stern to c_1 at the bow,
///   int c |c| dx = [|c|^3]/(3 r),  int x c |c| dx = [c |c|^3/4 - v |c|^3/3]/r^2.
struct ExactDrag {
  double force = 0;
  double moment = 0;
};
ExactDrag exact_drag(double v, double r) {
  const auto cubed = [](double c) { return std::pow(std::abs(c), 3); };
  const double stern = v - r, bow = v + r;
  const auto moment = [&](double c) { return c * cubed(c) / 4 - v * cubed(c) / 3; };
  return {(cubed(bow) - cubed(stern)) / (3 * r), (moment(bow) - moment(stern)) / (r * r)};
}

TEST(CrossFlow, IsTheIntegralOverTheHullToSecondOrder) {
  for (const auto& [v, r] : {std::pair{0.3, 0.8}, {0.9, 0.4}, {-0.2, 1.1}, {0.0, 0.7}}) {
    const ExactDrag exact = exact_drag(v, r);
    const auto error = [&, v = v, r = r](std::size_t strips) {
      const Spatial<double> found = level_drag(even_flow(strips), {{1.5, v, 0}, {0.4, 0, r}});
      EXPECT_EQ(found.linear.x, 0);
      EXPECT_EQ(found.angular.x, 0);
      return std::hypot(found.linear.y + 100 * exact.force, found.angular.z + 100 * exact.moment);
    };
    EXPECT_LT(error(20), 100 * 0.01 * std::hypot(exact.force, exact.moment)) << v << ' ' << r;
    EXPECT_NEAR(std::log2(error(5) / error(20)) / 2, 2, 0.3) << v << ' ' << r;
  }
  // N(r) = -rho/2 C_d T L^4/32 r |r|.
  EXPECT_NEAR(exact_drag(0, 0.7).moment, 16.0 / 32 * 0.7 * 0.7, 1e-12);
}

TEST(CrossFlow, InHeaveIsThatInSwayOfAHullOnItsSide) {
  const CrossFlow flow = even_flow(12);
  // w for v, and q for -r: a bow that goes up meets the water from above.
  const Spatial<double> sway = level_drag(flow, {{0, 0.3, 0}, {0, 0, 0.8}});
  const Spatial<double> heave = level_drag(flow, {{0, 0, 0.3}, {0, -0.8, 0}});
  EXPECT_NEAR(heave.linear.z, 0.6 * sway.linear.y, 1e-12);
  EXPECT_NEAR(heave.angular.y, -0.6 * sway.angular.z, 1e-12);
  EXPECT_LT(sway.angular.z, 0);
}

TEST(CrossFlow, MirrorsAndOfOneStripIsTheDerivativeOfTables) {
  const CrossFlow flow = even_flow(7);
  const Spatial<double> nu{{1, 0.3, -0.2}, {0, 0.5, 0.8}};
  const Spatial<double> mirrored{{1, -0.3, 0.2}, {0, -0.5, -0.8}};
  const std::array<double, 6> a = numbers_of(level_drag(flow, nu));
  const std::array<double, 6> b = numbers_of(level_drag(flow, mirrored));
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(a[i], -b[i]);
  MadeUpHull hull;
  hull.quadratic = {0, 200, 120, 0, 0, 0};
  const Spatial<double> published =
      damping(body_of(hull), rotation_of(at_rest().attitude), nu, Triple<double>{});
  const Spatial<double> one = level_drag(even_flow(1), nu);
  EXPECT_NEAR(one.linear.y, -published.linear.y, 1e-12);
  EXPECT_NEAR(one.linear.z, -published.linear.z, 1e-12);
}

TEST(CrossFlow, AlwaysSlows) {
  Rng random(2, "tests/cross_flow");
  for (int i = 0; i < 1000; ++i) {
    const Spatial<double> nu{random_triple(random), random_triple(random)};
    EXPECT_LT(power_w(level_drag(even_flow(9), nu), nu), 0);
  }
}

TEST(CrossFlow, MeetsEachStripInTheWaterOfItsDepth) {
  const CrossFlow flow = even_flow(10);
  // Bow down upright: x goes straight down, so that a strip is x deeper.
  const Rotation<double> r = rotation_of(attitude_of({0, -constants::pi / 2, 0}));
  const Triple<double> shear{0, 0.2, 0};  // the east-going current grows with depth
  const Spatial<double> found = drag_of_cross_flow(flow, r, {{}, {}}, shear);
  // As of a hull at rest in shear: aside = -0.2 x, that is r = -0.2.
  const Spatial<double> turning = level_drag(flow, {{}, {0, 0, -0.2}});
  EXPECT_NEAR(found.linear.y, 0, 1e-12);
  EXPECT_NEAR(found.angular.z, turning.angular.z, 1e-12);
  EXPECT_GT(found.angular.z, 0.5);
}

TEST(ResistanceAlongAxes, IsWhatPureMotionsMeet) {
  MadeUpHull hull;
  hull.quadratic = {40, 0, 0, 1, 2, 3};
  Body body = body_of(hull);
  EXPECT_EQ(numbers_of(resistance_along_axes(body)), numbers_of(body.quadratic_damping));
  body.cross_flow = even_flow(8);
  const Rotation<double> r = rotation_of(at_rest().attitude);
  const std::array<double, 6> found = numbers_of(resistance_along_axes(body));
  for (std::size_t i = 0; i < 6; ++i) {
    std::array<double, 6> way{};
    way[i] = 0.7;
    const Spatial<double> nu{{way[0], way[1], way[2]}, {way[3], way[4], way[5]}};
    const Spatial<double> all = damping(body, r, nu, {}) - lift_and_cross_flow(body, r, nu, {});
    EXPECT_NEAR(found[i] * 0.49, numbers_of(all)[i], 1e-11) << i;
  }
}

TEST(LiftAndCrossFlow, JoinTheEquationsOfMotionWithTheVelocityThroughTheWater) {
  MadeUpHull hull;
  const Body without = body_of(hull);
  EXPECT_FALSE(without.has_more());
  Body lift = without, flow = without, cross = without;
  lift.speed_lift.is_there = true;
  lift.speed_lift.m_uw = -4;
  flow.cross_flow = even_flow(6);
  cross.cross_damping.is_there = true;
  cross.cross_damping.linear.entry[1][5] = 7;
  cross.cross_damping.m_w = -2;
  BodyState<double> state = at_rest();
  state.attitude = attitude_of({0.2, -0.1, 1});
  state.nu = {{1.5, 0.2, -0.3}, {0.1, 0.2, 0.3}};
  Forcing<double> forcing;
  forcing.fluid.velocity_m_s = {0.4, -0.3, 0.1};
  const Rotation<double> r = rotation_of(state.attitude);
  Spatial<double> nu_r = state.nu;
  nu_r.linear = nu_r.linear - r.to_body(forcing.fluid.velocity_m_s);
  for (const Body& body : {lift, flow, cross}) {
    EXPECT_TRUE(body.has_more());
    const Spatial<double> force = lift_and_cross_flow(body, r, nu_r, {});
    EXPECT_GT(dot(force.angular, force.angular), 0.01);
    const Spatial<double> more =
        acceleration(body, state, forcing) - acceleration(without, state, forcing);
    const std::array<double, 6> found = numbers_of(more);
    const std::array<double, 6> expected = numbers_of(without.inverse_mass * force);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(found[i], expected[i], 1e-12);
  }
}

}  // namespace
}  // namespace slackwater::twin::lift_and_cross_flow_test
