// The two surface craft in still water: afloat, standing up, rocking, under way.
#include <gtest/gtest.h>

#include "tests/support/surface_craft.h"

namespace slackwater::twin::surface_craft_test {
namespace {

using constants::gravity_m_s2;
using constants::pi;
using tests::afloat;
using tests::TwinHull;

struct Craft {
  const char* id;
  TwinHull form;
  double height_of_gravity_m;  ///< above the keel
};

/// The numbers of data/vehicles/*.yaml once more, by hand.
const Craft wamv{"wamv16", {4.9, 1.03, tests::of_circle(0.213, 0.10599)}, 0.220};
const Craft ctv{"ctv24", {23.5, 3.3, tests::of_wedge(57.1, 1.6993)}, 2.9};

Body undamped(const Craft& craft) {
  Body body = tests::body_of(craft.id);
  body.linear_damping = {};
  body.quadratic_damping = {};
  return body;
}

TEST(SurfaceCraft, FloatLevelAtTheirDraught) {
  for (const Craft& craft : {wamv, ctv}) {
    const Body body = tests::body_of(craft.id);
    EXPECT_NEAR(craft.form.weight_n() / gravity_m_s2, body.mass_kg, 1e-4 * body.mass_kg);
    BodyState<double> state = afloat(body);
    const double keel_m = body.hull.keel_m[0].z;
    EXPECT_NEAR(state.position_m.z + keel_m, craft.form.at_rest.draught_m, 1e-3) << craft.id;
    EXPECT_NEAR(state.position_m.z, 0, 1e-3) << "the origin is in the waterline";
    EXPECT_NEAR(keel_m - body.centre_of_gravity_m.z, craft.height_of_gravity_m, 1e-3);
    for (int i = 0; i < 2000; ++i) state = stepped(body, state, Forcing<double>{}, 0.05);
    const EulerAngles at = euler_angles(state.attitude);
    EXPECT_NEAR(at.roll_rad, 0, 1e-6);
    EXPECT_NEAR(at.pitch_rad, 0, 1e-6);
    EXPECT_NEAR(state.position_m.z + keel_m, craft.form.at_rest.draught_m, 1e-3);
  }
}

TEST(SurfaceCraft, TheCrewTransferVesselLightFloatsHigher) {
  const Body body = tests::body_of("ctv24");
  // 65 t of 90 in a V: the draught goes with the root of the displacement.
  EXPECT_NEAR(floating_depth_m(body.hull, 65000, body.fluid_density_kg_m3) + 1.7,
              ctv.form.at_rest.draught_m * std::sqrt(65.0 / 90.0), 2e-3);
}

/// Seconds of an oscillation about 0, from its passages upwards.
template <typename Quantity>
double period_s(const Body& body, BodyState<double> state, const Quantity& quantity) {
  constexpr double dt_s = 0.01;
  std::vector<double> passed;
  double before = quantity(state);
  for (int i = 0; passed.size() < 11 && i < 100000; ++i) {
    state = stepped(body, state, Forcing<double>{}, dt_s);
    const double now = quantity(state);
    if (before < 0 && now >= 0) passed.push_back(dt_s * (i + before / (before - now)));
    before = now;
  }
  return (passed.back() - passed.front()) / static_cast<double>(passed.size() - 1);
}

struct Periods {
  double heave_s;
  double roll_s;
  double pitch_s;
};

Periods simulated(const Body& body) {
  const BodyState<double> rest = afloat(body);
  BodyState<double> lifted = rest, heeled = rest, trimmed = rest;
  lifted.position_m.z += 0.005;
  heeled.attitude = attitude_of({0.005, 0, 0});
  trimmed.attitude = attitude_of({0, 0.002, 0});
  return {period_s(body, lifted,
                   [&](const BodyState<double>& s) { return s.position_m.z - rest.position_m.z; }),
          period_s(body, heeled,
                   [](const BodyState<double>& s) { return euler_angles(s.attitude).roll_rad; }),
          period_s(body, trimmed,
                   [](const BodyState<double>& s) { return euler_angles(s.attitude).pitch_rad; })};
}

/// 2 pi sqrt((I + A)/C); free to sway or surge, a craft turns about an axis that takes (m z_g)^2/(m
/// + A) off the inertia about its origin.
Periods textbook(const Craft& craft, const Body& body) {
  const auto& m = body.rigid_mass.entry;
  const auto& a = body.added_mass.entry;
  const auto period = [](double inertia, double stiffness) {
    return 2 * pi * std::sqrt(inertia / stiffness);
  };
  const double lever2 = std::pow(body.mass_kg * body.centre_of_gravity_m.z, 2);
  return {period(body.mass_kg + a[2][2], craft.form.heave_n_m()),
          period(m[3][3] + a[3][3] - lever2 / (body.mass_kg + a[1][1]),
                 craft.form.roll_n_m(craft.height_of_gravity_m)),
          period(m[4][4] + a[4][4] - lever2 / (body.mass_kg + a[0][0]),
                 craft.form.pitch_n_m(craft.height_of_gravity_m))};
}

TEST(SurfaceCraft, RockWithThePeriodsOfTheirHydrostatics) {
  for (const Craft& craft : {wamv, ctv}) {
    const Body body = undamped(craft);
    const Periods found = simulated(body);
    const Periods expected = textbook(craft, body);
    // 1 %: steps of the section's table, and that amplitudes are not nothing.
    EXPECT_NEAR(found.heave_s, expected.heave_s, 0.01 * expected.heave_s) << craft.id;
    EXPECT_NEAR(found.roll_s, expected.roll_s, 0.01 * expected.roll_s) << craft.id;
    EXPECT_NEAR(found.pitch_s, expected.pitch_s, 0.01 * expected.pitch_s) << craft.id;
    RecordProperty(std::string(craft.id) + "_heave_ms", static_cast<int>(1000 * found.heave_s));
    RecordProperty(std::string(craft.id) + "_roll_ms", static_cast<int>(1000 * found.roll_s));
    RecordProperty(std::string(craft.id) + "_pitch_ms", static_cast<int>(1000 * found.pitch_s));
  }
}

/// Successive crests of a damped oscillation are as exp(-2 pi zeta/sqrt(1 - zeta^2)).
TEST(SurfaceCraft, HeaveDiesAwayAsItsDampingSays) {
  for (const Craft& craft : {wamv, ctv}) {
    const Body body = tests::body_of(craft.id);
    const double mass = body.mass_kg + body.added_mass.entry[2][2];
    const double zeta =
        body.linear_damping.linear.z / (2 * std::sqrt(mass * craft.form.heave_n_m()));
    EXPECT_GT(zeta, 0.03);
    EXPECT_LT(zeta, 0.2);
    const double rest = afloat(body).position_m.z;
    BodyState<double> state = afloat(body);
    state.position_m.z += 0.01;
    const double omega = std::sqrt(craft.form.heave_n_m() / mass * (1 - zeta * zeta));
    const int steps = static_cast<int>(std::lround(2 * pi / omega / 0.005));
    for (int i = 0; i < steps; ++i) state = stepped(body, state, Forcing<double>{}, 0.005);
    EXPECT_NEAR((state.position_m.z - rest) / 0.01,
                std::exp(-2 * pi * zeta / std::sqrt(1 - zeta * zeta)), 0.02)
        << craft.id;
  }
}

/// The righting lever at a heel, the craft free to rise and fall, m.
double righting_lever_m(const Body& body, double heel_rad) {
  const Rotation<double> r = rotation_of(attitude_of({heel_rad, 0, 0}));
  const auto force_at_depth = [&](double z) {
    constexpr WaterAtStrips<double>* calm = nullptr;
    return floating_force<double>(body.hull, body.fluid_density_kg_m3, r, z, calm) +
           restoring(body, r, 1.0, 0.0, 0.0);
  };
  double high = -20, low = 20;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (high + low);
    (r.to_ned(force_at_depth(middle).linear).z > 0 ? high : low) = middle;
  }
  return -force_at_depth(0.5 * (high + low)).angular.x / (body.mass_kg * gravity_m_s2);
}

TEST(SurfaceCraft, RightThemselvesUntilTheLeeHullCarriesAllAndTheWeightIsOverIt) {
  for (const Craft& craft : {wamv, ctv}) {
    const Body body = tests::body_of(craft.id);
    double most = 0;
    double vanishes_deg = 0;
    for (int deg = 1; deg < 180 && vanishes_deg == 0; ++deg) {
      const double lever = righting_lever_m(body, deg * pi / 180);
      EXPECT_NEAR(lever, -righting_lever_m(body, -deg * pi / 180), 1e-6);
      most = std::max(most, lever);
      if (lever < 0) vanishes_deg = deg;
    }
    // Between half and all of the distance of a hull from the centreline: one hull out of the
    // water, little heel.
    EXPECT_GT(most, 0.5 * craft.form.half_spacing_m) << craft.id;
    EXPECT_LT(most, craft.form.half_spacing_m) << craft.id;
    RecordProperty(std::string(craft.id) + "_vanishes_deg", static_cast<int>(vanishes_deg));
    EXPECT_GT(vanishes_deg, 55) << craft.id;
    EXPECT_LT(vanishes_deg, 95) << craft.id;
    EXPECT_LT(righting_lever_m(body, 120 * pi / 180), 0) << "she stays capsized";
  }
  // The lee hull of the vessel with 90 t: 3.74 m2 under water, its centre 1.29 m below the centre
  // of gravity, whence atan(3.3/1.29) = 69 degrees.
  const Body body = tests::body_of("ctv24");
  EXPECT_GT(righting_lever_m(body, 66 * pi / 180), 0);
  EXPECT_LT(righting_lever_m(body, 72 * pi / 180), 0);
}

double speed_under(const Body& body, double thrust_n) {
  BodyState<double> state = afloat(body);
  Forcing<double> forcing;
  forcing.tau.linear.x = thrust_n;
  for (int i = 0; i < 6000; ++i) state = stepped(body, state, forcing, 0.05);
  return state.nu.linear.x;
}

/// The reference's 2.30 m/s at 250 N on each of two thrusters (twin/docs/vehicles.md).
TEST(SurfaceCraft, TheWamVMakesThePublishedSpeedAtItsFullThrust) {
  EXPECT_NEAR(speed_under(tests::body_of("wamv16"), 500), 2.30, 0.01);
}

/// Shaft power of the reference's curve, less 60 kW of idling, reaches the tow rope with 0.52 of
/// itself.
TEST(SurfaceCraft, TheCrewTransferVesselNeedsThePowerOfItsCurve) {
  const Body body = tests::body_of("ctv24");
  struct Point {
    double speed_kn, shaft_kw, within;
  };
  // 22 kn: halfway from 1350 kW at 20 kn to 1850 at 24.
  for (const Point& at : {Point{10, 320, 0.15}, Point{15, 800, 0.15}, Point{20, 1350, 0.10},
                          Point{22, 1600, 0.05}, Point{24, 1850, 0.05}, Point{26, 2050, 0.12}}) {
    const double u = at.speed_kn * 1852 / 3600.0;
    const double resistance_n = damping(body, rotation_of(afloat(body).attitude),
                                        Spatial<double>{{u, 0, 0}, {}}, Triple<double>{})
                                    .linear.x;
    EXPECT_NEAR(60 + 1e-3 * resistance_n * u / 0.52, at.shaft_kw, at.within * at.shaft_kw)
        << at.speed_kn << " kn";
    if (at.speed_kn == 22) {
      EXPECT_NEAR(speed_under(body, resistance_n), u, 1e-3);
    }
  }
}

/// Rate of turn a minute after a push at the bow, under way at a speed.
double rate_of_turn_later(const Body& body, double speed_m_s) {
  BodyState<double> state = afloat(body);
  state.nu.linear.x = speed_m_s;
  state.nu.angular.z = 0.01;
  Forcing<double> forcing;
  forcing.tau.linear.x = damping(body, rotation_of(state.attitude),
                                 Spatial<double>{{speed_m_s, 0, 0}, {}}, Triple<double>{})
                             .linear.x;
  for (int i = 0; i < 1200; ++i) state = stepped(body, state, forcing, 0.05);
  return std::abs(state.nu.angular.z);
}

TEST(SurfaceCraft, KeepTheirCourseWhichWithoutLiftAtTheirSternTheyWouldNot) {
  Body vessel = tests::body_of("ctv24");
  const double service_m_s = 22 * 1852 / 3600.0;
  EXPECT_LT(rate_of_turn_later(vessel, service_m_s), 1e-4);
  EXPECT_LT(rate_of_turn_later(tests::body_of("wamv16"), 2), 1e-4);
  vessel.trailing_edge_kg_m = 0;
  EXPECT_GT(rate_of_turn_later(vessel, service_m_s), 0.02);
}

}  // namespace
}  // namespace slackwater::twin::surface_craft_test
