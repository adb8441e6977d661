// What is told of the vessels that a vehicle is alarmed about.
#include "api/door/live/topics/alarm_publisher.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/api/door/dds/cdr_by_hand.h"
#include "twin/traffic/laid_track.h"

namespace slackwater::tests::alarm_publisher_test {
namespace {

/// Keeps what is told on each channel.
struct Kept final : live::Outlet {
  struct Message {
    std::string topic;
    dds::Stamp stamp;
    dds::Bytes bytes;
  };
  void open(const bag::Channel& channel, live::Direction) override { channels.push_back(channel); }
  [[nodiscard]] bool wants(std::size_t) const override { return true; }
  void publish(std::size_t channel, const dds::Stamp& stamp, const dds::Bytes& bytes) override {
    messages.push_back({channels.at(channel).topic, stamp, bytes});
  }
  std::vector<bag::Channel> channels;
  std::vector<Message> messages;
};

nlohmann::json json_in(const dds::Bytes& message) {
  return nlohmann::json::parse(HandReader(message).string());
}

/// Both at 5 m/s on parallel ways 300 m apart, 10 km off: CPA 300 m, at 1000 s. TCPA falls below
/// 600.5 s after 399.5 s; past, the alarm is held while nearer than 1.25 x 500 m, to 1054.8 s.
TEST(AlarmPublisher, TellsWhenAnAlarmIsRaisedAndWhenItIsOver) {
  twin::TrafficVessel vessel;
  vessel.id = 219'000'001;
  vessel.name = "M\xd8N";  // no UTF-8
  vessel.track = twin::laid_track(
      std::vector<twin::Triple<double>>{{10'000, 300, 0}, {-20'000, 300, 0}}, 5, 0, 3600);
  const std::vector<twin::TrafficVessel> vessels{vessel};
  twin::TrafficWatch watch(vessels, {500, 600.5, 1.25}, {{}, {}});
  const auto kept = std::make_shared<Kept>();
  live::Stream stream;
  stream.add(kept);
  live::AlarmPublisher voice(stream, {}, watch, vessels);
  voice.open("rov");
  voice.open("halted");
  for (double t_s = 0; t_s <= 1200; ++t_s) {
    const std::array<twin::Seen, 2> seen{
        twin::Seen{{5 * t_s, 0, 0}, {5, 0, 0}, twin::Halt::none},
        twin::Seen{{5 * t_s, 0, 0}, {5, 0, 0}, twin::Halt::aground}};
    watch.look(t_s, seen);
    voice.speak(t_s);
  }
  std::vector<std::pair<double, nlohmann::json>> of_rov;
  for (const Kept::Message& message : kept->messages) {
    const nlohmann::json alarms = json_in(message.bytes);
    if (message.topic == "/rov/cpa_alarms")
      of_rov.emplace_back(static_cast<double>(message.stamp.seconds), alarms);
    else
      EXPECT_EQ(alarms, nlohmann::json::array()) << "it goes nowhere";
  }
  ASSERT_EQ(of_rov.size(), 3U);
  EXPECT_EQ(of_rov[0], std::pair(0.0, nlohmann::json::array()));
  EXPECT_EQ(of_rov[1].first, 400);
  const nlohmann::json raised = of_rov[1].second.at(0);
  EXPECT_EQ(raised.at("mmsi"), vessel.id);
  EXPECT_EQ(raised.at("name"), "M\xef\xbf\xbdN");
  EXPECT_NEAR(raised.at("cpa_m").get<double>(), 300, 1e-6);
  EXPECT_NEAR(raised.at("tcpa_s").get<double>(), 600, 1e-6);
  EXPECT_EQ(raised.at("is_lost"), false);
  EXPECT_EQ(of_rov[2], std::pair(1055.0, nlohmann::json::array()));
  EXPECT_TRUE(kept->channels[0].quality.is_transient_local);
}

}  // namespace
}  // namespace slackwater::tests::alarm_publisher_test
