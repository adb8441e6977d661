// One snapshot, asked anywhere.
#include "fields/service/field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"
#include "tests/support/made_up_forecast.h"
#include "tests/support/reference_profile.h"

namespace slackwater::field_test {
namespace {

using std::chrono::hours;
using std::chrono::minutes;

const UtcTime start = parse_utc("2025-03-10T00:00:00Z");

/// Linear in longitude, latitude, depth and time; exact under our interpolation but for single
/// precision.
Horizontal plane(double longitude, double latitude, double depth, double hour) {
  return {0.3 + 2 * (longitude - 1) - (latitude - 52) - 0.004 * depth + 0.01 * hour,
          -0.2 - (longitude - 1) + 3 * (latitude - 52) + 0.002 * depth - 0.005 * hour};
}

/// Four by three columns, 30 to 33 m of water, wind and waves that grow with time.
Snapshot made(bool with_land = false) {
  Snapshot s;
  s.site_id = "test";
  s.depth_m = {0.5, 3, 8, 15, 22, 29.5};
  for (int t = 0; t <= 24; ++t) s.time.push_back(start + hours(t));
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 4; ++i) {
      if (with_land && i == 0) continue;
      ForecastColumn c;
      c.point = GeoPoint::from_degrees(52 + 0.05 * j, 1 + 0.05 * i);
      c.water_depth_m = 30 + i;
      for (int t = 0; t <= 24; ++t) {
        for (const double depth : s.depth_m) {
          c.current_m_s.push_back(plane(1 + 0.05 * i, 52 + 0.05 * j, depth, t));
          c.current_sigma_m_s.push_back(0.05 + 0.002 * t);
          c.current_status.push_back(SampleStatus::ok);
        }
        c.wind_m_s.emplace_back(5 + 0.1 * t, -3 + i);
        c.sea.push_back({1 + 0.05 * t, 6, t % 2 == 0 ? 350.0 : 10.0});
      }
      s.columns.push_back(c);
    }
  }
  return s;
}

Field field_of(Snapshot s) { return Field(std::make_shared<const Snapshot>(std::move(s))); }

Place place(double longitude, double latitude, double vertical, double hour) {
  return {longitude, latitude, vertical, add_hours(start, hour)};
}

TEST(Field, AFieldThatIsLinearComesBackEverywhereToSinglePrecision) {
  const Field field = field_of(made());
  Rng random(4, "tests/field");
  std::vector<Place> places;
  for (int i = 0; i < 2000; ++i) {
    places.push_back(place(random.uniform(1, 1.15), random.uniform(52, 52.1),
                           random.uniform(0.5, 29.5), random.uniform(0, 24)));
  }
  std::vector<CurrentSample> out(places.size());
  field.sample_current(places, out);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Place& p = places[i];
    const double hour = hours_between(start, p.time);
    ASSERT_EQ(out[i].status, SampleStatus::ok);
    // A thousandth of a cell (5e-5 degrees, slope 3 per degree) where the place is taken for the
    // centre.
    EXPECT_LT(
        std::abs(out[i].velocity_m_s - plane(p.longitude_deg, p.latitude_deg, p.vertical_m, hour)),
        3e-4);
    EXPECT_NEAR(out[i].sigma_m_s, 0.05 + 0.002 * hour, 1e-6);
  }
}

TEST(Field, AtItsColumnsItIsTheSnapshotWithinAMillimetrePerSecond) {
  const auto snapshot = std::make_shared<const Snapshot>(
      tests::made_up_forecast({.columns = 4, .levels = 12, .members = 5}));
  const Field field(snapshot);
  Rng random(5, "tests/field");
  double worst = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto c = static_cast<std::size_t>(random.uniform(0, 4));
    const auto member = static_cast<std::size_t>(random.uniform(0, 5));
    const UtcTime time =
        snapshot->time.front() + minutes(static_cast<int>(random.uniform(0, 4320)));
    const std::array depth{random.uniform(0, snapshot->columns[c].water_depth_m)};
    std::array<CurrentSample, 1> exact;
    tests::reference_profile(*snapshot, c, time, depth, exact, member);
    const GeoPoint& p = snapshot->columns[c].point;
    const CurrentSample found =
        field.current({p.longitude_deg(), p.latitude_deg(), depth[0], time}, member);
    ASSERT_EQ(has_value(found.status), has_value(exact[0].status));
    worst = std::max(worst, std::abs(found.velocity_m_s - exact[0].velocity_m_s));
    EXPECT_NEAR(found.sigma_m_s, exact[0].sigma_m_s, 1e-6);
  }
  RecordProperty("worst_m_s", std::to_string(worst));
  EXPECT_LT(worst, 2e-6) << "tabulated in single precision; conventions.md allows 1e-3";
}

TEST(Field, OutsideIsAStatusForEveryQuantity) {
  const Field field = field_of(made());
  const auto status = [&](const Place& p) { return field.current(p).status; };
  EXPECT_EQ(status(place(0.97, 52.05, 5, 1)), SampleStatus::outside_area);
  EXPECT_EQ(status(place(1.05, 52.05, 5, -0.1)), SampleStatus::outside_time);
  EXPECT_EQ(status(place(1.05, 52.05, 5, 24.1)), SampleStatus::outside_time);
  EXPECT_EQ(status(place(1.05, 52.05, -0.1, 1)), SampleStatus::above_surface);
  EXPECT_EQ(status(place(1.05, 52.05, std::nan(""), 1)), SampleStatus::above_surface);
  EXPECT_EQ(status(place(1.05, 52.05, 31.1, 1)), SampleStatus::below_bed);
  EXPECT_EQ(status(place(1.05, 52.05, 30.9, 24)), SampleStatus::ok);
  EXPECT_EQ(status(place(std::nan(""), 52.05, 5, 1)), SampleStatus::outside_area);
  const std::array places{place(0.9, 52, 10, 1), place(1, 52, 0.5, 1), place(1, 52, 301, 1),
                          place(1, 52, 10, 30)};
  std::array<WindSample, 4> wind;
  field.sample_wind(places, wind);
  EXPECT_EQ(wind[0].status, SampleStatus::outside_area);
  EXPECT_EQ(wind[1].status, SampleStatus::outside_area);
  EXPECT_EQ(wind[2].status, SampleStatus::outside_area);
  EXPECT_EQ(wind[3].status, SampleStatus::outside_time);
  std::array<SeaSample, 4> sea;
  field.sample_sea(places, sea);
  EXPECT_EQ(sea[0].status, SampleStatus::outside_area);
  EXPECT_EQ(sea[3].status, SampleStatus::outside_time);
  EXPECT_EQ(sea[3].sea.significant_height_m, 0);
  EXPECT_NE(field.range().text().find("2025-03-10T00:00:00Z"), std::string::npos);
}

TEST(Field, BetweenBedsTheDeeperColumnAloneSpeaksBelowTheShallower) {
  const Field field = field_of(made());
  // Between 30 m and 31 m of water, in the middle: the bed is at 30.5 m.
  std::array<BedSample, 1> bed;
  const std::array here{place(1.025, 52, 0, 0)};
  field.sample_bed(here, bed);
  EXPECT_NEAR(bed[0].water_depth_m, 30.5, 1e-9);
  const CurrentSample low = field.current(place(1.025, 52, 30.3, 2));
  ASSERT_EQ(low.status, SampleStatus::ok);
  // The deeper column's deepest level, 29.5 m, holds to its bed.
  EXPECT_NEAR(low.velocity_m_s.real(), plane(1.05, 52, 29.5, 2).real(), 1e-6);
  EXPECT_EQ(field.current(place(1.025, 52, 30.6, 2)).status, SampleStatus::below_bed);
}

TEST(Field, LandIsLandAndTheShoreTakesTheWetSide) {
  const Field field = field_of(made(true));
  EXPECT_EQ(field.current(place(1.05, 52, 5, 1)).status, SampleStatus::ok);
  EXPECT_EQ(field.current(place(1.0, 52, 5, 1)).status, SampleStatus::outside_area)
      << "beyond half a cell of the westernmost water";
}

TEST(Field, AValueMissingForAnHourIsMissingAroundItAndNowhereElse) {
  Snapshot s = made();
  for (std::size_t k = 0; k < s.depth_m.size(); ++k)
    s.columns[5].current_status[10 * s.depth_m.size() + k] = SampleStatus::missing;
  const Field field = field_of(s);
  const GeoPoint p = s.columns[5].point;
  const auto status = [&](double hour, double east_deg) {
    return field.current(place(p.longitude_deg() + east_deg, p.latitude_deg(), 5, hour)).status;
  };
  EXPECT_EQ(status(9.5, 0), SampleStatus::missing);
  EXPECT_EQ(status(10, 0.02), SampleStatus::missing);
  EXPECT_EQ(status(11, 0), SampleStatus::ok);
  EXPECT_EQ(status(9, 0.01), SampleStatus::ok);
  EXPECT_EQ(status(10, 0.05), SampleStatus::ok) << "the neighbour has its value";
}

TEST(Field, WindGrowsWithHeightAsTheLogarithmSays) {
  const Field field = field_of(made());
  const std::array places{place(1.05, 52, 10, 10), place(1.05, 52, 90, 10)};
  std::array<WindSample, 2> wind;
  field.sample_wind(places, wind);
  EXPECT_NEAR(wind[0].velocity_m_s.real(), 6.0, 1e-12);
  // U10 = 10 gives U90 = 12.030748 with z0 = 0.2 mm (fields/docs/physics.md §9).
  EXPECT_NEAR(std::abs(wind[1].velocity_m_s) / std::abs(wind[0].velocity_m_s), 1.2030748, 1e-6);
}

TEST(Field, DirectionsTurnTheShortWay) {
  const Field field = field_of(made());
  const std::array places{place(1.05, 52, 0, 0.5)};
  std::array<SeaSample, 1> sea;
  field.sample_sea(places, sea);
  ASSERT_EQ(sea[0].status, SampleStatus::ok);
  // 350 degrees at 1 m and 10 degrees at 1.05 m, by energy: just east of north.
  const double expected =
      std::atan2((1.1025 - 1) * std::sin(0.1745329), (1.1025 + 1) * std::cos(0.1745329)) * 57.29578;
  EXPECT_NEAR(sea[0].sea.from_direction_deg, expected, 1e-4);
  EXPECT_NEAR(sea[0].sea.significant_height_m, 1.025, 1e-12);
}

TEST(Field, SeasWithoutANumberAreMissing) {
  Snapshot s = made();
  for (ForecastColumn& c : s.columns)
    for (SeaState& sea : c.sea) sea.peak_period_s = std::numeric_limits<double>::quiet_NaN();
  for (ForecastColumn& c : s.columns) c.wind_m_s.clear();
  const Field field = field_of(s);
  const std::array places{place(1.05, 52, 10, 3)};
  std::array<SeaSample, 1> sea;
  field.sample_sea(places, sea);
  EXPECT_EQ(sea[0].status, SampleStatus::missing);
  EXPECT_NEAR(sea[0].sea.significant_height_m, 1.15, 1e-12) << "a height is known nevertheless";
  EXPECT_TRUE(std::isnan(sea[0].sea.peak_period_s));
  s.columns.front().sea.clear();
  field_of(s).sample_sea(std::array{place(1, 52, 10, 3)}, sea);
  EXPECT_EQ(sea[0].status, SampleStatus::missing);
  EXPECT_TRUE(std::isnan(sea[0].sea.significant_height_m)) << "never a silent zero";
  std::array<WindSample, 1> wind;
  field.sample_wind(places, wind);
  EXPECT_EQ(wind[0].status, SampleStatus::missing);
}

TEST(Field, UnevenStampsAreSampledAllTheSame) {
  Snapshot s = made();
  s.time[24] = s.time[23] + hours(3);
  const Field field = field_of(s);
  const CurrentSample found = field.current(place(1.05, 52, 5, 24.5));  // halfway from 23 to 26
  ASSERT_EQ(found.status, SampleStatus::ok);
  EXPECT_NEAR(found.velocity_m_s.real(), plane(1.05, 52, 5, 23.5).real(), 1e-6);
}

TEST(Field, AProfileIsTheSamplesOfItsDepths) {
  const Field field = field_of(made());
  const std::array depths{0.0, 4.0, 17.0, 29.9, 33.0};
  std::array<CurrentSample, 5> profile;
  field.sample_profile(1.07, 52.03, start + minutes(95), depths, profile);
  for (std::size_t k = 0; k < depths.size(); ++k) {
    const CurrentSample alone = field.current({1.07, 52.03, depths[k], start + minutes(95)});
    EXPECT_EQ(profile[k].velocity_m_s, alone.velocity_m_s);
    EXPECT_EQ(profile[k].status, alone.status);
  }
}

TEST(Field, AMillisecondFromAMissingHourIsMissingAndNeverLouderThanTheWater) {
  Snapshot s = made();
  for (std::size_t k = 0; k < s.depth_m.size(); ++k)
    s.columns[5].current_status[10 * s.depth_m.size() + k] = SampleStatus::missing;
  const Field field = field_of(s);
  const GeoPoint p = s.columns[5].point;
  for (int ms = 1; ms < 40; ++ms) {
    const Place after{p.longitude_deg(), p.latitude_deg(), 5,
                      start + hours(9) + std::chrono::milliseconds(ms)};
    EXPECT_EQ(field.current(after).status, SampleStatus::missing) << ms;
    const Place before{p.longitude_deg(), p.latitude_deg(), 5,
                       start + hours(11) - std::chrono::milliseconds(ms)};
    EXPECT_EQ(field.current(before).status, SampleStatus::missing) << ms;
  }
}

TEST(Field, RoundingNeverBringsAMissingLevelToSpeech) {
  Snapshot s = made();
  for (std::size_t c = 0; c < s.columns.size(); ++c)
    for (std::size_t t = 0; t < s.time.size(); ++t)
      if ((t + c) % 3 == 0)
        s.columns[c].current_status[t * s.depth_m.size() + 2] = SampleStatus::missing;
  const Field field = field_of(s);
  Rng random(6, "tests/field");
  for (int i = 0; i < 20000; ++i) {
    // Close to levels and stamps, where the shares nearly vanish.
    const double depth = std::abs(8 + random.normal() * std::pow(10, random.uniform(-7, 0)));
    const double hour = std::clamp(
        std::round(random.uniform(0, 24)) + random.normal() * std::pow(10, random.uniform(-6, 0)),
        0.0, 24.0);
    const Place p = place(random.uniform(1, 1.15), random.uniform(52, 52.1), depth, hour);
    const CurrentSample found = field.current(p);
    if (!has_value(found.status)) continue;
    EXPECT_LT(std::abs(found.velocity_m_s - plane(p.longitude_deg, p.latitude_deg, depth, hour)),
              0.7)
        << "at most the neighbours' value, " << depth << " m, hour " << hour;
  }
}

TEST(Field, AValueThatIsNoNumberIsMissingWhateverItsStatusSays) {
  Snapshot s = made();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  s.columns[5].current_m_s[10 * s.depth_m.size()] = {nan, 0};
  s.columns[6].current_sigma_m_s[10 * s.depth_m.size()] = nan;
  const Field field = field_of(s);
  for (const std::size_t c : {5U, 6U}) {
    const GeoPoint p = s.columns[c].point;
    const CurrentSample found = field.current(place(p.longitude_deg(), p.latitude_deg(), 0, 10));
    EXPECT_EQ(found.status, SampleStatus::missing);
    EXPECT_EQ(found.velocity_m_s, Horizontal{});
  }
}

TEST(Field, OnAStampTheHourBeforeHasNoSay) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int hour = 1; hour <= 72; ++hour) {
    Snapshot s = made();
    s.time.clear();
    for (int t = 0; t <= 72; ++t) s.time.push_back(start + hours(t));
    ForecastColumn c = s.columns[0];
    c.current_m_s.clear();
    c.current_sigma_m_s.clear();
    c.current_status.clear();
    c.wind_m_s.assign(73, {5, 1});
    c.sea.assign(73, {1, 6, 200});
    c.wind_m_s[static_cast<std::size_t>(hour) - 1] = {nan, nan};
    c.sea[static_cast<std::size_t>(hour) - 1].significant_height_m = nan;
    s.columns = {c};
    const Field field = field_of(s);
    const std::array here{place(1, 52, 10, hour)};
    std::array<WindSample, 1> wind;
    field.sample_wind(here, wind);
    EXPECT_EQ(wind[0].status, SampleStatus::ok) << hour;
    std::array<SeaSample, 1> sea;
    field.sample_sea(here, sea);
    EXPECT_EQ(sea[0].status, SampleStatus::ok) << hour;
  }
}

TEST(Field, OverAFlatBedTheBedItselfIsWater) {
  Snapshot s = made();
  for (ForecastColumn& c : s.columns) c.water_depth_m = 31.3;
  const Field field = field_of(s);
  Rng random(7, "tests/field");
  for (int i = 0; i < 2000; ++i) {
    const Place p = place(random.uniform(1, 1.15), random.uniform(52, 52.1), 31.3, 3);
    EXPECT_EQ(field.current(p).status, SampleStatus::ok)
        << p.longitude_deg << " " << p.latitude_deg;
  }
  EXPECT_EQ(field.current(place(1.05, 52, 31.30001, 3)).status, SampleStatus::below_bed);
}

TEST(Field, AnUnknownBedIsNoWater) {
  Snapshot s = made();
  s.columns = {s.columns[0]};
  s.columns[0].water_depth_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(field_of(s).current(place(1, 52, 5, 1)).status, SampleStatus::below_bed);
}

TEST(Field, ACalmSeaKeepsTheDirectionThatTheForecastGivesIt) {
  Snapshot s = made();
  for (ForecastColumn& c : s.columns)
    for (SeaState& sea : c.sea) sea = {0, 3, 240};
  const Field field = field_of(s);
  const std::array here{place(1.02, 52.03, 0, 7.3)};
  std::array<SeaSample, 1> sea;
  field.sample_sea(here, sea);
  ASSERT_EQ(sea[0].status, SampleStatus::ok);
  EXPECT_NEAR(sea[0].sea.from_direction_deg, 240, 1e-9) << "and not north";
}

TEST(Field, BetweenCalmAndASeaThePeriodIsThatOfTheSea) {
  Snapshot s = made();
  for (ForecastColumn& c : s.columns) {
    for (std::size_t t = 0; t < c.sea.size(); ++t)
      c.sea[t] = t < 7 ? SeaState{0, 0, 240} : SeaState{1, 4, 240};
  }
  const Field field = field_of(s);
  const std::array here{place(1.02, 52.03, 0, 3), place(1.02, 52.03, 0, 6.5)};
  std::array<SeaSample, 2> sea;
  field.sample_sea(here, sea);
  ASSERT_EQ(sea[0].status, SampleStatus::ok) << "calm is a value";
  EXPECT_EQ(sea[0].sea.significant_height_m, 0);
  EXPECT_EQ(sea[0].sea.peak_period_s, 0);
  EXPECT_NEAR(sea[1].sea.significant_height_m, 0.5, 1e-12);
  EXPECT_NEAR(sea[1].sea.peak_period_s, 4, 1e-12) << "at half of it waves would stand too steep";
}

TEST(Field, ASnapshotWhoseArraysDoNotFitIsABugAndNotAMemoryError) {
  Snapshot s = made();
  s.columns[3].current_sigma_m_s.pop_back();
  EXPECT_THROW(field_of(s), ContractViolation);
  s = made();
  s.columns[3].current_status.clear();
  EXPECT_THROW(field_of(s), ContractViolation);
  s = made();
  s.columns[3].wind_m_s.pop_back();
  EXPECT_THROW(field_of(s), ContractViolation);
  s = made();
  s.columns[3].sea.pop_back();
  EXPECT_THROW(field_of(s), ContractViolation);
}

}  // namespace
}  // namespace slackwater::field_test
