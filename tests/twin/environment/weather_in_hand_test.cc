// The weather that a supervisor leads: what vehicles then have, from where it was to what is asked.
#include "twin/environment/weather_in_hand.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/check.h"
#include "fields/wave/sea_sampling.h"
#include "fields/wind/log_profile.h"
#include "tests/support/contains.h"
#include "twin/body/frame.h"
#include "twin/environment/environment.h"
#include "twin/environment/made_up_field.h"

namespace slackwater::twin::weather_in_hand_test {
namespace {

const UtcTime start = parse_utc("2025-06-02T06:00:00Z");
const GeoPoint origin = GeoPoint::from_degrees(54, 6.6);
constexpr double own_wind_m_s = 5;

/// 1 m/s east at the surface, 0 at 20 m; 30 m of water; 5 m/s from the south; waves of 1 m, 7 s.
Environment sheared_water() {
  MadeUpWater water;
  water.depth_m = 30;
  water.current = {{0, 1, 0}, {20, 0, 0}};
  water.wind_speed_m_s = own_wind_m_s;
  water.wind_from_deg = 180;
  Environment environment;
  environment.origin = origin;
  environment.epoch = start;
  environment.field = made_up_field(water, origin, start, start + std::chrono::hours(2));
  environment.stated_sea = SeaState{1, 7, 270};
  const std::vector<WavePartition> partition{{1, 7, 270}};
  environment.sea = std::make_shared<const SeaRealisation>(
      realise({partition}, {30, {}}, 7, start, {.count = 32}));
  environment.sea_peak_period_s = 7;
  environment.weather = std::make_shared<WeatherInHand>();
  return environment;
}

double elevation_in(const SeaRealisation& sea, double t_s) {
  double eta_m = 0;
  const WavePlace place{3, 4, 0, t_s};
  sample_elevation(sea, {&place, 1}, {&eta_m, 1});
  return eta_m;
}

struct WeatherLed : testing::Test {
  Environment environment = sheared_water();
  EnvironmentSampler sampler{environment};
  const Triple<double> deep{0, 0, 12}, shallow{0, 0, 2};

  void set(const WeatherAsked& asked, double t_s) {
    environment.weather->set(asked, environment, t_s);
  }
  [[nodiscard]] double east_m_s(const Triple<double>& at_m, double t_s) const {
    return sampler.current(at_m, 0, t_s).current_m_s.y;
  }
  [[nodiscard]] double wind_m_s(double height_m, double t_s) const {
    return length_of(sampler.wind({0, 0, -height_m}, t_s).velocity_m_s);
  }
};

TEST(LedQuantity, GoesInAStraightLineFromWhereItIs) {
  Lead<double> lead;
  EXPECT_EQ(lead.of(3, 0), 3);
  lead.lead(7, 10, 20);
  EXPECT_EQ(lead.of(3, 10), 3);
  EXPECT_DOUBLE_EQ(lead.of(3, 20), 5);
  EXPECT_EQ(lead.of(3, 30), 7);
  EXPECT_EQ(lead.of(std::nan(""), 31), 7) << "what it would be by itself counts no more";
  // Led elsewhere before it is there: on from 5.
  lead.lead(0, 20, 10);
  EXPECT_DOUBLE_EQ(lead.of(3, 20), 5);
  EXPECT_DOUBLE_EQ(lead.of(3, 25), 3) << "the midst between 6 on the first way and 0";
  EXPECT_EQ(lead.of(3, 30), 0);
}

TEST(LedQuantity, IsLedBackToWhatItIsByThen) {
  Lead<double> lead;
  lead.lead(7, 0, 10);
  lead.lead(std::nullopt, 100, 10);
  EXPECT_EQ(lead.of(3, 100), 7);
  EXPECT_DOUBLE_EQ(lead.of(4, 105), 0.5 * (7 + 4));
  EXPECT_EQ(lead.of(4.25, 110), 4.25) << "to the last bit";
  EXPECT_THROW(lead.lead(1, 50, 10), ContractViolation);
  EXPECT_THROW(lead.lead(1, 200, 0), ContractViolation);
}

TEST_F(WeatherLed, LeavesEverythingAsItIsUntilSomebodyLeadsIt) {
  const WaterSample before = sampler.water(shallow, 0.3, 50);
  EXPECT_EQ(environment.weather->now(), nullptr);
  set({}, 10);
  const WaterSample after = sampler.water(shallow, 0.3, 50);
  EXPECT_EQ(before.motion.velocity_m_s.y, after.motion.velocity_m_s.y);
  EXPECT_EQ(before.motion.elevation_m, after.motion.elevation_m);
  EXPECT_EQ(wind_m_s(10, 50), own_wind_m_s);
}

TEST_F(WeatherLed, CurrentBecomesTheSameAtAllDepths) {
  WeatherAsked asked;
  asked.current_m_s = Horizontal(-0.6, 0.2);
  asked.over_s = 100;
  set(asked, 50);
  EXPECT_NEAR(east_m_s(deep, 50), 0.4, 1e-6) << "still its own";
  EXPECT_NEAR(east_m_s(deep, 100), 0.5 * (0.4 - 0.6), 1e-6);
  for (const auto& at_m : {shallow, deep, Triple<double>{0, 0, 25}}) {
    EXPECT_DOUBLE_EQ(east_m_s(at_m, 151), -0.6);
    EXPECT_DOUBLE_EQ(sampler.forecast_current(at_m, 151).velocity_m_s.imag(), 0.2)
        << "limits are on that";
  }
  EXPECT_DOUBLE_EQ(sampler.current(deep, 2, 151).motion.shear_per_s.y, 0);
  EXPECT_EQ(sampler.current({0, 0, 31}, 0, 151).status, SampleStatus::below_bed)
      << "no water where there is none";
}

TEST_F(WeatherLed, WindHasTheProfileOfTheSeaAndGustsToMatch) {
  WeatherAsked asked;
  asked.wind_10m_m_s = Horizontal(0, 15);  // from the south, as its own
  set(asked, 0);
  EXPECT_NEAR(wind_m_s(10, 30), 0.5 * (own_wind_m_s + 15), 1e-9);
  EXPECT_NEAR(wind_m_s(10, 60), 15, 1e-9);
  EXPECT_NEAR(wind_m_s(90, 60), 15 * log_profile_ratio(90, 10), 1e-9);
  EXPECT_NEAR(sampler.gust_ratio({0, 0, -10}, 60), 3, 1e-9) << "in proportion to the wind";
  EXPECT_EQ(sampler.gust_ratio({0, 0, -10}, 0), 1);
}

TEST_F(WeatherLed, WavesAreTheSameOnesHigherOrLower) {
  const auto elevation_m = [&](double t_s) { return elevation_in(*sampler.waves(), t_s); };
  const double before_m = elevation_m(200),
               speed_m_s = sampler.water(shallow, 0, 200).motion.velocity_m_s.z;
  WeatherAsked asked;
  asked.significant_wave_height_m = 1.5;
  set(asked, 100);
  const double grows = 1.5 / environment.sea->significant_height_m();
  EXPECT_NEAR(elevation_m(200), grows * before_m, 1e-12);
  // Stretching to the higher surface changes a little of what is below it.
  EXPECT_NEAR(sampler.water(shallow, 0, 200).motion.velocity_m_s.z, grows * speed_m_s,
              0.1 * std::abs(speed_m_s));
  EXPECT_DOUBLE_EQ(sampler.sea({}, 200).sea.significant_height_m, 1.5) << "limits are on that";
  EXPECT_EQ(sampler.sea({}, 200).sea.peak_period_s, 7);
  set({}, 300);
  EXPECT_EQ(sampler.sea({}, 400).sea.significant_height_m, 1);
  EXPECT_EQ(elevation_m(400), elevation_in(*environment.sea, 400)) << "its own again";
  asked.significant_wave_height_m = 0;
  set(asked, 500);
  EXPECT_EQ(elevation_m(600), 0);
}

TEST_F(WeatherLed, IsForgottenWhole) {
  WeatherAsked asked;
  asked.current_m_s = Horizontal(-0.6, 0.2);
  asked.visibility_m = 500;
  asked.water_visibility_m = 2;
  set(asked, 0);
  EXPECT_EQ(sampler.visibility_m(), 500);
  EXPECT_EQ(environment.weather->now()->settled_s, 60);
  asked.visibility_m = 300;
  set(asked, 10);
  EXPECT_EQ(sampler.visibility_m(), 300) << "at once";
  EXPECT_EQ(environment.weather->now()->settled_s, 60) << "the current is still on its way";
  EXPECT_EQ(sampler.water_visibility_m(), 2);
  environment.weather->forget();
  EXPECT_NEAR(east_m_s(deep, 100), 0.4, 1e-6);
  EXPECT_FALSE(sampler.visibility_m());
}

TEST_F(WeatherLed, IsRefusedWithWhatWouldDo) {
  const auto expect_refused = [&](const WeatherAsked& asked, const std::string& words) {
    EXPECT_TRUE(tests::contains(problem_of(asked, environment), words));
  };
  WeatherAsked asked;
  EXPECT_EQ(problem_of(asked, environment), "");
  asked.wind_10m_m_s = Horizontal(61, 0);
  expect_refused(asked, "wind: found 61 m/s, expected 0 to 60 m/s");
  asked = {};
  asked.current_m_s = Horizontal(std::nan(""), 0);
  expect_refused(asked, "current: found nan m/s");
  asked = {};
  asked.significant_wave_height_m = 9;  // steeper than waves of 7 s can stand
  expect_refused(asked, "higher waves of 7.0 s break");
  asked = {};
  asked.over_s = 0;
  expect_refused(asked, "over: found 0 s");
  asked = {};
  asked.water_visibility_m = 1e4;
  expect_refused(asked, "visibility under water: found 10000 m");
  environment.sea = nullptr;
  asked = {};
  asked.significant_wave_height_m = 1;
  expect_refused(asked, "a calm sea");
}

}  // namespace
}  // namespace slackwater::twin::weather_in_hand_test
