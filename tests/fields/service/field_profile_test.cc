#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "fields/base/numbers/random.h"
#include "fields/service/field.h"
#include "tests/support/made_up_forecast.h"

// Profiles at the columns of a forecast: the vertical rule, and its members.

namespace slackwater::field_profile_test {
namespace {

using std::chrono::hours;
using std::chrono::minutes;

/// U = depth + i hour on three levels, the deepest of them below the bed.
Snapshot snapshot() {
  Snapshot s;
  s.depth_m = {1, 10, 40};
  s.columns.resize(1);
  ForecastColumn& c = s.columns[0];
  c.water_depth_m = 25;
  for (int t = 0; t < 4; ++t) {
    s.time.push_back(UtcTime(hours(t)));
    for (const double depth : s.depth_m) {
      c.current_m_s.emplace_back(depth, t);
      c.current_sigma_m_s.push_back(0.1 * t);
      c.current_status.push_back(depth > 25 ? SampleStatus::below_bed : SampleStatus::ok);
    }
  }
  return s;
}

/// At a column of a snapshot, through its field.
void sample_profile(const Field& field, std::size_t column, UtcTime time,
                    std::span<const double> depths_m, std::span<CurrentSample> out,
                    std::size_t member = 0) {
  const GeoPoint& point = field.snapshot().columns[column].point;
  field.sample_profile(point.longitude_deg(), point.latitude_deg(), time, depths_m, out, member);
}

Field field_of(const Snapshot& s) { return Field(std::make_shared<const Snapshot>(s)); }

CurrentSample sample(const Snapshot& s, UtcTime time, double depth) {
  std::array<CurrentSample, 1> out;
  sample_profile(field_of(s), 0, time, std::array{depth}, out);
  return out[0];
}

TEST(SampleProfile, IsLinearInTimeAndDepth) {
  const CurrentSample found = sample(snapshot(), UtcTime(hours(1) + minutes(30)), 5.5);
  EXPECT_EQ(found.status, SampleStatus::ok);
  EXPECT_NEAR(found.velocity_m_s.real(), 5.5, 1e-6);
  EXPECT_NEAR(found.velocity_m_s.imag(), 1.5, 1e-6);
  EXPECT_NEAR(found.sigma_m_s, 0.15, 1e-7);
}

TEST(SampleProfile, HoldsTheOutermostWetLevels) {
  EXPECT_EQ(sample(snapshot(), UtcTime(hours(2)), 0.0).velocity_m_s.real(), 1);
  EXPECT_EQ(sample(snapshot(), UtcTime(hours(2)), 24.0).velocity_m_s.real(), 10);
}

TEST(SampleProfile, OutsideIsAStatusNotANumber) {
  const Snapshot s = snapshot();
  EXPECT_EQ(sample(s, UtcTime(hours(2)), 26.0).status, SampleStatus::below_bed);
  EXPECT_EQ(sample(s, UtcTime(hours(2)), -1.0).status, SampleStatus::above_surface);
  EXPECT_EQ(sample(s, UtcTime(hours(2)), std::nan("")).status, SampleStatus::above_surface);
  EXPECT_EQ(sample(s, UtcTime(hours(4)), 5.0).status, SampleStatus::outside_time);
  EXPECT_EQ(sample(s, UtcTime(hours(-1)), 5.0).status, SampleStatus::outside_time);
  EXPECT_EQ(sample(s, UtcTime(hours(3)), 5.0).status, SampleStatus::ok)
      << "the last stamp belongs to the forecast";
}

/// Times and depths all over a forecast and somewhat beyond it.
template <typename Check>
void for_many_places(const Snapshot& s, Check check) {
  constexpr std::uint64_t seed = 5;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Rng random(seed, "tests/sample_profile");
  for (int i = 0; i < 500; ++i) {
    const auto minute = static_cast<int>(random.uniform(-60, 74 * 60));
    const std::array depths{random.uniform(-2, 60), random.uniform(0, 1), random.uniform(40, 50)};
    for (std::size_t c = 0; c < s.columns.size(); ++c)
      check(c, s.time.front() + minutes(minute), depths);
  }
}

TEST(SampleMember, EqualToTheCentralOneIsSampledToTheSameBits) {
  Snapshot s = tests::made_up_forecast({.columns = 2, .members = 3});
  for (ForecastColumn& c : s.columns) {
    c.member_m_s = c.current_m_s;
    c.member_m_s.insert(c.member_m_s.end(), c.current_m_s.begin(), c.current_m_s.end());
  }
  const Field field = field_of(s);
  int with_value = 0;
  for_many_places(s, [&](std::size_t column, UtcTime time, const auto& depths) {
    std::array<CurrentSample, 3> central;
    std::array<CurrentSample, 3> member;
    sample_profile(field, column, time, depths, central);
    for (const std::size_t number : {1U, 2U}) {
      sample_profile(field, column, time, depths, member, number);
      for (std::size_t i = 0; i < depths.size(); ++i) {
        EXPECT_EQ(member[i].status, central[i].status);
        EXPECT_EQ(member[i].velocity_m_s, central[i].velocity_m_s);
        EXPECT_EQ(member[i].sigma_m_s, 0) << "a member is one future";
        with_value += has_value(member[i].status) ? 1 : 0;
      }
    }
  });
  EXPECT_GT(with_value, 1000);
}

TEST(SampleMember, IsTheForecastMadeOfItAlone) {
  const Snapshot s = tests::made_up_forecast({.columns = 2, .members = 4});
  Snapshot alone = s;
  for (std::size_t c = 0; c < s.columns.size(); ++c) {
    const auto current = current_of_member(s.columns[c], 2);
    alone.columns[c].current_m_s.assign(current.begin(), current.end());
    ASSERT_NE(alone.columns[c].current_m_s, s.columns[c].current_m_s);
  }
  const Field whole = field_of(s);
  const Field of_it = field_of(alone);
  for_many_places(s, [&](std::size_t column, UtcTime time, const auto& depths) {
    std::array<CurrentSample, 3> expected;
    std::array<CurrentSample, 3> found;
    sample_profile(of_it, column, time, depths, expected);
    sample_profile(whole, column, time, depths, found, 2);
    for (std::size_t i = 0; i < depths.size(); ++i) {
      EXPECT_EQ(found[i].status, expected[i].status);
      EXPECT_EQ(found[i].velocity_m_s, expected[i].velocity_m_s);
    }
  });
}

TEST(SampleMember, ThatIsNotThereIsMissingNotTheCentralOne) {
  Snapshot s = tests::made_up_forecast({.members = 3});
  std::array<CurrentSample, 1> out;
  const auto status_of = [&](std::size_t member) {
    sample_profile(field_of(s), 0, s.time[5], std::array{3.0}, out, member);
    EXPECT_TRUE(has_value(out[0].status) || out[0].velocity_m_s == Horizontal{});
    return out[0].status;
  };
  EXPECT_EQ(status_of(2), SampleStatus::ok);
  EXPECT_EQ(status_of(3), SampleStatus::missing);
  EXPECT_EQ(status_of(std::numeric_limits<std::size_t>::max()), SampleStatus::missing);
  s.columns[0].member_m_s.clear();  // as where they were left in the file
  EXPECT_EQ(status_of(1), SampleStatus::missing);
  EXPECT_EQ(status_of(0), SampleStatus::ok);
}

}  // namespace
}  // namespace slackwater::field_profile_test
