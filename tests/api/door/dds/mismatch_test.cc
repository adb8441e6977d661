// Readers and writers of one topic that do not hear each other: of two types, of two qualities.
#include "api/door/dds/mismatch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "api/door/dds/participant.h"
#include "geometry_msgsPubSubTypes.h"
#include "rcl_interfacesPubSubTypes.h"
#include "rosgraph_msgsPubSubTypes.h"
#include "std_msgsPubSubTypes.h"
#include "tests/api/door/dds/generated_client.h"
#include "tests/api/door/dds/inbox.h"
#include "tests/api/door/dds/own_domain.h"

namespace slackwater::tests::mismatch_test {
namespace {

using dds::Endpoint;

const std::string twist = "geometry_msgs::msg::dds_::Twist_";
const std::string stamped = "geometry_msgs::msg::dds_::TwistStamped_";

TEST(Mismatch, OfTypesNamesTopicClientAndBoth) {
  const Endpoint ours{"rt/rov/cmd_vel", twist, false}, theirs{"rt/rov/cmd_vel", stamped, true};
  EXPECT_EQ(dds::mismatch_of(ours, theirs, "dds 01.0f", ""),
            "/rov/cmd_vel: dds 01.0f writes geometry_msgs/msg/TwistStamped, read here is "
            "geometry_msgs/msg/Twist: nothing of it is heard; write that type");
  EXPECT_EQ(dds::mismatch_of(theirs, ours, "dds 01.0f", "rt/rov/cmd_vel_plain"),
            "/rov/cmd_vel: dds 01.0f reads geometry_msgs/msg/Twist, written here is "
            "geometry_msgs/msg/TwistStamped: it hears nothing; read that type, or use "
            "/rov/cmd_vel_plain, which has yours");
}

/// By the rule of DDS (1.4, 2.2.3): what is offered is no less than what is asked for.
TEST(Mismatch, OfQualitiesIsWhereLessIsOfferedThanAskedFor) {
  for (const bool ours_writes : {false, true})
    for (const bool wants : {false, true})
      for (const bool offers : {false, true})
        for (const int kept_for : {0, 1, 2})
          for (const int kept : {0, 1, 2}) {
            const Endpoint reader{"rt/t", twist, false, wants, kept_for};
            const Endpoint writer{"rt/t", twist, true, offers, kept};
            const bool hears = (offers || !wants) && kept >= kept_for;
            const auto found = ours_writes ? dds::mismatch_of(writer, reader, "dds 01", "")
                                           : dds::mismatch_of(reader, writer, "dds 01", "");
            EXPECT_EQ(!found.has_value(), hears) << found.value_or("");
            if (found) EXPECT_TRUE(found->starts_with("/t: dds 01 ")) << *found;
          }
}

TEST(Mismatch, IsNoneOfTwoReadersTwoWritersOrTwoTopics) {
  const Endpoint reader{"rt/t", twist, false}, writer{"rt/t", twist, true};
  EXPECT_FALSE(dds::mismatch_of(reader, {"rt/t", stamped, false}, "a", ""));
  EXPECT_FALSE(dds::mismatch_of(writer, {"rt/t", stamped, true}, "a", ""));
  EXPECT_FALSE(dds::mismatch_of(reader, {"rt/u", stamped, true}, "a", ""));
}

TEST(MismatchWatch, SaysEachOnceOfAClientWhicheverSideComesFirst) {
  dds::MismatchWatch watch;
  const Endpoint ours{"rt/rov/cmd_vel", twist, false}, theirs{"rt/rov/cmd_vel", stamped, true};
  EXPECT_TRUE(watch.add_theirs({1}, "one", theirs).empty());
  EXPECT_TRUE(watch.add_ours({"rt/rov/cmd_vel_stamped", stamped, false}).empty());
  const auto first = watch.add_ours(ours);
  ASSERT_EQ(first.size(), 1U);
  EXPECT_TRUE(first[0].ends_with("or use /rov/cmd_vel_stamped, which has yours")) << first[0];
  EXPECT_TRUE(watch.add_theirs({2}, "one", theirs).empty()) << "a second writer of the same";
  EXPECT_EQ(watch.add_theirs({3}, "two", theirs).size(), 1U);
  watch.forget({1});
  EXPECT_TRUE(watch.add_theirs({4}, "one", theirs).empty()) << "it is still there";
  watch.forget_client("one");
  EXPECT_EQ(watch.add_theirs({5}, "one", theirs).size(), 1U) << "it came again";
  EXPECT_TRUE(watch.add_theirs({6}, "three", {"rt/rov/cmd_vel", twist, true}).empty());
}

class Said : public fdds::DataReaderListener {
 public:
  explicit Said(Inbox<rcl_interfaces::msg::Log>& inbox) : inbox_(inbox) {}
  void on_data_available(fdds::DataReader* reader) override {
    rcl_interfaces::msg::Log message;
    fdds::SampleInfo info;
    while (reader->take_next_sample(&message, &info) ==
           eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK)
      if (info.valid_data) inbox_.put(message);
  }

 private:
  Inbox<rcl_interfaces::msg::Log>& inbox_;
};

/// What both sides learn, over the wire.
TEST(Mismatches, AreNamedHereAndOnRosout) {
  const OwnDomain domain;
  Inbox<std::string> troubles;
  Inbox<rcl_interfaces::msg::Log> told;
  Said listener(told);
  dds::DomainSettings settings;
  settings.domain = domain.number();
  settings.is_loopback_only = settings.is_udp_only = true;
  settings.on_trouble = [&](const std::string& text) { troubles.put(text); };
  dds::Participant ours(settings);
  ours.subscribe({"/rov/cmd_vel", "geometry_msgs/msg/Twist", "", {true, false, 1}},
                 [](dds::Payload, const std::string&) {});
  (void)ours.publish_on({"/clock", "rosgraph_msgs/msg/Clock", "", {false, false, 1}});
  (void)ours.publish_on({"/rov/name", "std_msgs/msg/String", "", {true, false, 1}});
  GeneratedParticipant other(domain.number(), true);
  (void)other.reader("rt/rosout", fdds::TypeSupport(new rcl_interfaces::msg::LogPubSubType),
                     &listener, true);
  (void)other.writer("rt/rov/cmd_vel",
                     fdds::TypeSupport(new geometry_msgs::msg::TwistStampedPubSubType));
  // Reliable, of best effort; for who comes late, of what is not kept.
  (void)other.reader("rt/clock", fdds::TypeSupport(new rosgraph_msgs::msg::ClockPubSubType),
                     nullptr);
  (void)other.reader("rt/rov/name", fdds::TypeSupport(new std_msgs::msg::StringPubSubType), nullptr,
                     true);
  const std::map<std::string, std::string> expected{
      {"/rov/cmd_vel: dds ",
       " writes geometry_msgs/msg/TwistStamped, read here is geometry_msgs/msg/Twist: "},
      {"/clock: dds ", " asks for reliability, written here is best effort: "},
      {"/rov/name: dds ", " asks for what was said before it came (durability), "}};
  const auto is_among = [](const std::vector<std::string>& all, const auto& one) {
    return std::any_of(all.begin(), all.end(), [&](const std::string& text) {
      return text.starts_with(one.first) && text.find(one.second) != std::string::npos;
    });
  };
  const std::vector<std::string> here = troubles.wait(3);
  std::vector<std::string> there;
  for (const auto& log : told.wait(3)) {
    EXPECT_EQ(log.level(), 30) << "a warning";
    EXPECT_EQ(log.name(), "slackwater");
    EXPECT_GT(log.stamp().sec(), 1'700'000'000);
    there.push_back(log.msg());
  }
  for (const auto& one : expected) {
    EXPECT_TRUE(is_among(here, one)) << one.first;
    EXPECT_TRUE(is_among(there, one)) << one.first;
  }
  EXPECT_EQ(here.size(), 3U) << "each once, and nothing of what matches";
  EXPECT_EQ(there, here);
}

}  // namespace
}  // namespace slackwater::tests::mismatch_test
