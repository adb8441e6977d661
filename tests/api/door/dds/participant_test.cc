#include "api/door/dds/participant.h"

#include "api/door/dds/message/orders.h"
#include "api/door/dds/message/site_messages.h"
#include "api/door/dds/message/vehicle_messages.h"
#include "fields/base/check.h"
#include "fields/base/error.h"
#include "tests/api/door/dds/cdr_by_hand.h"
#include "tests/api/door/dds/inbox.h"
#include "tests/api/door/dds/own_domain.h"
#include "tests/support/udp_sockets.h"

// Participants on this machine, over UDP and through shared memory, each in a domain of its test.

namespace slackwater::dds::participant_test {
namespace {

using namespace std::chrono_literals;
using bag::Channel;
using bag::Quality;
using tests::comes_true;
using tests::Inbox;
using tests::OwnDomain;

const Quality reliable{true, false, 10};
const Quality best_effort{false, false, 10};
const Quality latched{true, true, 1};

Channel texts(const Quality& quality, const std::string& topic = "/test/text") {
  return {topic, "std_msgs/msg/String", "", quality};
}
/// On the wire all is a multiple of four.
Bytes padded(Bytes message) {
  message.resize((message.size() + 3) / 4 * 4);
  return message;
}
Bytes said(const std::string& words) { return padded(text(words)); }

struct Heard {
  Bytes message;
  std::string client;
};

class Participants : public testing::TestWithParam<bool> {
 protected:
  [[nodiscard]] DomainSettings settings(const OwnDomain& domain) const {
    DomainSettings made;
    made.domain = domain.number();
    made.is_loopback_only = true;
    made.is_udp_only = GetParam();
    return made;
  }
  [[nodiscard]] DomainSettings settings() const { return settings(domain_); }
  static Participant::OnMessage into(Inbox<Heard>& inbox) {
    return [&inbox](Payload message, const std::string& client) {
      inbox.put({Bytes(message.begin(), message.end()), client});
    };
  }
  OwnDomain domain_;
};

TEST_P(Participants, WhoComesLateGetsWhatWasSaidLast) {
  Inbox<Heard> inbox;
  Participant early(settings());
  const auto writer = early.publish_on(texts(latched));
  for (const char* words : {"first", "second", "last"}) early.send(writer, text(words));
  Participant late(settings());
  late.subscribe(texts(latched), into(inbox));
  const auto heard = inbox.wait();
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_EQ(heard[0].message, said("last"));
}

TEST_P(Participants, WhoAsksForLessHearsAReliableWriterToo) {
  Inbox<Heard> strict, easy;
  Participant writer(settings()), reader(settings()), other(settings());
  const auto id = writer.publish_on(texts(reliable));
  reader.subscribe(texts(reliable), into(strict));
  other.subscribe(texts(best_effort), into(easy));
  ASSERT_TRUE(comes_true([&] {
    writer.send(id, text("tick"));
    std::this_thread::sleep_for(20ms);
    return strict.size() > 0 && easy.size() > 0;
  }));
  EXPECT_EQ(strict.wait().front().message, said("tick"));
  EXPECT_EQ(easy.wait().front().message, said("tick"));
}

TEST_P(Participants, AReliableReaderGetsAllInOrder) {
  Inbox<Heard> inbox;
  Participant writer(settings()), reader(settings());
  const Quality deep{true, true, 500};
  const auto id = writer.publish_on(texts(deep));
  reader.subscribe(texts(deep), into(inbox));
  constexpr std::size_t messages = 500;
  for (std::size_t i = 0; i < messages; ++i) writer.send(id, text(std::to_string(i)));
  const auto heard = inbox.wait(messages);
  ASSERT_EQ(heard.size(), messages);
  for (std::size_t i = 0; i < messages; ++i) EXPECT_EQ(heard[i].message, said(std::to_string(i)));
}

TEST_P(Participants, MessagesMayBeLongerThanADatagram) {
  Inbox<Heard> inbox;
  Participant writer(settings()), reader(settings());
  const auto id = writer.publish_on(texts(latched));
  reader.subscribe(texts(latched), into(inbox));
  const Bytes large = text(std::string(300'003, 'x'));  // a multiple of four in all
  writer.send(id, large);
  EXPECT_EQ(inbox.wait().at(0).message, large);
}

TEST_P(Participants, SayWhetherAnybodyHears) {
  Inbox<Heard> inbox;
  Participant writer(settings());
  const auto volatile_id = writer.publish_on(texts(reliable));
  const auto latched_id = writer.publish_on(texts(latched, "/test/latched"));
  EXPECT_FALSE(writer.is_heard(volatile_id));
  EXPECT_TRUE(writer.is_heard(latched_id)) << "somebody may come";
  std::string left;
  {
    Participant reader(settings());
    reader.subscribe(texts(reliable), into(inbox));
    EXPECT_TRUE(comes_true([&] { return writer.is_heard(volatile_id); }));
    const auto id = reader.publish_on(texts(reliable, "/test/who"));
    Inbox<Heard> back;
    writer.subscribe(texts(reliable, "/test/who"), into(back));
    ASSERT_TRUE(comes_true([&] { return reader.is_heard(id); }));
    reader.send(id, text("I"));
    const std::string client = back.wait().at(0).client;
    EXPECT_TRUE(writer.is_heard_by(volatile_id, client));
    EXPECT_FALSE(writer.is_heard_by(latched_id, client)) << "it reads another topic";
    EXPECT_FALSE(writer.is_heard_by(volatile_id, client + "0"));
    left = client;
  }
  EXPECT_TRUE(comes_true([&] { return !writer.is_heard(volatile_id); }));
  EXPECT_FALSE(writer.is_heard_by(volatile_id, left));
}

TEST_P(Participants, WrongQualityIsToldOnBothSides) {
  const struct {
    Quality offered, asked;
    const char* policy;
  } cases[] = {{best_effort, reliable, "reliability"}, {reliable, latched, "durability"}};
  for (const auto& wrong : cases) {
    const std::string topic = std::string("/test/") + wrong.policy;
    Inbox<std::string> offered, asked;
    Inbox<Heard> inbox;
    DomainSettings offering = settings(), asking = settings();
    offering.on_trouble = [&](const std::string& told) { offered.put(told); };
    asking.on_trouble = [&](const std::string& told) { asked.put(told); };
    Participant writer(offering), reader(asking);
    const auto id = writer.publish_on(texts(wrong.offered, topic));
    reader.subscribe(texts(wrong.asked, topic), into(inbox));
    const auto by_writer = offered.wait(), by_reader = asked.wait();
    ASSERT_FALSE(by_writer.empty() || by_reader.empty()) << wrong.policy;
    for (const std::string& told : {by_writer[0], by_reader[0]}) {
      EXPECT_NE(told.find(wrong.policy), std::string::npos) << told;
      EXPECT_NE(told.find(topic), std::string::npos) << told;
    }
    writer.send(id, text("unheard"));
    EXPECT_TRUE(inbox.wait(1, 200ms).empty());
    EXPECT_FALSE(writer.is_heard(id));
  }
}

TEST_P(Participants, OfTwoDomainsDoNotHearEachOther) {
  const OwnDomain elsewhere;
  Inbox<Heard> here, there;
  Participant writer(settings()), near(settings()), far(settings(elsewhere));
  const auto id = writer.publish_on(texts(latched));
  writer.send(id, text("here"));
  far.subscribe(texts(latched), into(there));
  near.subscribe(texts(latched), into(here));
  ASSERT_EQ(here.wait().size(), 1U);
  EXPECT_TRUE(there.wait(1, 1s).empty()) << "a message leaked into another domain";
}

TEST_P(Participants, ClientsAreNamedByTheirParticipant) {
  Inbox<Heard> inbox;
  Participant reader(settings()), one(settings()), two(settings());
  reader.subscribe(texts(latched, "/test/a"), into(inbox));
  reader.subscribe(texts(latched, "/test/b"), into(inbox));
  one.send(one.publish_on(texts(latched, "/test/a")), text("1"));
  one.send(one.publish_on(texts(latched, "/test/b")), text("1"));
  two.send(two.publish_on(texts(latched, "/test/b")), text("2"));
  const auto heard = inbox.wait(3);
  ASSERT_EQ(heard.size(), 3U);
  std::string first, second;
  for (const Heard& message : heard) {
    EXPECT_TRUE(message.client.starts_with("dds ")) << message.client;
    EXPECT_EQ(message.client.size(), 4U + 12 * 2 + 11);
    std::string& client = message.message == said("1") ? first : second;
    EXPECT_TRUE(client.empty() || client == message.client);
    client = message.client;
  }
  EXPECT_NE(first, second);
}

TEST_P(Participants, AClientThatLeftIsTold) {
  Inbox<Heard> inbox;
  Inbox<std::string> lost;
  Participant reader(settings());
  reader.subscribe(texts(latched), into(inbox));
  reader.on_lost([&](const std::string& client) { lost.put(client); });
  {
    Participant client(settings());
    client.send(client.publish_on(texts(latched)), text("here I am"));
    ASSERT_EQ(inbox.wait().size(), 1U);
    EXPECT_EQ(lost.size(), 0U);
  }
  ASSERT_EQ(lost.wait().size(), 1U);
  EXPECT_EQ(lost.wait().front(), inbox.wait().front().client);
}

TEST_P(Participants, WhatIsThrownWhereTheyCallIsToldAndTheyGoOn) {
  Inbox<std::string> trouble;
  Inbox<Heard> inbox;
  DomainSettings listening = settings();
  listening.on_trouble = [&](const std::string& told) { trouble.put(told); };
  Participant reader(listening), writer(settings());
  reader.subscribe(texts(latched), [&](Payload message, const std::string& client) {
    inbox.put({Bytes(message.begin(), message.end()), client});
    (void)velocity_asked(message);  // which it is not
  });
  const auto id = writer.publish_on(texts(latched));
  writer.send(id, text("no twist"));
  ASSERT_EQ(trouble.wait().size(), 1U);
  EXPECT_NE(trouble.wait()[0].find("test/text"), std::string::npos) << trouble.wait()[0];
  EXPECT_NE(trouble.wait()[0].find("the message"), std::string::npos);
  writer.send(id, text("another"));
  EXPECT_EQ(inbox.wait(2).size(), 2U);
}

TEST_P(Participants, SendFromAnyThreadWhileOthersComeAndGo) {
  Inbox<Heard> inbox;
  Participant writer(settings());
  const auto a = writer.publish_on(texts(reliable, "/test/a"));
  const auto b = writer.publish_on(texts(reliable, "/test/b"));
  std::atomic<bool> is_over = false;
  std::vector<std::thread> threads;
  for (const auto id : {a, b, a})
    threads.emplace_back([&, id] {
      for (int i = 0; !is_over; ++i) {
        writer.send(id, text(std::to_string(i)));
        (void)writer.is_heard(id);
        std::this_thread::sleep_for(1ms);
      }
    });
  for (int i = 0; i < 4; ++i) {
    Participant reader(settings());
    reader.subscribe(texts(reliable, "/test/a"), into(inbox));
    reader.subscribe(texts(best_effort, "/test/b"), into(inbox));
    const std::size_t so_far = inbox.size();
    EXPECT_EQ(inbox.wait(so_far + 10).size() >= so_far + 10, true) << i;
  }
  is_over = true;
  for (std::thread& thread : threads) thread.join();
}

INSTANTIATE_TEST_SUITE_P(Over, Participants, testing::Bool(), [](const auto& is_udp_only) {
  return is_udp_only.param ? "Udp" : "SharedMemory";
});

TEST(Participant, ThereIsNoSuchDomain) {
  for (const int domain : {-1, 233, 100'000}) {
    DomainSettings settings;
    settings.domain = domain;
    try {
      const Participant participant(settings);
      ADD_FAILURE() << domain;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::invalid_input);
      EXPECT_NE(e.message().find("from 0 to 232"), std::string::npos) << e.message();
    }
  }
}

TEST(Participant, IsAtTheNetworkCardThatItIsToldAlone) {
  const OwnDomain domain;
  DomainSettings settings;
  settings.domain = domain.number();
  settings.is_udp_only = true;
  settings.interface = "127.0.0.1";
  Inbox<std::string> inbox;
  Participant reader(settings), writer(settings);
  reader.subscribe({"/test", "std_msgs/msg/String", "", latched},
                   [&](Payload, const std::string& client) { inbox.put(client); });
  writer.send(writer.publish_on({"/test", "std_msgs/msg/String", "", latched}), text("here"));
  EXPECT_EQ(inbox.wait().size(), 1U);
  const auto sockets = tests::udp_sockets_of("self");
  EXPECT_GE(sockets.size(), 6U) << "of two participants";
  for (const tests::UdpSocket& socket : sockets)
    EXPECT_TRUE(socket.address == "127.0.0.1" || socket.address == "239.255.0.1")
        << socket.address << " " << socket.port;
}

TEST(Participant, ThereIsNoSuchNetworkCard) {
  const OwnDomain domain;
  DomainSettings settings;
  settings.domain = domain.number();
  for (const char* const address : {"203.0.113.77", "lo", "here"}) {
    settings.interface = address;
    try {
      const Participant participant(settings);
      ADD_FAILURE() << address;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::invalid_input);
      EXPECT_NE(e.message().find(address), std::string::npos) << e.message();
      EXPECT_NE(e.message().find("found 127.0.0.1 (lo)"), std::string::npos) << e.message();
    }
  }
}

TEST(Participant, ATopicHasOneType) {
  const OwnDomain domain;
  DomainSettings settings;
  settings.domain = domain.number();
  settings.is_loopback_only = settings.is_udp_only = true;
  Participant participant(settings);
  (void)participant.publish_on({"/test", "std_msgs/msg/String", "", reliable});
  participant.subscribe({"/test", "std_msgs/msg/String", "", reliable}, {});
  EXPECT_THROW((void)participant.publish_on({"/test", "std_msgs/msg/Float64", "", reliable}),
               ContractViolation);
}

}  // namespace
}  // namespace slackwater::dds::participant_test
