#include "twin/body/floating_hull.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "twin/body/body_dynamics.h"
#include "twin/body/mass_matrix.h"

namespace slackwater::twin::floating_hull_test {
namespace {

using constants::gravity_m_s2;
using constants::pi;
using constants::sea_water_density_kg_m3;

FloatingHull hull_of(const std::string& section, const std::string& sides = "[0]", int strips = 8) {
  const Config config = Config::parse(
      "hulls: {" + section + ", from_x_m: -4, to_x_m: 4, keel_z_m: 0.5, centre_y_m: " + sides +
          ", strips: " + std::to_string(strips) + "}",
      "hull.yaml");
  FloatingHull hull = read_floating_hull(config);
  config.expect_all_read();
  return hull;
}

/// A barge of 8 m x 2 m that floats on 0.4 m, its centre of gravity at the waterline.
Body barge(double added_heave_kg = 0) {
  Body body;
  body.hull = hull_of("beam_m: 2, depth_m: 1");
  body.fluid_density_kg_m3 = sea_water_density_kg_m3;
  body.height_m = 1;
  body.mass_kg = sea_water_density_kg_m3 * 8 * 2 * 0.4;
  body.centre_of_gravity_m = {0, 0, 0.1};
  body.rigid_mass = rigid_mass_matrix(body.mass_kg, {3000, 40000, 42000}, body.centre_of_gravity_m);
  body.added_mass.entry[2][2] = added_heave_kg;
  body.inverse_mass = inverse_of(sum_of(body.rigid_mass, body.added_mass)).value();
  return body;
}

TEST(FloatingHulls, FloatAtTheDepthWhereTheyDisplaceTheirWeight) {
  const Body body = barge();
  // Keel 0.5 m below the origin, 0.4 m under water: the origin 0.1 m above it.
  EXPECT_NEAR(floating_depth_m(body.hull, body.mass_kg, sea_water_density_kg_m3), -0.1, 1e-9);
  EXPECT_THROW((void)floating_depth_m(body.hull, 17000, sea_water_density_kg_m3), Error);
}

TEST(FloatingHulls, ACylinderHalfUnderDisplacesHalfOfItself) {
  const FloatingHull hull = hull_of("radius_m: 0.213", "[-1.03, 1.03]", 5);
  EXPECT_EQ(hull.strips, 10U);
  const double half = sea_water_density_kg_m3 * 2 * 8 * 0.5 * pi * 0.213 * 0.213;
  // The centre of half a circle is 4 r/(3 pi) from its diameter.
  EXPECT_NEAR(floating_depth_m(hull, half, sea_water_density_kg_m3), 0.213 - 0.5, 1e-4);
  const std::size_t middle = section_points / 2;
  EXPECT_NEAR(hull.part[0].section[middle].moment_m3 / hull.part[0].section[middle].area_m2,
              0.213 - 4 * 0.213 / (3 * pi), 1e-4);
  EXPECT_NEAR(hull.part[0].section[middle].breadth_m, 2 * 0.213, 1e-12);
  EXPECT_NEAR(hull.part[0].section.back().area_m2, pi * 0.213 * 0.213,
              1e-4 * hull.part[0].section.back().area_m2);
}

TEST(FloatingHulls, AVBottomIsHalfATriangleUpToItsChine) {
  const FloatingHull hull = hull_of("beam_m: 2, depth_m: 1.6, deadrise_deg: 45");
  // Chine at 1 m: area h^2 below it.
  EXPECT_NEAR(hull.part[0].section[20].area_m2, std::pow(1.6 * 20 / 64, 2), 1e-5);
  EXPECT_THROW((void)hull_of("beam_m: 2, depth_m: 0.6, deadrise_deg: 45"), Error);
  EXPECT_THROW((void)hull_of("beam_m: 2, depth_m: 1", "[-1, 1]", 9), Error);
}

/// Of an Otter (Fossen 2021): 0.1875 m at the waterline and 0.01951 m2 under it on a draught of
/// 0.1951 m.
TEST(FloatingHulls, AVBottomMayBeSteepButNoWall) {
  const FloatingHull hull = hull_of("beam_m: 0.1875, depth_m: 0.35, deadrise_deg: 62.7");
  const Section section = section_at(hull.part[0], 0.1951);
  EXPECT_NEAR(section.area_m2, 0.01951, 5e-5);  // by a tenth of a degree
  EXPECT_NEAR(section.breadth_m, 0.1875, 1e-12);
  EXPECT_THROW((void)hull_of("beam_m: 0.05, depth_m: 1, deadrise_deg: 86"), Error);
}

BodyState<double> afloat(const Body& body) {
  BodyState<double> state;
  state.attitude.w = 1;
  state.position_m.z = floating_depth_m(body.hull, body.mass_kg, sea_water_density_kg_m3);
  return state;
}

BodyState<double> run(const Body& body, BodyState<double> state, double seconds) {
  constexpr int steps = 2000;
  for (int i = 0; i < steps; ++i) state = stepped(body, state, Forcing<double>{}, seconds / steps);
  return state;
}

TEST(FloatingHulls, HeaveWithThePeriodOfTheirWaterplane) {
  const Body body = barge(5000);
  const double omega =
      std::sqrt(sea_water_density_kg_m3 * gravity_m_s2 * 8 * 2 / (body.mass_kg + 5000));
  BodyState<double> state = afloat(body);
  const double rest = state.position_m.z;
  state.position_m.z += 0.01;
  EXPECT_NEAR(run(body, state, 2 * pi / omega).position_m.z - rest, 0.01, 1e-6);
  EXPECT_NEAR(run(body, state, pi / omega).position_m.z - rest, -0.01, 1e-6);
}

/// -d moment/d angle of a small heel or trim, N m/rad.
double stiffness(const Body& body, const EulerAngles& small) {
  const double down = floating_depth_m(body.hull, body.mass_kg, sea_water_density_kg_m3);
  const Rotation<double> r = rotation_of(attitude_of(small));
  const Spatial<double> force =
      floating_force<double>(body.hull, sea_water_density_kg_m3, r, down, nullptr) +
      restoring(body, r, 1.0, 0.0, 0.0);
  return small.roll_rad > 0 ? -force.angular.x / small.roll_rad
                            : -force.angular.y / small.pitch_rad;
}

/// W GM with GM = KB + I/V - KG, I the second moment of the waterplane: hulls beside each other,
/// and each for itself.
TEST(FloatingHulls, StandUpByTheirMetacentricHeight) {
  Body body = barge();
  const double weight = body.mass_kg * gravity_m_s2;
  const double water = sea_water_density_kg_m3 * gravity_m_s2;
  const double kb_less_kg = 0.2 - 0.4;
  EXPECT_NEAR(stiffness(body, {0.001, 0, 0}), water * 8 * 8 / 12.0 + weight * kb_less_kg, 30);
  EXPECT_NEAR(stiffness(body, {0, 0.001, 0}), water * 2 * 512 / 12.0 + weight * kb_less_kg, 300);
  body.hull = hull_of("beam_m: 1, depth_m: 1", "[-1.5, 1.5]");
  EXPECT_NEAR(stiffness(body, {0.001, 0, 0}),
              water * 2 * 8 * (1.5 * 1.5 + 1 / 12.0) + weight * kb_less_kg, 60);
}

TEST(FloatingHulls, StandUpByTheWholeLengthHoweverFewTheStrips) {
  Body body = barge();
  const double of_eight = stiffness(body, {0, 0.001, 0});
  body.hull = hull_of("beam_m: 2, depth_m: 1", "[0]", 3);
  EXPECT_NEAR(stiffness(body, {0, 0.001, 0}), of_eight, 1e-3 * of_eight);
}

TEST(FloatingHulls, ACylinderRollsAboutItsAxisWithoutMoment) {
  Body body = barge();
  body.hull = hull_of("radius_m: 1", "[0]");
  body.mass_kg = sea_water_density_kg_m3 * 8 * 0.5 * pi;
  body.centre_of_gravity_m = {0, 0, -0.5};  // on the axis
  const double weight = body.mass_kg * gravity_m_s2;
  EXPECT_NEAR(stiffness(body, {0.01, 0, 0}) / weight, 0, 2e-4);
}

TEST(FloatingHulls, ASectionUpsideDownDisplacesWhatIsLeftOfIt) {
  const FloatingHull hull = hull_of("beam_m: 2, depth_m: 1.6, deadrise_deg: 45", "[0]", 1);
  // Keel up, 1.2 m above the water: 0.4 m of the box is under.
  const Rotation<double> over = rotation_of(attitude_of({pi, 0, 0}));
  const Spatial<double> lift =
      floating_force<double>(hull, sea_water_density_kg_m3, over, -1.2 + 0.5, nullptr);
  EXPECT_NEAR(lift.linear.z, sea_water_density_kg_m3 * gravity_m_s2 * 8 * 2 * 0.4, 1);
}

/// Twin V hulls that may do what they like: no symmetry to hide behind.
Body twin_hull() {
  Body body;
  body.hull = hull_of("beam_m: 1, depth_m: 1.2, deadrise_deg: 50", "[-1.5, 1.4]", 4);
  body.fluid_density_kg_m3 = sea_water_density_kg_m3;
  body.height_m = 1;
  body.mass_kg = 4000;
  body.centre_of_gravity_m = {0.1, 0.02, -0.2};
  body.rigid_mass = rigid_mass_matrix(body.mass_kg, {6000, 20000, 24000}, body.centre_of_gravity_m);
  for (std::size_t i = 0; i < 6; ++i)
    body.added_mass.entry[i][i] = std::array{200.0, 3000.0, 4000.0, 5000.0, 16000.0, 16000.0}[i];
  body.inverse_mass = inverse_of(sum_of(body.rigid_mass, body.added_mass)).value();
  return body;
}

/// What it took to push the hulls of `twin_hull` to where they are, by the closed forms of their
/// section, J.
double hull_energy_j(const Body& body, const BodyState<double>& state) {
  constexpr double beam = 1, depth = 1.2;
  const double rise = 0.5 * std::tan(50 * pi / 180);
  const Triple<double> n = rotation_of(state.attitude).down;
  double sum = 0;
  for (std::size_t i = 0; i < body.hull.strips; ++i) {
    const double under = state.position_m.z + dot(n, body.hull.keel_m[i]);
    const double h = std::min(under / n.z, depth);
    if (h <= 0) continue;
    const double v = std::min(h, rise);
    const double breadth = beam * v / rise;
    const double area = 0.5 * breadth * v + beam * (h - v);
    const double moment = breadth * v * v / 3 + 0.5 * beam * (h * h - v * v);
    const double length = body.hull.part[0].strip_length_m;
    const double own = std::pow(breadth, 3) * n.y * n.y + breadth * length * length * n.x * n.x;
    sum += length * (area * under - n.z * moment + own / 24);
  }
  return sea_water_density_kg_m3 * gravity_m_s2 * sum;
}

TEST(FloatingHulls, AreBorneUpByTheGradientOfAnEnergy) {
  const Body body = twin_hull();
  Rng random(6, "tests/floating");
  for (int i = 0; i < 50; ++i) {
    BodyState<double> state = afloat(body);
    state.position_m.z += random.uniform(-0.1, 0.15);
    state.attitude = attitude_of(
        {random.uniform(-0.1, 0.1), random.uniform(-0.04, 0.04), random.uniform(-3, 3)});
    const Rotation<double> r = rotation_of(state.attitude);
    const Spatial<double> force =
        floating_force<double>(body.hull, body.fluid_density_kg_m3, r, state.position_m.z, nullptr);
    const auto slope = [&](const Spatial<double>& along) {
      constexpr double small = 1e-5;
      const BodyRate<double> rate{
          r.to_ned(along.linear), rate_of(state.attitude, along.angular), {}};
      return (hull_energy_j(body, moved(state, rate, small)) -
              hull_energy_j(body, moved(state, rate, -small))) /
             (2 * small);
    };
    // The area of the table is exact to h^2 B'/8 for its step h of 19 mm, that is 1.5 N a strip,
    // and to more at the chine; 4 m is the longest lever. What is compared is of 40 kN and 30 kN m.
    EXPECT_NEAR(force.linear.x, -slope({{1, 0, 0}, {}}), 5);
    EXPECT_NEAR(force.linear.y, -slope({{0, 1, 0}, {}}), 5);
    EXPECT_NEAR(force.linear.z, -slope({{0, 0, 1}, {}}), 20);
    EXPECT_NEAR(force.angular.x, -slope({{}, {1, 0, 0}}), 50);
    EXPECT_NEAR(force.angular.y, -slope({{}, {0, 1, 0}}), 100);
    EXPECT_NEAR(force.angular.z, -slope({{}, {0, 0, 1}}), 12);
  }
}

TEST(FloatingHulls, UndampedInStillWaterNoEnergyIsWonOrLost) {
  const Body body = twin_hull();
  const SpatialMatrix mass = sum_of(body.rigid_mass, body.added_mass);
  const auto energy = [&](const BodyState<double>& s) {
    const Triple<double> at =
        s.position_m + rotation_of(s.attitude).to_ned(body.centre_of_gravity_m);
    return kinetic_energy_j(mass, s.nu) + hull_energy_j(body, s) -
           body.mass_kg * gravity_m_s2 * at.z;
  };
  BodyState<double> state = afloat(body);
  const double at_rest = energy(state);
  state.nu = {{0, 0.2, 0.3}, {0.2, 0.1, 0}};
  const double put_in = energy(state) - at_rest;
  for (int i = 0; i < 60000; ++i) {  // ten minutes
    state = stepped(body, state, Forcing<double>{}, 0.01);
    ASSERT_NEAR(energy(state) - at_rest, put_in, 0.01 * put_in) << i;
  }
}

TEST(FloatingHulls, RiseAndFallWithALongWaveAndAreCarriedByItAsWaterIs) {
  Body body = barge();
  BodyState<double> state = afloat(body);
  const double rest = state.position_m.z;
  body.linear_damping.linear.z = 20000;
  const double omega = 2 * pi / 60;
  constexpr double dt_s = 0.02;
  double most = 0;
  for (int i = 0; i < 6000; ++i) {
    const double t = (i + 0.5) * dt_s;
    WaterAtStrips<double> water;
    for (std::size_t s = 0; s < body.hull.strips; ++s) {
      water.head_m[s] = 0.5 * std::sin(omega * t);
      water.acceleration_m_s2[s].x = 0.1 * std::cos(omega * t);
      // The water rises with its surface.
      water.velocity_m_s[s].z = -0.5 * omega * std::cos(omega * t);
    }
    Forcing<double> forcing;
    forcing.waves = waves_met(body.hull, water);
    state = stepped(body, state, forcing, dt_s);
    most = std::max(
        most, std::abs(-(state.position_m.z - rest) - 0.5 * std::sin(omega * (i + 1) * dt_s)));
    // dv/dt = m_displaced a/m = a: as the water goes.
    EXPECT_NEAR(state.nu.linear.x, 0.1 / omega * std::sin(omega * (i + 1) * dt_s), 0.02);
  }
  EXPECT_LT(most, 0.01);
}

TEST(FloatingHulls, TheWaterAtTheStripsIsFittedByTheRigidMotionItHas) {
  const Body body = twin_hull();
  const Rotation<double> r = rotation_of(attitude_of({0.2, -0.1, 1.1}));
  const Spatial<double> motion{{0.3, -0.2, 0.1}, {0.05, -0.04, 0.03}};
  std::array<Triple<double>, most_strips> ned{};
  for (std::size_t i = 0; i < body.hull.strips; ++i) {
    const Triple<double> at{body.hull.keel_m[i].x, body.hull.keel_m[i].y, 0};
    ned[i] = r.to_ned(motion.linear + cross(motion.angular, at));
  }
  const Spatial<double> found = motion_of_strips(body.hull, r, moments_of(body.hull, ned));
  EXPECT_NEAR(found.linear.x, 0.3, 1e-12);
  EXPECT_NEAR(found.linear.y, -0.2, 1e-12);
  EXPECT_NEAR(found.linear.z, 0.1, 1e-12);
  EXPECT_NEAR(found.angular.x, 0.05, 1e-12);
  EXPECT_NEAR(found.angular.y, -0.04, 1e-12);
  EXPECT_NEAR(found.angular.z, 0.03, 1e-12);
}

/// Two hulls of boxes, wide and shallow aft, narrow and deep forward, that float with the origin at
/// the waterline: an Otter's with its centre of flotation aft of that of buoyancy (Fossen 2021).
constexpr double aft_draught_m = 0.0581, fore_draught_m = 0.2877;
FloatingHull hulls_of_two_sections() {
  const Config config = Config::parse(R"(hulls:
  - {beam_m: 0.25, depth_m: 0.4, from_x_m: -1, to_x_m: 0.2, keel_z_m: 0.0581,
     centre_y_m: [-0.395, 0.395], strips: 4}
  - {beam_m: 0.09375, depth_m: 0.5, from_x_m: 0.2, to_x_m: 1, keel_z_m: 0.2877,
     centre_y_m: [-0.395, 0.395], strips: 2}
)",
                                      "hulls.yaml");
  FloatingHull hull = read_floating_hull(config);
  config.expect_all_read();
  return hull;
}
constexpr double aft_area_m2 = 2 * 1.2 * 0.25, fore_area_m2 = 2 * 0.8 * 0.09375;
constexpr double volume_of_two_m3 = aft_area_m2 * aft_draught_m + fore_area_m2 * fore_draught_m;

TEST(HullsOfSections, FloatOnTheVolumeOfAllAndTurnAboutTheCentreOfTheirWaterline) {
  FloatingHull hull = hulls_of_two_sections();
  EXPECT_EQ(hull.strips, 12U);
  EXPECT_EQ(hull.part[1].first, 8U);
  const double down_m =
      floating_depth_m(hull, sea_water_density_kg_m3 * volume_of_two_m3, sea_water_density_kg_m3);
  EXPECT_NEAR(down_m, 0, 1e-9);
  settle(hull, down_m);
  const double flotation_m = (aft_area_m2 * -0.4 + fore_area_m2 * 0.6) / 0.75;
  EXPECT_NEAR(flotation_m, -0.2, 1e-12);
  EXPECT_NEAR(hull.middle_m.x, flotation_m, 1e-12);
  double all = 0;
  for (const double share : hull.share) all += share;
  EXPECT_NEAR(all, 1, 1e-12);
  // A box feels the waves at its keel.
  EXPECT_NEAR(hull.part[1].felt_height_m, 0, 1e-12);
  const auto force = [&](double down, double pitch) {
    return floating_force<double>(hull, sea_water_density_kg_m3,
                                  rotation_of(attitude_of({0, pitch, 0})), down, nullptr);
  };
  const double n_m = sea_water_density_kg_m3 * gravity_m_s2;
  constexpr double small = 1e-5;
  EXPECT_NEAR(force(0, 0).linear.z, -n_m * volume_of_two_m3, 1e-6);
  // The centre of buoyancy, and what a change of draught or pitch does: 1508 N.
  const double volume_x_m4 =
      aft_area_m2 * aft_draught_m * -0.4 + fore_area_m2 * fore_draught_m * 0.6;
  EXPECT_NEAR(force(0, 0).angular.y, n_m * volume_x_m4, 1e-6);
  EXPECT_NEAR(volume_x_m4 / volume_of_two_m3, 0.1531, 1e-4);
  EXPECT_NEAR((force(small, 0).linear.z - force(-small, 0).linear.z) / (2 * small), -n_m * 0.75,
              1e-3);
  EXPECT_NEAR((force(small, 0).angular.y - force(-small, 0).angular.y) / (2 * small),
              n_m * 0.75 * flotation_m, 1e-3);
  EXPECT_NEAR((force(0, small).linear.z - force(0, -small).linear.z) / (2 * small), -1508,
              0.005 * 1508);
}

TEST(HullsOfSections, OfALightCraftAreDryWhereTheyAreShallow) {
  FloatingHull hull = hulls_of_two_sections();
  const double down_m =
      floating_depth_m(hull, sea_water_density_kg_m3 * fore_area_m2 * 0.1, sea_water_density_kg_m3);
  EXPECT_NEAR(down_m, 0.1 - fore_draught_m, 1e-9);
  settle(hull, down_m);
  EXPECT_EQ(hull.share[0], 0);
  EXPECT_NEAR(hull.middle_m.x, 0.6, 1e-12);
  EXPECT_NEAR(hull.spread_y_m2, 0.395 * 0.395, 1e-12);
  EXPECT_THROW((void)floating_depth_m(hull, 500, sea_water_density_kg_m3), Error);
}

TEST(HullsOfSections, AreBorneUpByTheGradientOfAnEnergy) {
  const FloatingHull hull = hulls_of_two_sections();
  const double n_m3 = sea_water_density_kg_m3 * gravity_m_s2;
  const auto energy_j = [&](double down_m, const Attitude<double>& attitude) {
    const Triple<double> n = rotation_of(attitude).down;
    double sum = 0;
    for (std::size_t i = 0; i < hull.strips; ++i) {
      const double beam = i < 8 ? 0.25 : 0.09375, length = i < 8 ? 0.3 : 0.4;
      const double under = down_m + dot(n, hull.keel_m[i]), h = under / n.z;
      const double own = beam * beam * beam * n.y * n.y + beam * length * length * n.x * n.x;
      sum += length * (beam * h * under - n.z * beam * h * h / 2 + own / 24);
    }
    return n_m3 * sum;
  };
  Rng random(7, "tests/sections");
  for (int i = 0; i < 50; ++i) {
    const double down_m = random.uniform(-0.01, 0.05);
    const Attitude<double> attitude =
        attitude_of({random.uniform(-0.04, 0.04), random.uniform(-0.02, 0.02), 0.3});
    const Rotation<double> r = rotation_of(attitude);
    const Spatial<double> force =
        floating_force<double>(hull, sea_water_density_kg_m3, r, down_m, nullptr);
    const auto slope = [&](const Spatial<double>& along) {
      constexpr double small = 1e-5;
      const auto at = [&](double step) {
        BodyState<double> state;
        state.position_m.z = down_m;
        state.attitude = attitude;
        const BodyState<double> there =
            moved(state, {r.to_ned(along.linear), rate_of(attitude, along.angular), {}}, step);
        return energy_j(there.position_m.z, there.attitude);
      };
      return (at(small) - at(-small)) / (2 * small);
    };
    // A box has no error of its table: of 800 N and 300 N m.
    EXPECT_NEAR(force.linear.z, -slope({{0, 0, 1}, {}}), 1e-3);
    EXPECT_NEAR(force.linear.y, -slope({{0, 1, 0}, {}}), 1e-3);
    EXPECT_NEAR(force.angular.x, -slope({{}, {1, 0, 0}}), 1e-3);
    EXPECT_NEAR(force.angular.y, -slope({{}, {0, 1, 0}}), 1e-3);
  }
}

TEST(HullsOfSections, OfOneAreAsOfAMapping) {
  const std::string one =
      "{radius_m: 0.3, from_x_m: -2, to_x_m: 1, keel_z_m: 0.2, centre_y_m: [-1, 1], strips: 5}";
  const FloatingHull a = read_floating_hull(Config::parse("hulls: " + one, "hull.yaml"));
  const FloatingHull b = read_floating_hull(Config::parse("hulls: [" + one + "]", "hull.yaml"));
  // Apart in two: the same strips.
  const FloatingHull c = read_floating_hull(Config::parse(
      "hulls:\n- {radius_m: 0.3, from_x_m: -2, to_x_m: 1, keel_z_m: 0.2, centre_y_m: -1, strips: "
      "5}\n- {radius_m: 0.3, from_x_m: -2, to_x_m: 1, keel_z_m: 0.2, centre_y_m: 1, strips: 5}",
      "hull.yaml"));
  const Rotation<double> r = rotation_of(attitude_of({0.1, -0.05, 1}));
  const auto force = [&](const FloatingHull& hull) {
    return floating_force<double>(hull, 1000, r, 0.1, nullptr);
  };
  for (const FloatingHull& hull : {b, c}) {
    EXPECT_EQ(force(a).linear.z, force(hull).linear.z);
    EXPECT_EQ(force(a).angular.x, force(hull).angular.x);
    EXPECT_EQ(a.spread_x_m2, hull.spread_x_m2);
  }
  EXPECT_EQ(c.parts, 2U);
  const std::string five = one + ", " + one + ", " + one + ", " + one + ", " + one;
  EXPECT_THROW((void)read_floating_hull(Config::parse("hulls: [" + five + "]", "hull.yaml")),
               Error);
  EXPECT_THROW(
      (void)read_floating_hull(Config::parse("hulls: [" + one + ", " + one + "]", "hull.yaml")),
      Error);
}

}  // namespace
}  // namespace slackwater::twin::floating_hull_test
