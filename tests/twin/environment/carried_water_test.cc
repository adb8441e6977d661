#include "twin/environment/carried_water.h"

#include "fields/wave/sea_components.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/tether/node_load.h"

namespace slackwater::twin::carried_water_test {
namespace {

constexpr double look_s = 0.3;

/// Sheared current of 0.1 to 0.4 m/s in 60 m, with or without a sea of 1.5 m and 4 s.
Environment environment_of(bool has_sea) {
  const Scenario scenario =
      parse_scenario(tests::head(0.05) +
                         "  - {name: a, model: lrauv_tethys, start: {north_m: 0, east_m: 0, "
                         "depth_m: 10}}\n",
                     "test.yaml");
  const Surround surround = tests::surround_of(scenario);
  Environment environment;
  environment.field = surround.field;
  environment.origin = surround.site;
  environment.epoch = parse_utc("2025-06-02T06:00:00Z");
  if (!has_sea) return environment;
  PartitionedSea sea;
  sea.partitions = {{1.5, 4, 250, {}, 10}};
  const WaveWater water{60, {0.4, 0.1}};
  environment.sea = std::make_shared<SeaRealisation>(
      SeaRealisation(components_of(sea, water, 3).waves, water, environment.epoch));
  return environment;
}

/// A vehicle that goes north at 0.3 m/s in 6 m, and a line from the surface down to it.
MovingPlaces places_at(double t_s) {
  MovingPlaces places;
  places.count = carried_places;
  places.vehicle_height_m = 0.25;
  places.at_m[0] = {0.3 * t_s, 0, 6};
  places.velocity_m_s[0] = {0.3, 0, 0};
  for (std::size_t i = 0; i < tether_inner_nodes; ++i) {
    const double share = static_cast<double>(i + 1) / tether_segments;
    places.at_m[i + 1] = {0.3 * share * t_s, -20 * (1 - share), 2 + 4 * share};
    places.velocity_m_s[i + 1] = {0.3 * share, 0, 0};
  }
  return places;
}

TEST(CarriedWater, IsTheWaterBetweenTheLooks) {
  const Environment environment = environment_of(true);
  const EnvironmentSampler water(environment);
  CarriedWater carried;
  double error2 = 0, square2 = 0, push_error2 = 0, push2 = 0, node_error2 = 0, node2 = 0;
  for (int step = 0; step < 1200; ++step) {
    const double t_s = 0.05 * step;
    const MovingPlaces places = places_at(t_s);
    if (step % 6 == 0) look_ahead(water, places, t_s, look_s, carried);
    ASSERT_EQ(carried.holds, 1);
    const WaterSample got = vehicle_water(carried, t_s);
    const WaterSample expected = water.water(places.at_m[0], places.vehicle_height_m, t_s);
    const auto square = [](const Triple<double>& a) { return dot(a, a); };
    error2 += square(got.motion.velocity_m_s - expected.motion.velocity_m_s);
    square2 += square(expected.motion.velocity_m_s - expected.current_m_s);
    push_error2 += square(got.motion.acceleration_m_s2 - expected.motion.acceleration_m_s2);
    push2 += square(expected.motion.acceleration_m_s2);
    // The field keeps its levels as floats.
    EXPECT_NEAR(length_of(got.current_m_s - expected.current_m_s), 0, 1e-6);
    EXPECT_NEAR(length_of(got.motion.shear_per_s - expected.motion.shear_per_s), 0, 1e-6);
    const WaterAtNodes<double> nodes = node_water(carried, t_s);
    // A node in 3 m: waves of a second reach it, which thirteen looks in four seconds cannot
    // follow.
    const WaterSample node = water.water(places.at_m[4], 0, t_s);
    node_error2 += square(nodes.velocity_m_s[4] - node.motion.velocity_m_s);
    node2 += square(node.motion.velocity_m_s - node.current_m_s);
  }
  EXPECT_LT(std::sqrt(error2 / square2), 0.005);
  // That of the water of the cubic: with what the moving surface stretches.
  EXPECT_LT(std::sqrt(push_error2 / push2), 0.15);
  EXPECT_LT(std::sqrt(node_error2 / node2), 0.02);
}

TEST(CarriedWater, IsTheCurrentWhereThereAreNoWaves) {
  const Environment environment = environment_of(false);
  const EnvironmentSampler water(environment);
  CarriedWater carried;
  look_ahead(water, places_at(0), 0, look_s, carried);
  const WaterSample got = vehicle_water(carried, 0.15);
  const WaterSample expected = water.water({0.045, 0, 6}, 0.25, 0.15);
  EXPECT_NEAR(length_of(got.motion.velocity_m_s - expected.motion.velocity_m_s), 0, 1e-6);
  EXPECT_EQ(length_of(got.motion.acceleration_m_s2), 0);
  EXPECT_EQ(got.motion.elevation_m, 0);
  const WaterAtNodes<double> nodes = node_water(carried, 0.15);
  for (std::size_t i = 1; i < tether_nodes - 1; ++i) {
    const WaterSample node = water.water(places_at(0.15).at_m[i], 0, 0.15);
    EXPECT_NEAR(length_of(nodes.velocity_m_s[i] - node.motion.velocity_m_s), 0, 1e-6) << i;
  }
}

TEST(CarriedWater, DoesNotHoldWhereTheVehicleWillHaveNone) {
  const Environment environment = environment_of(true);
  const EnvironmentSampler water(environment);
  CarriedWater carried;
  MovingPlaces places = places_at(0);
  places.at_m[0].z = 59.8;
  places.velocity_m_s[0].z = 1;
  look_ahead(water, places, 0, look_s, carried);
  EXPECT_EQ(carried.holds, 0);
  // Nor at the next look, which begins where there is still none; then it is up again.
  places.at_m[0].z = 60.2;
  places.velocity_m_s[0].z = -1;
  look_ahead(water, places, look_s, look_s, carried);
  EXPECT_EQ(carried.holds, 0);
  places.at_m[0].z = 59.8;
  look_ahead(water, places, 2 * look_s, look_s, carried);
  EXPECT_EQ(carried.holds, 1);
}

}  // namespace
}  // namespace slackwater::twin::carried_water_test
