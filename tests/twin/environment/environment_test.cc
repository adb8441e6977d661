#include "twin/environment/environment.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/geo/local_frame.h"
#include "fields/wave/dispersion.h"
#include "fields/wave/sea_sampling.h"
#include "twin/environment/made_up_field.h"

namespace slackwater::twin::environment_test {
namespace {

const UtcTime start = parse_utc("2025-06-02T06:00:00Z");
const GeoPoint origin = GeoPoint::from_degrees(54, 6.6);

/// 1 m/s east at the surface, 0 at 20 m, 0.2 m/s north throughout; 30 m of water.
Environment sheared_water() {
  MadeUpWater water;
  water.depth_m = 30;
  water.current = {{0, 1, 0.2}, {20, 0, 0.2}};
  water.wind_speed_m_s = 10;
  water.wind_from_deg = 180;
  Environment environment;
  environment.origin = origin;
  environment.epoch = start;
  environment.field = made_up_field(water, origin, start, start + std::chrono::hours(2));
  return environment;
}

TEST(Environment, CurrentIsTheMeanOverTheHullWithItsShear) {
  const Environment environment = sheared_water();
  const EnvironmentSampler sampler(environment);
  const WaterSample sample = sampler.water({100, -200, 10}, 2, 60);
  ASSERT_TRUE(has_value(sample.status));
  // NED: north first. Between the levels 0.05 m/s a metre.
  EXPECT_NEAR(sample.motion.velocity_m_s.x, 0.2, 1e-6);
  EXPECT_NEAR(sample.motion.velocity_m_s.y, 0.5, 1e-6);
  EXPECT_NEAR(sample.motion.shear_per_s.y, -0.05, 1e-6);
  EXPECT_NEAR(sample.motion.shear_per_s.x, 0, 1e-6);
  EXPECT_EQ(sample.motion.velocity_m_s.z, 0);
}

TEST(Environment, OutsideTheWaterIsAStatusNeverANumber) {
  const Environment environment = sheared_water();
  const EnvironmentSampler sampler(environment);
  EXPECT_EQ(sampler.water({0, 0, 30.5}, 0.2, 0).status, SampleStatus::below_bed);
  EXPECT_EQ(sampler.water({0, 0, 5}, 0.2, 86400).status, SampleStatus::outside_time);
  EXPECT_EQ(sampler.water({9e5, 0, 5}, 0.2, 0).status, SampleStatus::outside_area);
  const double nan = std::nan("");
  EXPECT_FALSE(has_value(sampler.water({nan, 0, 5}, 0.2, 0).status));
  EXPECT_FALSE(has_value(sampler.wind({0, nan, -5}, 0).status));
}

TEST(Environment, WindIsTowardsAndGrowsWithHeight) {
  const Environment environment = sheared_water();
  const EnvironmentSampler sampler(environment);
  // From the south: it blows north.
  const auto at_10 = sampler.wind({0, 0, -10}, 0);
  EXPECT_NEAR(at_10.velocity_m_s.x, 10, 1e-6);
  EXPECT_NEAR(at_10.velocity_m_s.y, 0, 1e-6);
  // fields/docs/physics.md, section 9: 12.030748 at 90 m.
  EXPECT_NEAR(sampler.wind({0, 0, -90}, 0).velocity_m_s.x, 12.030748, 1e-4);
}

TEST(Environment, ALongWaveMovesTheWaterAsAiryHasIt) {
  Environment environment = sheared_water();
  const WaveWater water{30, {}};
  const auto wave = wave_component(1, 2 * constants::pi / 8, FrequencyFrame::intrinsic, 270, 0,
                                   water);  // from the west, going east
  environment.sea =
      std::make_shared<SeaRealisation>(std::vector{*wave}, water, start, Stretching::none);
  const EnvironmentSampler sampler(environment);
  // Crest over the origin at t = 0: u = a omega cosh k(z+h)/sinh kh = 0.599558 at 5 m
  // (fields/docs/physics.md, section 8), vertical 0, acceleration 0 along and downwards
  // -(-omega^2...) : a crest pulls down, w' = -0.555721 omega.
  const WaterSample sample = sampler.water({0, 0, 5}, 0, 0);
  ASSERT_TRUE(has_value(sample.status));
  EXPECT_NEAR(sample.motion.elevation_m, 1, 1e-9);
  EXPECT_NEAR(sample.motion.velocity_m_s.y - 0.75, 0.599558, 2e-6);
  EXPECT_NEAR(sample.motion.velocity_m_s.z, 0, 1e-9);
  EXPECT_NEAR(sample.motion.acceleration_m_s2.z, 0.555721 * 2 * constants::pi / 8, 2e-6);
  // A quarter of a period later the water sinks: down is positive.
  const WaterSample later = sampler.water({0, 0, 5}, 0, 2);
  EXPECT_NEAR(later.motion.velocity_m_s.z, 0.555721, 2e-6);
  EXPECT_NEAR(later.motion.acceleration_m_s2.y, -0.470891, 2e-6);
}

TEST(Environment, ThePlaneIsThatOfTheEllipsoidNearTheOrigin) {
  const Environment environment = sheared_water();
  const DegreesPerMetre per_m = degrees_per_metre(origin);
  const LocalFrame exact(origin);
  for (const double distance_m : {10.0, 1000.0, 10000.0}) {
    const auto enu = exact.to_local(
        GeoPoint::from_degrees(54 + distance_m * per_m.north, 6.6 + distance_m * per_m.east));
    // Meridians draw together northwards: tan(latitude) d^2/R.
    const double tolerance_m =
        1e-6 + 1.02 * std::tan(54 * constants::pi / 180) / 6.378e6 * distance_m * distance_m;
    EXPECT_NEAR(enu.x(), distance_m, tolerance_m);
    EXPECT_NEAR(enu.y(), distance_m, tolerance_m);
  }
}

TEST(Environment, APileTurnsTheCurrentAside) {
  Environment environment = sheared_water();
  environment.piles.push_back({{6, 1.05}, Horizontal(0, 0)});
  const EnvironmentSampler sampler(environment);
  // At 10 m the stream is (0.5 east, 0.2 north); beside the pile across it, it runs nearly twice as
  // fast.
  const double stream = std::hypot(0.5, 0.2);
  const WaterSample beside = sampler.water({3.0 * 0.5 / stream, -3.0 * 0.2 / stream, 10}, 0, 0);
  ASSERT_TRUE(has_value(beside.status));
  EXPECT_NEAR(std::hypot(beside.motion.velocity_m_s.x, beside.motion.velocity_m_s.y), 2 * stream,
              0.05 * stream);
  EXPECT_EQ(sampler.water({0, 0, 10}, 0, 0).status, SampleStatus::land);
}

}  // namespace
}  // namespace slackwater::twin::environment_test
