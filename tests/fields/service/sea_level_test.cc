#include "fields/service/sea_level.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/service/field.h"
#include "tests/support/made_up_forecast.h"

namespace slackwater::sea_level_test {
namespace {

using std::chrono::hours;
using std::chrono::minutes;

/// M2 of Saint-Brieuc with the M4 that goes with it, by the hour.
double tide_m(double hour) {
  return 3.60 * std::cos(2 * constants::pi * hour / 12.4206012) +
         0.17 * std::cos(2 * constants::pi * hour / 6.2103006 - 1);
}

Snapshot snapshot_of(std::size_t members = 21) {
  Snapshot s = tests::made_up_forecast({.columns = 1, .hours = 48, .members = members});
  for (std::size_t t = 0; t < s.time.size(); ++t) {
    SeaLevel& level = s.columns[0].sea_level;
    level.level_m.push_back(tide_m(static_cast<double>(t)));
    level.sigma_m.push_back(0.1 + 0.01 * static_cast<double>(t));
    level.source.push_back(DataStatus::modelled);
  }
  return s;
}

SeaLevelSample level_of(const Snapshot& s, Duration after, std::size_t member = 0) {
  const Field field(std::make_shared<const Snapshot>(s));
  const Place place{s.columns[0].point.longitude_deg(), s.columns[0].point.latitude_deg(), 0,
                    s.time.front() + after};
  SeaLevelSample out;
  field.sample_sea_level({&place, 1}, {&out, 1}, member);
  return out;
}

TEST(SeaLevel, BetweenHoursIsTheTideToTwoMillimetresWhereALineIsADecimetreOff) {
  const Snapshot s = snapshot_of();
  double worst_m = 0, worst_of_line_m = 0;
  for (int minute = 0; minute <= 48 * 60; minute += 5) {
    const double hour = minute / 60.0;
    const SeaLevelSample at = level_of(s, minutes(minute));
    ASSERT_EQ(at.status, SampleStatus::ok) << minute;
    worst_m = std::max(worst_m, std::abs(at.level_m - tide_m(hour)));
    const double low = std::floor(hour);
    worst_of_line_m = std::max(
        worst_of_line_m,
        std::abs(tide_m(low) + (hour - low) * (tide_m(low + 1) - tide_m(low)) - tide_m(hour)));
    EXPECT_NEAR(at.sigma_m, 0.1 + 0.01 * hour, 1e-12);
  }
  EXPECT_LT(worst_m, 0.002);
  EXPECT_GT(worst_of_line_m, 0.1);
  std::printf("between hours: %.4f m off, a line %.3f m\n", worst_m, worst_of_line_m);
}

TEST(SeaLevel, APolynomialOfTheFifthDegreeComesBack) {
  const auto polynomial = [](double x) { return 1 - x + x * x * x / 7 + std::pow(x / 5, 5); };
  std::vector<double> values;
  for (int i = 0; i < 10; ++i) values.push_back(polynomial(i));
  for (std::size_t low = 0; low + 1 < values.size(); ++low)
    EXPECT_NEAR(smooth_between(values, {low, 0.3}), polynomial(static_cast<double>(low) + 0.3),
                1e-11);
  const std::vector<double> two{1, 3};
  EXPECT_DOUBLE_EQ(smooth_between(two, {0, 0.25}), 1.5) << "as many as there are";
}

TEST(SeaLevel, WithoutALevelIsMissingAndNeverZero) {
  Snapshot s = snapshot_of();
  EXPECT_EQ(level_of(s, hours(49)).status, SampleStatus::outside_time);
  EXPECT_EQ(level_of(s, hours(5), 21).status, SampleStatus::missing) << "no such member";
  s.columns[0].sea_level.level_m[5] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(level_of(s, hours(5)).status, SampleStatus::missing);
  EXPECT_EQ(level_of(s, minutes(4 * 60 + 30)).status, SampleStatus::missing);
  s.columns[0].sea_level = {};
  EXPECT_EQ(level_of(s, hours(5)).status, SampleStatus::missing);
  s.columns[0].sea_level.level_m = {1.0};
  EXPECT_THROW(level_of(s, hours(5)), ContractViolation);
}

TEST(SeaLevel, MembersAreOffByTheirShareOfTheSpreadInOppositePairs) {
  const Snapshot s = snapshot_of();
  const Snapshot more = snapshot_of(41);
  const double central_m = level_of(s, hours(10)).level_m;
  double squares = 0;
  for (std::size_t m = 1; m < 21; ++m) {
    const SeaLevelSample at = level_of(s, hours(10), m);
    EXPECT_EQ(at.sigma_m, 0);
    EXPECT_EQ(at.level_m, level_of(more, hours(10), m).level_m) << "whatever their number";
    const double off = (at.level_m - central_m) / 0.2;
    EXPECT_NEAR((level_of(s, hours(30), m).level_m - level_of(s, hours(30)).level_m) / 0.4, off,
                1e-9)
        << "its share lasts";
    if (m % 2 == 0) {
      EXPECT_NEAR(off, -(level_of(s, hours(10), m - 1).level_m - central_m) / 0.2, 1e-9);
    }
    squares += off * off;
  }
  EXPECT_GT(squares / 20, 0.4);  // a chi-square of ten: 0.4 to 1.9 in 95 of 100
  EXPECT_LT(squares / 20, 1.9);
}

TEST(SeaLevel, QuantilesAreThoseOfANormal) {
  const SeaLevelQuantiles q = quantiles_of(SeaLevelSample{1.0, 0.2, SampleStatus::ok});
  EXPECT_DOUBLE_EQ(q.p50_m, 1.0);
  EXPECT_NEAR(q.p90_m - 1.0, 0.2 * 1.2815515655446004, 1e-9);
  EXPECT_DOUBLE_EQ(q.p90_m - 1.0, 1.0 - q.p10_m);
}

}  // namespace
}  // namespace slackwater::sea_level_test
