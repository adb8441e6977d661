#include <cmath>
#include <limits>

#include "api/door/dds/message/graph.h"
#include "api/door/dds/message/services.h"
#include "tests/api/door/dds/cdr_by_hand.h"
#include "tests/api/door/dds/site_for_tests.h"

// What a site tells, byte by byte.

namespace slackwater::dds::site_bytes_test {
namespace {

using tests::HandReader;
using tests::hex;
using tests::SiteForTests;

const std::string instance = "test 2025-06-01 issued 2025-06-02T05:00:00Z";

TEST(BytesOfASite, ClockIsTwoNumbers) {
  EXPECT_EQ(clock({1, 500'000'000}), hex("00 01 00 00  01 00 00 00  00 65 CD 1D"));
}

TEST(BytesOfASite, TideLevelIsOneNumber) {
  const SiteForTests site;
  EXPECT_EQ(tide_level(site.water(), site.time), hex("00 01 00 00  00 00 00 00 00 00 F4 3F"));
  EXPECT_EQ(tide_level(site.water(), site.time + std::chrono::hours(100)).size(), 12U);
  HandReader late(tide_level(site.water(), site.time + std::chrono::hours(100)));
  EXPECT_TRUE(std::isnan(late.real())) << "no number where there is none";
}

TEST(BytesOfASite, ProfileIsTheForecastDownToTheBed) {
  const SiteForTests site;
  HandReader read(current_profile(site.water(), site.time, {10, 20}));
  read.expect_header({10, 20}, "map");
  EXPECT_EQ(read.string(), instance);
  EXPECT_EQ(read.real(), 48.5);
  EXPECT_EQ(read.real(), -2.5);
  const auto sequence = [&] { return read.reals(read.count()); };
  EXPECT_EQ(sequence(), (std::vector<double>{0, 10}));  // 50 m is below the bed
  EXPECT_EQ(sequence(), (std::vector<double>{0.5, 0.25}));
  EXPECT_EQ(sequence(), (std::vector<double>{-0.125, -0.25}));
  constexpr double sigma = 0.125, z = 1.2815515655446004;  // of the p90 of a normal
  for (const double sign : {-1, 1}) {
    const std::vector<double> east = sequence();
    ASSERT_EQ(east.size(), 2U);
    EXPECT_NEAR(east[0], 0.5 + sign * z * sigma, 1e-12);
    EXPECT_NEAR(east[1], 0.25 + sign * z * sigma, 1e-12);
  }
  for (const double sign : {-1, 1}) {
    const std::vector<double> north = sequence();
    ASSERT_EQ(north.size(), 2U);
    EXPECT_NEAR(north[0], -0.125 + sign * z * sigma, 1e-12);
    EXPECT_NEAR(north[1], -0.25 + sign * z * sigma, 1e-12);
  }
  read.expect_end();
}

TEST(BytesOfASite, OutsideTheForecastTheProfileIsEmpty) {
  const SiteForTests site;
  HandReader read(current_profile(site.water(), site.time + std::chrono::hours(100), {10, 20}));
  read.expect_header({10, 20}, "map");
  (void)read.string();
  (void)read.reals(2);
  for (int i = 0; i < 7; ++i) EXPECT_EQ(read.count(), 0U) << i;
  read.expect_end();
}

TEST(BytesOfASite, ReplyOfAQueryHoldsTheProfileBehindTwoFields) {
  const SiteForTests site;
  HandReader read(profile_reply(site.water(), site.time, {10, 20}));
  EXPECT_EQ(read.octet(), 1);
  EXPECT_EQ(read.string(), "");
  read.expect_header({10, 20}, "map");
  EXPECT_EQ(read.string(), instance);
  EXPECT_EQ(read.reals(2), (std::vector<double>{48.5, -2.5}));
  for (int i = 0; i < 7; ++i) EXPECT_EQ(read.reals(read.count()).size(), 2U) << i;
  read.expect_end();

  HandReader refused(profile_refusal("outside the area"));
  EXPECT_EQ(refused.octet(), 0);
  EXPECT_EQ(refused.string(), "outside the area");
  refused.expect_header({}, "");
}

TEST(BytesOfASite, WindIsTowardsEastAndNorth) {
  const SiteForTests site;
  HandReader read(wind(site.water(), site.time, {10, 20}));
  read.expect_header({10, 20}, "map");
  EXPECT_EQ(read.reals(3), (std::vector<double>{8, -2, 0}));
  read.expect_end();
  HandReader late(wind(site.water(), site.time + std::chrono::hours(100), {10, 20}));
  late.expect_header({10, 20}, "map");
  for (const double number : late.reals(3)) EXPECT_TRUE(std::isnan(number));
}

TEST(BytesOfASite, WavesAreHeightPeriodAndWhereFrom) {
  SeaSample sea{{1.5, 7, 270}, SampleStatus::ok};
  HandReader read(wave(sea, {10, 20}));
  read.expect_header({10, 20}, "map");
  EXPECT_EQ(read.reals(3), (std::vector<double>{1.5, 7, 270}));
  read.expect_end();
  sea.status = SampleStatus::missing;
  HandReader none(wave(sea, {10, 20}));
  none.expect_header({10, 20}, "map");
  for (const double number : none.reals(3)) EXPECT_TRUE(std::isnan(number));
}

TEST(BytesOfASite, PowerHasALayoutOfOneDimension) {
  const double power_w[] = {5e6, 0, 2.5e6};
  HandReader read(turbine_power(power_w));
  EXPECT_EQ(read.count(), 1U);
  EXPECT_EQ(read.string(), "turbine");
  EXPECT_EQ(read.count(), 3U);  // size
  EXPECT_EQ(read.count(), 3U);  // stride
  EXPECT_EQ(read.count(), 0U);  // data_offset
  EXPECT_EQ(read.reals(read.count()), (std::vector<double>{5e6, 0, 2.5e6}));
  read.expect_end();
}

TEST(BytesOfASite, TargetsAreWhereTheySayTheyAre) {
  AisTarget target;
  target.mmsi = 227'000'001;
  target.name = "MARIE";
  target.point = GeoPoint::from_degrees(48.75, -2.25);
  target.speed_m_s = 5.5;
  target.course_deg = 90;
  target.cpa_m = std::numeric_limits<double>::quiet_NaN();
  target.tcpa_s = 60;
  HandReader read(ais_target(target, {10, 20}));
  read.expect_header({10, 20}, "map");
  EXPECT_EQ(read.count(), 227'000'001U);
  EXPECT_EQ(read.string(), "MARIE");
  EXPECT_NEAR(read.real(), 48.75, 1e-12);  // through radians
  EXPECT_NEAR(read.real(), -2.25, 1e-12);
  EXPECT_EQ(read.real(), 5.5);
  EXPECT_EQ(read.real(), 90);
  EXPECT_TRUE(std::isnan(read.real()));
  EXPECT_EQ(read.real(), 60);
  read.expect_end();
}

TEST(BytesOfASite, GraphNamesTheNodeAndItsEndpoints) {
  NodeEntities node;
  node.participant.fill(0x11);
  node.name = "slackwater";
  node.readers.resize(1);
  node.readers[0].fill(0x22);
  node.writers.resize(2);
  node.writers[0].fill(0x33);
  node.writers[1].fill(0x44);
  HandReader read(participant_entities(node));
  const auto expect_gid = [&](std::uint8_t byte) {
    for (int i = 0; i < 16; ++i) EXPECT_EQ(read.octet(), byte) << i;
  };
  expect_gid(0x11);
  EXPECT_EQ(read.count(), 1U);
  EXPECT_EQ(read.string(), "/");
  EXPECT_EQ(read.string(), "slackwater");
  EXPECT_EQ(read.count(), 1U);
  expect_gid(0x22);
  EXPECT_EQ(read.count(), 2U);
  expect_gid(0x33);
  expect_gid(0x44);
  read.expect_end();
}

TEST(StampOfMessages, IsTheTimeOfTheRun) {
  const UtcTime epoch = parse_utc("2025-06-02T06:00:00.250Z");
  EXPECT_EQ(stamp_of(epoch, 0), (Stamp{1'748'844'000, 250'000'000}));
  EXPECT_EQ(stamp_of(epoch, 1.75), (Stamp{1'748'844'002, 0}));
  EXPECT_EQ(stamp_of(epoch, 0.001), (Stamp{1'748'844'000, 251'000'000}));
  EXPECT_EQ(nanoseconds_of({2, 5}), 2'000'000'005);
  EXPECT_EQ(time_of(stamp_of(epoch, 1.75)), epoch + std::chrono::milliseconds(1750));
  EXPECT_EQ(time_of({1, 1'999'999}), UtcTime(std::chrono::milliseconds(1001)));
}

}  // namespace
}  // namespace slackwater::dds::site_bytes_test
