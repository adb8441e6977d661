// What nodes of ROS 2 look for in the user data of an endpoint since Iron; without it they warn.
#include <gtest/gtest.h>

#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <map>
#include <mutex>

#include "api/door/dds/participant.h"
#include "tests/api/door/dds/generated_client.h"
#include "tests/api/door/dds/own_domain.h"

namespace slackwater::tests::type_hash_told_test {
namespace {

using UserData = std::map<std::string, std::string>;

/// Notes what others tell of their endpoints, by topic.
class Listener : public fdds::DomainParticipantListener {
 public:
  void on_publisher_discovery(fdds::DomainParticipant*,
                              rtps::WriterDiscoveryInfo&& found) override {
    note(found.info.topicName().to_string(), found.info.m_qos.m_userData);
  }
  void on_subscriber_discovery(fdds::DomainParticipant*,
                               rtps::ReaderDiscoveryInfo&& found) override {
    note(found.info.topicName().to_string(), found.info.m_qos.m_userData);
  }
  UserData heard() {
    const std::lock_guard lock(mutex_);
    return heard_;
  }

 private:
  template <typename Octets>
  void note(const std::string& topic, const Octets& octets) {
    const std::lock_guard lock(mutex_);
    heard_[topic] = std::string(octets.begin(), octets.end());
  }
  std::mutex mutex_;
  UserData heard_;
};

TEST(TypeHashes, AreToldOfEveryWriterReaderAndService) {
  const OwnDomain domain;
  dds::DomainSettings settings;
  settings.domain = domain.number();
  settings.is_loopback_only = settings.is_udp_only = true;
  dds::Participant ours(settings);
  (void)ours.publish_on({"/test/text", "std_msgs/msg/String", "", {true, false, 1}});
  ours.subscribe({"/test/number", "std_msgs/msg/Float64", "", {true, false, 1}},
                 [](dds::Payload, const std::string&) {});
  ours.serve({"/test/pause", "std_srvs/srv/Trigger"},
             [](dds::Payload, const std::string&, const dds::Answer&) {});
  (void)ours.publish_on({"/test/unknown", "other_msgs/msg/Unknown", "", {true, false, 1}});

  Listener listener;
  fdds::DomainParticipantQos qos;
  qos.transport().use_builtin_transports = false;
  const auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList.emplace_back("127.0.0.1");
  qos.transport().user_transports.push_back(udp);
  auto* factory = fdds::DomainParticipantFactory::get_instance();
  fdds::DomainParticipant* other = factory->create_participant(
      static_cast<std::uint32_t>(domain.number()), qos, &listener, fdds::StatusMask::none());
  ASSERT_NE(other, nullptr);
  const std::string trigger =
      "typehash=RIHS01_eeff2cd6fa5ad9d27cdf4dec64818317839b62f212a91e6b5304b634b2062c5f;";
  const UserData expected{
      {"rt/test/text",
       "typehash=RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18;"},
      {"rt/test/number",
       "typehash=RIHS01_705ba9c3d1a09df43737eb67095534de36fd426c0587779bda2bc51fe790182a;"},
      {"rq/test/pauseRequest", trigger},
      {"rr/test/pauseReply", trigger},
      {"rt/test/unknown", ""}};
  EXPECT_TRUE(comes_true([&] {
    const UserData heard = listener.heard();
    return std::all_of(expected.begin(), expected.end(), [&](const auto& one) {
      const auto found = heard.find(one.first);
      return found != heard.end() && found->second == one.second;
    });
  }));
  const UserData heard = listener.heard();
  for (const auto& one : expected)
    EXPECT_EQ(heard.contains(one.first) ? heard.at(one.first) : "not heard", one.second)
        << one.first;
  EXPECT_TRUE(heard.contains("ros_discovery_info") &&
              heard.at("ros_discovery_info").starts_with("typehash=RIHS01_"));
  factory->delete_participant(other);
}

}  // namespace
}  // namespace slackwater::tests::type_hash_told_test
