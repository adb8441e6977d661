#include "fields/service/snapshot.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace slackwater {
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

CurrentSample sample(const Snapshot& s, UtcTime time, double depth) {
  std::array<CurrentSample, 1> out;
  sample_profile(s, 0, time, std::array{depth}, out);
  return out[0];
}

TEST(SampleProfile, IsLinearInTimeAndDepth) {
  const CurrentSample found = sample(snapshot(), UtcTime(hours(1) + minutes(30)), 5.5);
  EXPECT_EQ(found.status, SampleStatus::ok);
  EXPECT_NEAR(found.velocity_m_s.real(), 5.5, 1e-12);
  EXPECT_NEAR(found.velocity_m_s.imag(), 1.5, 1e-12);
  EXPECT_NEAR(found.sigma_m_s, 0.15, 1e-12);
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

}  // namespace
}  // namespace slackwater
