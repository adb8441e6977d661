#include "twin/traffic/alarms.h"

#include <gtest/gtest.h>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"
#include "twin/traffic/traffic_picture.h"

namespace slackwater::tests::alarms_test {
namespace {

using namespace twin;

const AlarmLimits limits{500, 600, 1.25};
const MovingPoint own{{0, 0, 0}, {0, 0, 0}};

/// Comes from the north at 5 m/s and passes `miss_m` to the east.
Contact comer(std::uint32_t id, double distance_m, double miss_m) {
  return {id, {{distance_m, miss_m, 0}, {-5, 0, 0}}};
}

TEST(Alarms, NeedBothANearAndASoonApproach) {
  EXPECT_EQ(alarms(own, std::vector{comer(1, 2999, 499)}, limits).size(), 1U);
  EXPECT_EQ(alarms(own, std::vector{comer(1, 3001, 499)}, limits).size(), 0U) << "600.2 s away";
  EXPECT_EQ(alarms(own, std::vector{comer(1, 2999, 501)}, limits).size(), 0U) << "passes clear";
  EXPECT_EQ(alarms(own, std::vector{comer(1, -10, 499)}, limits).size(), 1U)
      << "past, but still near";
  EXPECT_EQ(alarms(own, std::vector{comer(1, -600, 0)}, limits).size(), 0U) << "past and away";
}

TEST(Alarms, AContactThatIsNearAlreadyIsOneHoweverSlowlyItComesNearer) {
  const Contact slow{1, {{499, 0, 0}, {-0.1, 0, 0}}};  // there in 83 minutes
  EXPECT_EQ(alarms(own, std::vector{slow}, limits).size(), 1U);
  const Contact outside{1, {{501, 0, 0}, {-0.1, 0, 0}}};
  EXPECT_EQ(alarms(own, std::vector{outside}, limits).size(), 0U);
}

TEST(Alarms, SayWhenAndHowNear) {
  const auto found =
      alarms(own, std::vector{comer(7, 2500, 300), comer(8, 9000, 0), comer(9, 500, 0)}, limits);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].id, 7U);
  EXPECT_EQ(found[0].status, AlarmStatus::raised);
  EXPECT_NEAR(found[0].approach.time_s, 500, 1e-9);
  EXPECT_NEAR(found[0].approach.distance_m, 300, 1e-9);
  EXPECT_EQ(found[1].id, 9U);
}

TEST(Alarms, HoldUntilTheWiderLimitsAreLeft) {
  const auto first = alarms(own, std::vector{comer(1, 2500, 499)}, limits);
  const auto wider = alarms(own, std::vector{comer(1, 2400, 624)}, limits, first);
  ASSERT_EQ(wider.size(), 1U);
  EXPECT_EQ(wider[0].status, AlarmStatus::held);
  EXPECT_TRUE(alarms(own, std::vector{comer(1, 2300, 626)}, limits, wider).empty());
  EXPECT_TRUE(alarms(own, std::vector{comer(1, 2400, 624)}, limits).empty()) << "without a past";
}

TEST(Alarms, NoiseInTheReportsRingsOnce) {
  const auto rings = [](double hold_factor) {
    Rng rng(5, "tests/alarms");
    AlarmLimits noisy = limits;
    noisy.hold_factor = hold_factor;
    std::vector<Alarm> now;
    int count = 0;
    for (int i = 0; i < 100; ++i) {
      now = alarms(own, std::vector{comer(1, 2500 - 20 * i, 500 + 20 * rng.normal())}, noisy, now);
      for (const Alarm& alarm : now) count += alarm.status == AlarmStatus::raised ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(rings(1.25), 1);
  EXPECT_GT(rings(1), 10);
}

TEST(Alarms, AContactThatFallsSilentIsSaidOnceToBeLost) {
  const auto first = alarms(own, std::vector{comer(1, 2500, 0)}, limits);
  const auto lost = alarms(own, {}, limits, first);
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_EQ(lost[0].status, AlarmStatus::lost);
  EXPECT_NEAR(lost[0].approach.time_s, 500, 1e-9) << "the last known";
  EXPECT_TRUE(alarms(own, {}, limits, lost).empty());
  const auto back = alarms(own, std::vector{comer(1, 2000, 0)}, limits, lost);
  ASSERT_EQ(back.size(), 1U);
  EXPECT_EQ(back[0].status, AlarmStatus::raised);
}

TEST(Alarms, LimitsThatAreNoneAreRefused) {
  EXPECT_THROW((void)alarms(own, {}, {0, 600, 1.25}), ContractViolation);
  EXPECT_THROW((void)alarms(own, {}, {500, -1, 1.25}), ContractViolation);
  EXPECT_THROW((void)alarms(own, {}, {500, 600, 0.9}), ContractViolation);
}

TEST(TrafficPicture, HoldsWhoIsThereAndNamesWhoIsSilent) {
  const auto straight = [](double from_s, double to_s) {
    return Track({{from_s, {from_s, 0, 0}, {}, {}}, {to_s, {to_s, 0, 0}, {}, {}}});
  };
  const std::vector<TrafficVessel> vessels{{1, "EARLY", {}, {}, straight(0, 100)},
                                           {2, "SILENT", {}, {}, straight(0, 1000)},
                                           {3, "", 12.0, 4.0, straight(140, 300)}};
  TrafficPicture picture;
  const TrackRule rule{TrackCurve::smooth, 360};
  populate(vessels, 50, rule, picture);
  ASSERT_EQ(picture.contacts.size(), 1U);
  EXPECT_EQ(picture.contacts[0].id, 1U);
  EXPECT_DOUBLE_EQ(picture.contacts[0].motion.position_m.x, 50);
  EXPECT_DOUBLE_EQ(picture.contacts[0].motion.velocity_m_s.x, 1);
  EXPECT_EQ(picture.unheard, std::vector<std::uint32_t>{2});
  populate(vessels, 200, rule, picture);
  ASSERT_EQ(picture.contacts.size(), 1U);
  EXPECT_EQ(picture.contacts[0].id, 3U);
  populate(vessels, 2000, rule, picture);
  EXPECT_TRUE(picture.contacts.empty() && picture.unheard.empty());
}

}  // namespace
}  // namespace slackwater::tests::alarms_test
