// Where the water of a forecast ends.
#include "fields/service/bed_rule.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/service/field.h"
#include "tests/support/made_up_forecast.h"

namespace slackwater::bed_rule_test {
namespace {

/// Two hours of a column whose product is wet down to `wet_m` and says U = depth + 100 hour.
Snapshot column_of(double bed_m, double wet_m, std::vector<double> depth_m) {
  Snapshot s;
  s.depth_m = std::move(depth_m);
  s.columns.resize(1);
  s.members = 2;
  ForecastColumn& c = s.columns[0];
  c.point = GeoPoint::from_degrees(52, 3);
  c.water_depth_m = bed_m;
  for (int t = 0; t < 2; ++t) {
    s.time.push_back(UtcTime(std::chrono::hours(t)));
    for (const double depth : s.depth_m) {
      const bool wet = depth <= wet_m;
      c.current_m_s.emplace_back(wet ? depth + 100 * t : 0, 0);
      c.member_m_s.emplace_back(wet ? depth + 100 * t : 0, 1);
      c.current_sigma_m_s.push_back(wet ? 0.1 : 0);
      c.current_status.push_back(wet ? SampleStatus::ok : SampleStatus::below_bed);
    }
  }
  return s;
}

CurrentSample sampled(const Snapshot& s, double depth_m, std::size_t member = 0) {
  return Field(std::make_shared<const Snapshot>(s))
      .current({3, 52, depth_m, s.time.back()}, member);
}

/// The file's levels and the sampler at them say the same.
void expect_one_answer(const Snapshot& s) {
  for (std::size_t c = 0; c < s.columns.size(); ++c) {
    const ForecastColumn& column = s.columns[c];
    const Field field(std::make_shared<const Snapshot>(s));
    for (std::size_t k = 0; k < s.depth_m.size(); ++k) {
      SCOPED_TRACE(s.depth_m[k]);
      const GeoPoint& p = column.point;
      const CurrentSample found =
          field.current({p.longitude_deg(), p.latitude_deg(), s.depth_m[k], s.time.front()});
      EXPECT_EQ(found.status, column.current_status[k]);
      EXPECT_NEAR(found.velocity_m_s.real(), column.current_m_s[k].real(), 1e-6);
    }
  }
}

TEST(BedRule, NothingIsServedBelowTheBedThatTheSiteStates) {
  Snapshot s = column_of(8, 30, {0, 5, 10, 20, 30});
  keep_to_bed(s.columns[0], s.depth_m);
  const std::vector<SampleStatus>& status = s.columns[0].current_status;
  for (const std::size_t t : {0U, 5U}) {
    EXPECT_EQ(status[t + 1], SampleStatus::ok);
    for (const std::size_t k : {2U, 3U, 4U}) {
      EXPECT_EQ(status[t + k], SampleStatus::below_bed);
      EXPECT_EQ(s.columns[0].current_m_s[t + k], Horizontal());
      EXPECT_EQ(s.columns[0].member_m_s[t + k], Horizontal());
    }
  }
  EXPECT_EQ(sampled(s, 7.9).status, SampleStatus::ok);
  EXPECT_EQ(sampled(s, 8.1).status, SampleStatus::below_bed);
  expect_one_answer(s);
}

TEST(BedRule, BelowTheProductsOwnBedItsDeepestValueIsCarriedToTheSitesAndSaysSo) {
  Snapshot s = column_of(60, 30, {0, 10, 20, 30, 40, 50, 75});
  keep_to_bed(s.columns[0], s.depth_m);
  const ForecastColumn& c = s.columns[0];
  EXPECT_EQ(c.current_status[3], SampleStatus::ok);
  for (const std::size_t k : {4U, 5U}) {
    EXPECT_EQ(c.current_status[7 + k], SampleStatus::carried);
    EXPECT_EQ(c.current_m_s[7 + k], Horizontal(130, 0));
    EXPECT_EQ(c.member_m_s[7 + k], Horizontal(130, 1));
    EXPECT_EQ(c.current_sigma_m_s[7 + k], 0.1);
  }
  EXPECT_EQ(c.current_status[6], SampleStatus::below_bed);
  for (const double depth : {36.5, 40.0, 45.0, 60.0}) {
    EXPECT_EQ(sampled(s, depth).status, SampleStatus::carried) << depth;
    EXPECT_EQ(sampled(s, depth).velocity_m_s.real(), 130) << depth;
    EXPECT_EQ(sampled(s, depth, 1).status, SampleStatus::carried) << depth;
  }
  EXPECT_EQ(sampled(s, 30).status, SampleStatus::ok);
  EXPECT_EQ(sampled(s, 60.1).status, SampleStatus::below_bed);
  expect_one_answer(s);
}

TEST(BedRule, WithinTheToleranceTheDeepestValueHolds) {
  // The last level of the file: 20 % deeper, at least 5 m.
  const Snapshot deep = column_of(200, 100, {0, 50, 100});
  EXPECT_EQ(sampled(deep, 119.9).status, SampleStatus::ok);
  EXPECT_EQ(sampled(deep, 120.1).status, SampleStatus::carried);
  const Snapshot shallow = column_of(20, 10, {0, 10});
  EXPECT_EQ(sampled(shallow, 14.9).status, SampleStatus::ok);
  EXPECT_EQ(sampled(shallow, 15.1).status, SampleStatus::carried);
  // A level that the product has dry ends it sooner.
  const Snapshot masked = column_of(60, 30, {0, 30, 33, 75});
  EXPECT_EQ(sampled(masked, 32.9).status, SampleStatus::ok);
  EXPECT_EQ(sampled(masked, 33.0).status, SampleStatus::carried);
}

TEST(BedRule, DoneTwiceItIsDoneOnce) {
  for (const double bed_m : {8.0, 22.0, 30.0, 31.0, 60.0, 100.0}) {
    Snapshot once = column_of(bed_m, 30, {0, 10, 20, 30, 31, 40, 50, 75});
    keep_to_bed(once.columns[0], once.depth_m);
    ForecastColumn twice = once.columns[0];
    keep_to_bed(twice, once.depth_m);
    EXPECT_EQ(twice.current_status, once.columns[0].current_status) << bed_m;
    EXPECT_EQ(twice.current_m_s, once.columns[0].current_m_s) << bed_m;
    expect_one_answer(once);
  }
}

TEST(BedRule, AHourWithoutAValueIsCarriedAsThat) {
  Snapshot s = column_of(60, 30, {0, 30, 50});
  s.columns[0].current_status[4] = SampleStatus::missing;  // 30 m, the second hour
  keep_to_bed(s.columns[0], s.depth_m);
  EXPECT_EQ(s.columns[0].current_status[2], SampleStatus::carried);
  EXPECT_EQ(s.columns[0].current_status[5], SampleStatus::missing);
  EXPECT_EQ(sampled(s, 50).status, SampleStatus::missing);
}

TEST(BedRule, WhereTheProductKnowsTheWaterNothingChanges) {
  const Snapshot made = tests::made_up_forecast({.columns = 2, .levels = 12, .members = 3});
  for (const ForecastColumn& column : made.columns) {
    ForecastColumn kept = column;
    keep_to_bed(kept, made.depth_m);
    EXPECT_EQ(kept.current_status, column.current_status);
    EXPECT_EQ(kept.current_m_s, column.current_m_s);
    EXPECT_EQ(kept.member_m_s, column.member_m_s);
  }
}

TEST(BedRule, WithoutACurrentThereIsNothingToCarry) {
  ForecastColumn column;
  column.water_depth_m = 60;
  EXPECT_TRUE(std::isinf(known_to_m(column, std::vector<double>{0, 30})));
  keep_to_bed(column, std::vector<double>{0, 30});
  EXPECT_TRUE(column.current_status.empty());
}

/// Between two columns the depth to which the water is known is interpolated as the bed is.
TEST(BedRule, BetweenColumnsTheKnownWaterIsInterpolated) {
  Snapshot s = column_of(60, 30, {0, 10, 20, 30});
  ForecastColumn deeper = s.columns[0];
  deeper.point = GeoPoint::from_degrees(52, 3.05);
  for (const std::size_t o : {3U, 7U}) s.columns[0].current_status[o] = SampleStatus::below_bed;
  s.columns.push_back(deeper);  // known to 36 m; the first to 25 m
  const Field field(std::make_shared<const Snapshot>(s));
  const auto status = [&](double depth_m) {
    return field.current({3.025, 52, depth_m, s.time.front()}).status;
  };
  EXPECT_EQ(status(30.4), SampleStatus::ok);
  EXPECT_EQ(status(30.6), SampleStatus::carried);
}

}  // namespace
}  // namespace slackwater::bed_rule_test
