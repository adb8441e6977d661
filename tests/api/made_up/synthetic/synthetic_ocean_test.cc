#include "api/made_up/synthetic/synthetic_ocean.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater::api::synthetic_ocean_test {
namespace {

using std::chrono::hours;

const SyntheticOcean& ocean() {
  static const SyntheticOcean one({.days = 15});
  return one;
}

GeoPoint site() { return ocean().settings().site; }

TEST(SyntheticOcean, IsDeterminedByItsSeed) {
  const SyntheticOcean again({.days = 15});
  const SyntheticOcean other({.seed = 7, .days = 15});
  const UtcTime time = ocean().begin() + hours{77};
  EXPECT_EQ(ocean().current_truth(site(), 10, time), again.current_truth(site(), 10, time));
  EXPECT_NE(ocean().current_truth(site(), 10, time), other.current_truth(site(), 10, time));
  EXPECT_EQ(ocean().sea_truth(site(), time)->significant_height_m,
            again.sea_truth(site(), time)->significant_height_m);
}

TEST(SyntheticOcean, SiteLiesIn35MetresAndTheBedSlopesFrom15To60) {
  EXPECT_DOUBLE_EQ(ocean().water_depth_m(site()), 35);
  EXPECT_GT(ocean().water_depth_m(GeoPoint::from_degrees(49.0, -2.55)), 45);
  for (double latitude = 48.70; latitude < 49.05; latitude += 0.01) {
    for (double longitude = -2.95; longitude < -2.15; longitude += 0.01) {
      const GeoPoint point = GeoPoint::from_degrees(latitude, longitude);
      if (ocean().is_land(point)) continue;
      EXPECT_GT(ocean().water_depth_m(point), 12.9);
      EXPECT_LT(ocean().water_depth_m(point), 62);
    }
  }
}

TEST(SyntheticOcean, LandAndTheBedHaveNoCurrentRatherThanAZero) {
  const GeoPoint inland = GeoPoint::from_degrees(48.69, -2.55);
  ASSERT_TRUE(ocean().is_land(inland));
  const UtcTime time = ocean().begin() + hours{30};
  EXPECT_FALSE(ocean().current_truth(inland, 0, time).has_value());
  EXPECT_FALSE(ocean().sea_truth(inland, time).has_value());
  EXPECT_TRUE(ocean().current_truth(site(), 34.9, time).has_value());
  EXPECT_FALSE(ocean().current_truth(site(), 35.1, time).has_value());
  EXPECT_FALSE(ocean().current_truth(site(), -0.1, time).has_value());
  EXPECT_THROW((void)ocean().current_truth(site(), 1, ocean().end() + hours{1}), ContractViolation);
}

TEST(SyntheticOcean, StreamsAreThoseOfTheBay) {
  // A fortnight holds springs and neaps: daily maxima of the surface current.
  double springs = 0;
  double neaps = 9;
  for (UtcTime day = ocean().begin(); day + hours{25} <= ocean().end(); day += hours{24}) {
    double highest = 0;
    for (int i = 0; i < 25 * 4; ++i) {
      highest = std::max(
          highest, std::abs(*ocean().current_truth(site(), 5, day + std::chrono::minutes{15 * i})));
    }
    springs = std::max(springs, highest);
    neaps = std::min(neaps, highest);
  }
  EXPECT_GT(springs, 0.75);
  EXPECT_LT(springs, 1.25);  // streams of 0.8, drift of wind and interior on top
  EXPECT_GT(neaps, 0.25);
  EXPECT_LT(neaps, 0.7);
}

TEST(SyntheticOcean, WindStaysBetween5And18AndWavesAreThoseOfSuchAWind) {
  for (UtcTime time = ocean().begin(); time <= ocean().end(); time += hours{1}) {
    const double speed = std::abs(ocean().wind_truth(site(), time));
    EXPECT_GE(speed, 5);
    EXPECT_LE(speed, 18);
    const SyntheticSea sea = *ocean().sea_truth(site(), time);
    EXPECT_GT(sea.significant_height_m, 0.4);
    EXPECT_LT(sea.significant_height_m, 5);
    // Steepness below the breaking limit of physics section 8, and the drift 0.3 to 3 % of the wind
    // or so.
    EXPECT_LT(2 * constants::pi * sea.significant_height_m /
                  (constants::gravity_m_s2 * sea.peak_period_s * sea.peak_period_s),
              1.0 / 15);
    EXPECT_LT(std::abs(sea.stokes_drift_m_s), 0.03 * speed + 0.05);
    EXPECT_GT(sea.peak_period_s, sea.mean_period_tm02_s);
    EXPECT_GE(sea.from_direction_deg, 0);
    EXPECT_LT(sea.from_direction_deg, 360);
  }
}

TEST(SyntheticOcean, WindDrivenFlowAwayFromTheSiteAnswersTheLocalWind) {
  // The two tables that serve every place against a column integrated with the stress of this very
  // place.
  const GeoPoint place = GeoPoint::from_degrees(48.95, -2.35);
  const double water_m = ocean().water_depth_m(place);
  const ColumnPhysics local{.coriolis_rad_s = ocean().coriolis_rad_s(),
                            .reference_depth_m = water_m,
                            .reference = ocean().mixing_truth(place)};
  const UtcTime start = ocean().begin();
  const WindDrivenColumn column(local, 0, 11 * 24, [&](double h) {
    const Horizontal wind = ocean().wind_truth(place, add_hours(start, h));
    const double speed = std::abs(wind);
    return constants::air_density_kg_m3 / constants::sea_water_density_kg_m3 *
           (0.79 + 0.08 * speed) * 1e-3 * speed * wind;
  });
  for (const double depth_m : {0.0, 5.0, 20.0, water_m}) {
    // Ten days suffice to forget the start (friction time below 12 h); 0.1 mm/s of interpolation.
    EXPECT_LT(std::abs(column.velocity(water_m, depth_m, 240) -
                       *ocean().wind_driven_truth(place, depth_m, start + hours{240})),
              1e-4);
  }
}

TEST(SyntheticOcean, SeriesAndSinglePointsAreTheSameTruth) {
  const std::vector<double> depths{0, 10, 35, 40};
  const CurrentSeries series(ocean(), site(), depths);
  std::vector<Horizontal> profile(depths.size());
  const UtcTime time = ocean().begin() + hours{101};
  series.at(time, profile);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(profile[k], *ocean().current_truth(site(), depths[k], time));
  EXPECT_TRUE(std::isnan(profile[3].real()));
}

TEST(Tide, ArgumentsRunAtTheSpeedsOfTheStandardTable) {
  const double expected_deg_h[] = {28.9841042, 30.0,       28.4397295,
                                   15.0410686, 13.9430356, 57.9682085};
  const UtcTime start = ocean().begin();
  const Tide::Arguments before = Tide::arguments(start);
  const Tide::Arguments after = Tide::arguments(start + hours{1});
  for (std::size_t j = 0; j < Tide::constituents; ++j) {
    EXPECT_NEAR(Tide::speed_deg_h(j), expected_deg_h[j], 2e-7) << Tide::name(j);
    EXPECT_NEAR(std::arg(after[j] / before[j]) * 180 / constants::pi, expected_deg_h[j], 1e-6)
        << Tide::name(j);
  }
}

TEST(WeatherForecast, ErrorGrowsWithLeadAsStated) {
  double sum_day1 = 0;
  double sum_day3 = 0;
  int n = 0;
  for (int run = 0; run < 150; ++run) {
    const UtcTime issued = ocean().begin() + hours{run};
    const WeatherForecast forecast = ocean().weather_forecast(issued);
    const auto error = [&](int lead) {
      return forecast.wind_m_s({}, ocean().hours_since_epoch(issued) + lead) -
             ocean().wind_truth(site(), issued + hours{lead});
    };
    sum_day1 += std::norm(error(24));
    sum_day3 += std::norm(error(72));
    ++n;
  }
  // Vector errors are sqrt 2 times the component's; 150 draws know a deviation within 12 % (two
  // sigma).
  EXPECT_NEAR(std::sqrt(sum_day1 / n / 2), WeatherForecast::component_sigma_m_s(24), 0.12);
  EXPECT_NEAR(std::sqrt(sum_day3 / n / 2), WeatherForecast::component_sigma_m_s(72), 0.27);
}

}  // namespace
}  // namespace slackwater::api::synthetic_ocean_test
