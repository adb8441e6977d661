#include "fields/service/snapshot.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/made_up_forecast.h"

namespace slackwater::snapshot_test {
namespace {

TEST(WindOfMember, IsItsOwnOrTheSharedOne) {
  Snapshot s = tests::made_up_forecast({.members = 3});
  ForecastColumn& c = s.columns[0];
  const std::size_t times = s.time.size();
  EXPECT_EQ(wind_of_member(c, 0).data(), c.wind_m_s.data());
  EXPECT_EQ(wind_of_member(c, 2).data(), c.wind_member_m_s.data() + times);
  EXPECT_EQ(wind_of_member(c, 2).size(), times);
  EXPECT_TRUE(wind_of_member(c, 3).empty());
  c.wind_member_m_s.clear();
  EXPECT_EQ(wind_of_member(c, 2).data(), c.wind_m_s.data()) << "shared by all";
}

TEST(CurrentQuantiles, LeaveATenthOfANormalOnEitherSide) {
  CurrentSample central;
  central.velocity_m_s = {0.3, -0.1};
  central.sigma_m_s = 0.05;
  central.status = SampleStatus::ok;
  const CurrentQuantiles q = quantiles_of(central);
  EXPECT_EQ(q.p50_m_s, central.velocity_m_s);
  // Share of a normal below a value, by its definition.
  const auto below = [&](double value, double mean) {
    return 0.5 * std::erfc(-(value - mean) / central.sigma_m_s / std::sqrt(2.0));
  };
  EXPECT_NEAR(below(q.p10_m_s.real(), 0.3), 0.1, 1e-14);
  EXPECT_NEAR(below(q.p90_m_s.real(), 0.3), 0.9, 1e-14);
  EXPECT_NEAR(below(q.p10_m_s.imag(), -0.1), 0.1, 1e-14);
  EXPECT_NEAR(below(q.p90_m_s.imag(), -0.1), 0.9, 1e-14);
}

}  // namespace
}  // namespace slackwater::snapshot_test
