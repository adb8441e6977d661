#include "twin/body/body_dynamics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "tests/support/body_for_tests.h"

namespace slackwater::twin::body_dynamics_test {
namespace {

using constants::gravity_m_s2;
using constants::pi;
using tests::at_rest;
using tests::body_of;
using tests::MadeUpHull;
using tests::random_triple;
using State = BodyState<double>;

State tumbling(std::uint64_t seed) {
  Rng random(seed, "tests/tumbling");
  State state = at_rest();
  state.attitude = normalised(
      Attitude<double>{random.normal(), random.normal(), random.normal(), random.normal()});
  state.nu = {random_triple(random, 0.5), random_triple(random, 0.8)};
  return state;
}

State run(const Body& body, State state, const Forcing<double>& forcing, double seconds,
          double dt_s) {
  const auto steps = static_cast<int>(std::lround(seconds / dt_s));
  for (int i = 0; i < steps; ++i) state = stepped(body, state, forcing, dt_s);
  return state;
}

double distance(const State& a, const State& b) {
  const Triple<double> x = a.position_m - b.position_m, v = a.nu.linear - b.nu.linear,
                       w = a.nu.angular - b.nu.angular;
  return std::sqrt(dot(x, x) + dot(v, v) + dot(w, w));
}

TEST(BodyDynamics, WithoutForcesTheKineticEnergyAndTheMomentumStay) {
  MadeUpHull hull;
  hull.centre_of_gravity_m = {0.05, -0.02, 0.03};
  hull.centre_of_buoyancy_m = hull.centre_of_gravity_m;
  const Body body = body_of(hull);
  const SpatialMatrix mass = sum_of(body.rigid_mass, body.added_mass);
  const State start = tumbling(1);
  const State end = run(body, start, {}, 60, 0.005);
  EXPECT_NEAR(kinetic_energy_j(mass, end.nu) / kinetic_energy_j(mass, start.nu), 1, 1e-9);
  const auto momentum = [&](const State& s) {
    return rotation_of(s.attitude).to_ned((mass * s.nu).linear);
  };
  const Triple<double> change = momentum(end) - momentum(start);
  EXPECT_LT(std::sqrt(dot(change, change)), 1e-7);
}

TEST(BodyDynamics, WhateverTheAddedMassTheKineticEnergyAndTheMomentumStay) {
  Rng random(6, "tests/added_mass");
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Body body = body_of({});
    // A sum of squares: any mass that no motion gains energy from.
    for (int n = 0; n < 6; ++n) {
      std::array<double, 6> a{};
      for (double& number : a) number = random.normal();
      for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) body.added_mass.entry[i][j] += a[i] * a[j];
    }
    const SpatialMatrix mass = sum_of(body.rigid_mass, body.added_mass);
    body.inverse_mass = inverse_of(mass).value();
    const State start = tumbling(100 + seed);
    const State end = run(body, start, {}, 3, 0.005);
    EXPECT_NEAR(kinetic_energy_j(mass, end.nu) / kinetic_energy_j(mass, start.nu), 1, 1e-8);
    const auto momentum = [&](const State& s) {
      return rotation_of(s.attitude).to_ned((mass * s.nu).linear);
    };
    const Triple<double> change = momentum(end) - momentum(start);
    EXPECT_LT(std::sqrt(dot(change, change)), 1e-6) << seed;
  }
}

TEST(BodyDynamics, ASteadyCurrentCarriesTheWholeMotionAlong) {
  MadeUpHull hull;
  hull.linear = {4, 6, 5, 0.1, 0.2, 0.1};
  hull.quadratic = {40, 70, 60, 1, 1, 1};
  hull.centre_of_buoyancy_m = {0, 0, -0.02};
  const Body body = body_of(hull);
  const State still = tumbling(2);
  Forcing<double> forcing;
  forcing.tau = {{3, 1, -2}, {0.1, 0.2, -0.1}};
  Forcing<double> in_current = forcing;
  in_current.fluid.velocity_m_s = {0.4, -0.7, 0};
  State carried = still;
  carried.nu.linear = carried.nu.linear + rotation_of(still.attitude).to_body({0.4, -0.7, 0});
  constexpr double seconds = 20;
  const State a = run(body, still, forcing, seconds, 0.01);
  State b = run(body, carried, in_current, seconds, 0.01);
  b.position_m = b.position_m - Triple<double>{0.4 * seconds, -0.7 * seconds, 0};
  b.nu.linear = b.nu.linear - rotation_of(b.attitude).to_body({0.4, -0.7, 0});
  EXPECT_LT(distance(a, b), 1e-6);
}

/// m' v_r' = -d v_r |v_r|: v_r = v_0/(1 + v_0 d t/m'), and the lag behind the water ln(1 + v_0 d
/// t/m') m'/d.
TEST(BodyDynamics, ABodyAtRestIsCarriedOffByACurrentAsTheClosedFormSays) {
  MadeUpHull hull;
  hull.quadratic = {46.2, 71.1, 62.3, 0, 0, 0};
  const Body body = body_of(hull);
  Forcing<double> forcing;
  constexpr double current = 0.5;
  forcing.fluid.velocity_m_s = {current, 0, 0};
  const double mass = hull.mass_kg + hull.added[0];
  for (const double t : {1.0, 5.0, 30.0, 120.0}) {
    const State s = run(body, at_rest(), forcing, t, 0.02);
    const double grown = 1 + current * hull.quadratic[0] * t / mass;
    EXPECT_NEAR(s.nu.linear.x, current - current / grown, 1e-8) << t << " s";
    EXPECT_NEAR(s.position_m.x, current * t - std::log(grown) * mass / hull.quadratic[0], 1e-6)
        << t << " s";
  }
}

TEST(BodyDynamics, AConstantThrustEndsAtTheSpeedWhereDragBalancesIt) {
  MadeUpHull hull;
  hull.added = {6, 6, 6, 0.2, 0.3, 0.25};  // else an undamped hull turns across the flow
  hull.linear[0] = 4.03;
  hull.quadratic[0] = 46.2;
  Forcing<double> forcing;
  forcing.tau.linear.x = 50;
  const double expected =
      (-hull.linear[0] + std::sqrt(hull.linear[0] * hull.linear[0] + 4 * hull.quadratic[0] * 50)) /
      (2 * hull.quadratic[0]);
  EXPECT_NEAR(run(body_of(hull), at_rest(), forcing, 60, 0.02).nu.linear.x, expected, 1e-10);
}

TEST(BodyDynamics, ABuoyantBodyRisesAtTheSpeedWhereDragBalancesItsBuoyancy) {
  MadeUpHull hull;
  hull.displaced_mass_kg = 13.235;
  hull.quadratic = {40, 60, 62.3, 1, 1, 1};
  const State s = run(body_of(hull), at_rest(), {}, 40, 0.02);
  EXPECT_NEAR(s.nu.linear.z, -std::sqrt(0.235 * gravity_m_s2 / 62.3), 1e-9);
}

/// Amplitude and phase of the velocity over one period, when the start has died away.
std::complex<double> response(const Body& body, const Triple<double>& along, double omega) {
  constexpr double amplitude = 0.4;
  constexpr double dt_s = 0.01;
  const auto steps = static_cast<int>(std::lround(2 * pi / omega / dt_s));
  State state = at_rest();
  std::complex<double> sum = 0;
  // From rest at the turn of the tide of velocities: what moves with gain 1 has no offset.
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) * dt_s;
    Forcing<double> forcing;
    forcing.tau.linear.z =
        gravity_m_s2 * (body.fluid_density_kg_m3 * body.displaced_volume_m3 - body.mass_kg);
    forcing.fluid.velocity_m_s = amplitude * std::sin(omega * t) * along;
    forcing.fluid.acceleration_m_s2 = amplitude * omega * std::cos(omega * t) * along;
    const State next = stepped(body, state, forcing, dt_s);
    const double velocity = 0.5 * dot(along, state.nu.linear + next.nu.linear);
    sum += velocity * std::polar(1.0, -(omega * t - pi / 2));
    state = next;
  }
  return sum * 2.0 / (amplitude * steps);
}

/// Gain (rho V + A)/(m + A), phase 0: what the water in its place would do, but for its inertia.
TEST(BodyDynamics, AnUndampedBodyFollowsAnOscillatingFlowByTheRatioOfInertias) {
  MadeUpHull blue;  // BlueROV2's surge: 13.4 l, 13.5 kg, added mass 6.36 kg
  blue.mass_kg = 13.5;
  blue.displaced_mass_kg = 1025 * 0.0134;
  blue.added = {6.3567, 7.1206, 18.6863, 0.1858, 0.1348, 0.2215};
  blue.linear = {0, 0, 0, 10, 10, 10};  // held in attitude, free to move
  MadeUpHull heavy = blue;
  heavy.mass_kg = 20;
  const double omega = 2 * pi / 10;
  const std::complex<double> surge = response(body_of(blue), {1, 0, 0}, omega);
  EXPECT_NEAR(surge.real(), (13.735 + 6.3567) / (13.5 + 6.3567), 1e-3);
  EXPECT_NEAR(surge.real(), 1.012, 1e-3);
  EXPECT_NEAR(std::arg(surge), 0, 1e-3);
  const std::complex<double> sway = response(body_of(heavy), {0, 1, 0}, omega);
  EXPECT_NEAR(sway.real(), (13.735 + heavy.added[1]) / (20 + heavy.added[1]), 1e-3);
  EXPECT_NEAR(std::arg(sway), 0, 1e-3);
}

TEST(BodyDynamics, ANeutralBodyMovesWithWaterThatTurnsAndAcceleratesWhateverItsAttitude) {
  MadeUpHull hull;
  Body body = body_of(hull);
  body.rigid_mass = rigid_mass_matrix(13, {0.26, 0.23, 0.37}, {});
  State state = tumbling(3);
  const auto water = [](double t) {
    return Triple<double>{0.5 * std::cos(0.6 * t), 0.5 * std::sin(0.6 * t), 0.1 * t};
  };
  state.nu = {rotation_of(state.attitude).to_body(water(0)), {}};
  constexpr double dt_s = 0.01;
  for (int i = 0; i < 1000; ++i) {
    const double t = (i + 0.5) * dt_s;
    Forcing<double> forcing;
    forcing.fluid.velocity_m_s = water(t);
    forcing.fluid.acceleration_m_s2 = {-0.3 * std::sin(0.6 * t), 0.3 * std::cos(0.6 * t), 0.1};
    state = stepped(body, state, forcing, dt_s);
  }
  const Triple<double> left =
      rotation_of(state.attitude).to_ned(state.nu.linear) - water(1000 * dt_s);
  EXPECT_LT(std::sqrt(dot(left, left)), 1e-4);
  EXPECT_LT(std::sqrt(dot(state.nu.angular, state.nu.angular)), 1e-4);
}

TEST(BodyDynamics, ASmallRollSwingsWithThePeriodOfItsPendulum) {
  MadeUpHull hull;
  hull.centre_of_buoyancy_m = {0, 0, -0.02};
  Body body = body_of(hull);
  body.rigid_mass = rigid_mass_matrix(13, {0.26, 0.23, 0.37}, {});
  body.inverse_mass = inverse_of(sum_of(body.rigid_mass, body.added_mass)).value();
  const double omega = std::sqrt(0.02 * 13 * gravity_m_s2 / (0.26 + hull.added[3]));
  State state = at_rest();
  state.attitude = attitude_of({0.001, 0, 0});
  state = run(body, state, {}, 2 * pi / omega, 2 * pi / omega / 2000);
  EXPECT_NEAR(euler_angles(state.attitude).roll_rad, 0.001, 1e-9);
  state = run(body, state, {}, pi / omega, pi / omega / 1000);
  EXPECT_NEAR(euler_angles(state.attitude).roll_rad, -0.001, 1e-9);
}

TEST(BodyDynamics, TheRestoringMomentIsFossensForEveryAttitude) {
  MadeUpHull hull;
  hull.centre_of_buoyancy_m = {0, 0, -0.049};
  const Body body = body_of(hull);
  Rng random(4, "tests/restoring");
  for (int i = 0; i < 100; ++i) {
    const EulerAngles a{random.uniform(-pi, pi), random.uniform(-1.5, 1.5), 0.3};
    const Spatial<double> g = restoring(body, rotation_of(attitude_of(a)), 1.0, 0.0, 0.0);
    const double lever = 0.049 * 13 * gravity_m_s2;
    EXPECT_NEAR(g.angular.x, -lever * std::cos(a.pitch_rad) * std::sin(a.roll_rad), 1e-12);
    EXPECT_NEAR(g.angular.y, -lever * std::sin(a.pitch_rad), 1e-12);
    EXPECT_NEAR(g.angular.z, 0, 1e-12);
    EXPECT_NEAR(dot(g.linear, g.linear), 0, 1e-20);
  }
}

TEST(BodyDynamics, TheStepIsOfFourthOrder) {
  MadeUpHull hull;
  hull.linear = {4, 6, 5, 0.1, 0.2, 0.1};
  hull.centre_of_buoyancy_m = {0.01, 0, -0.05};
  const Body body = body_of(hull);
  Forcing<double> forcing;
  forcing.tau = {{5, 2, -3}, {0.2, -0.1, 0.3}};
  forcing.fluid.velocity_m_s = {0.3, 0.2, 0};
  const State start = tumbling(5);
  const State exact = run(body, start, forcing, 4, 0.0005);
  const double coarse = distance(run(body, start, forcing, 4, 0.04), exact);
  const double fine = distance(run(body, start, forcing, 4, 0.02), exact);
  EXPECT_NEAR(std::log2(coarse / fine), 4, 0.3);
}

TEST(BodyDynamics, ShearOverAnUprightHullTurnsItAndStationsAddUpWithoutIt) {
  MadeUpHull hull;
  hull.quadratic = {40, 70, 60, 1, 1, 1};
  Body one = body_of(hull);
  Body two = one;
  two.stations = 2;
  two.station_m[0] = {0, 0, -0.5};
  two.station_m[1] = {0, 0, 0.5};
  const Rotation<double> level = rotation_of(at_rest().attitude);
  const Spatial<double> nu_r{{-0.3, 0.1, 0.05}, {0.1, 0, -0.2}};
  const Spatial<double> a = damping(one, level, nu_r, Triple<double>{});
  const Spatial<double> b = damping(two, level, nu_r, Triple<double>{});
  EXPECT_NEAR(a.linear.x, b.linear.x, 1e-14);
  EXPECT_NEAR(a.angular.y, b.angular.y, 1e-14);
  // The water flows north, 0.3 m/s at the middle, 0.1 m/s per metre slower below.
  const Spatial<double> c = damping(two, level, {{-0.3, 0, 0}, {}}, {-0.1, 0, 0});
  const double upper = 20 * 0.35 * 0.35, lower = 20 * 0.25 * 0.25;
  EXPECT_NEAR(c.linear.x, -(upper + lower), 1e-12);
  // Drag here opposes motion: the moment is minus that of forces pushing the upper half harder to
  // the north.
  EXPECT_NEAR(c.angular.y, -0.5 * (lower - upper), 1e-12);
}

/// Slender-body theory: of the Munk moment (Y_v_dot - X_u_dot) u v of a slender hull a stern as
/// full as the rest takes half.
TEST(BodyDynamics, TheLiftOfAHullTakesHalfOfTheMomentOfItsAddedMass) {
  MadeUpHull hull;
  hull.added = {0, 8, 0, 0, 0, 1};
  Body body = body_of(hull);
  constexpr double length = 2;
  body.trailing_edge_x_m = -length / 2;
  body.trailing_edge_kg_m = 8 / length;
  const Spatial<double> adrift{{3, 0.2, 0}, {}};
  const double munk = -coriolis(body.added_mass, adrift).angular.z;
  EXPECT_NEAR(munk, -8 * 3 * 0.2, 1e-12);
  EXPECT_NEAR(lift_of_hull(body, adrift).angular.z, -0.5 * munk, 1e-12);
  // Astern, the other end trails: the moment of the added mass has turned, and so has this.
  const Spatial<double> astern{{-3, 0.2, 0}, {}};
  EXPECT_NEAR(lift_of_hull(body, astern).angular.z,
              0.5 * coriolis(body.added_mass, astern).angular.z, 1e-12);
  Rng random(9, "tests/lift");
  for (int i = 0; i < 100; ++i) {
    const Spatial<double> nu{random_triple(random), random_triple(random)};
    const Spatial<double> lift = lift_of_hull(body, nu);
    EXPECT_LE(dot(lift.linear, nu.linear) + dot(lift.angular, nu.angular), 0);
  }
}

}  // namespace
}  // namespace slackwater::twin::body_dynamics_test
