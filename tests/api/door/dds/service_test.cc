#include <array>

#include "api/door/dds/message/services.h"
#include "api/door/dds/participant.h"
#include "fields/base/error.h"
#include "tests/api/door/dds/generated_client.h"
#include "tests/api/door/dds/own_domain.h"

// Services called by Fast DDS participants with fastddsgen's own types, by both conventions of who
// is answered.

namespace slackwater::dds::service_test {
namespace {

using namespace std::chrono_literals;
using tests::comes_true;
using tests::Convention;
using tests::Inbox;
using tests::OwnDomain;
using tests::SpawnClient;

const Service spawn{"/slackwater/spawn", "slackwater_msgs/srv/Spawn"};

class Services : public testing::TestWithParam<Convention> {
 protected:
  [[nodiscard]] DomainSettings settings() const {
    DomainSettings made;
    made.domain = domain_.number();
    made.is_loopback_only = made.is_udp_only = true;
    return made;
  }
  [[nodiscard]] SpawnClient client() const { return {domain_.number(), GetParam(), spawn.name}; }
  OwnDomain domain_;
};

void echo(Payload request, const std::string&, const Answer& answer) {
  answer(done_reply(true, read_spawn(request).name));
}

/// Replies, each to its own request and to nobody else's.
void expect_own(SpawnClient& client, const std::map<std::uint64_t, std::string>& asked) {
  const auto replies = client.replies().wait(asked.size());
  ASSERT_EQ(replies.size(), asked.size());
  for (const SpawnClient::Reply& reply : replies) {
    EXPECT_EQ(reply.to, client.identity());
    const auto request = asked.find(reply.sequence);
    ASSERT_NE(request, asked.end()) << "an answer to nothing: " << reply.sequence;
    EXPECT_EQ(reply.message, request->second);
  }
}

TEST_P(Services, AnswerTheRequestThatWasMade) {
  Participant server(settings());
  server.serve(spawn, echo);
  SpawnClient asking = client();
  ASSERT_TRUE(asking.finds_service());
  std::map<std::uint64_t, std::string> asked;
  for (int i = 0; i < 20; ++i) {
    const std::string name = "rov" + std::to_string(i);
    asked[asking.ask(name)] = name;
    ASSERT_EQ(asking.replies().wait(asked.size()).size(), asked.size());
  }
  EXPECT_EQ(asked.size(), 20U) << "requests are numbered";
  expect_own(asking, asked);
}

TEST_P(Services, AnswerInAnyOrderFromAnyThread) {
  struct Kept {
    std::string name;
    Answer answer;
  };
  Inbox<Kept> kept;
  Participant server(settings());
  server.serve(spawn, [&](Payload request, const std::string&, const Answer& answer) {
    kept.put({read_spawn(request).name, answer});
  });
  SpawnClient asking = client();
  ASSERT_TRUE(asking.finds_service());
  std::map<std::uint64_t, std::string> asked;
  for (const char* name : {"a", "b", "c", "d"}) asked[asking.ask(name)] = name;
  auto waiting = kept.wait(4);
  ASSERT_EQ(waiting.size(), 4U);
  std::reverse(waiting.begin(), waiting.end());
  for (const Kept& one : waiting)
    std::thread([&] { one.answer(done_reply(true, one.name)); }).join();
  expect_own(asking, asked);
  EXPECT_EQ(asking.replies().wait()[0].message, "d");
}

TEST_P(Services, ClientsAtTheSameTimeGetTheirOwnAnswers) {
  Inbox<std::string> clients;
  Participant server(settings());
  server.serve(spawn, [&](Payload request, const std::string& client, const Answer& answer) {
    clients.put(client);
    echo(request, client, answer);
  });
  SpawnClient one = client(), two = client();
  ASSERT_TRUE(one.finds_service() && two.finds_service());
  std::map<std::uint64_t, std::string> asked_one, asked_two;
  for (std::size_t i = 0; i < 50; ++i) {
    asked_one[one.ask("one" + std::to_string(i))] = "one" + std::to_string(i);
    asked_two[two.ask("two" + std::to_string(i))] = "two" + std::to_string(i);
    // A service keeps the last ten.
    if (i % 4 == 3) {
      (void)one.replies().wait(i + 1);
      (void)two.replies().wait(i + 1);
    }
  }
  for (const auto& [asking, asked] : {std::pair{&one, &asked_one}, {&two, &asked_two}}) {
    (void)asking->replies().wait(asked->size());
    std::this_thread::sleep_for(50ms);  // what is for the other might come late
    std::size_t own = 0;
    for (const SpawnClient::Reply& reply : asking->replies().wait(0)) {
      // All hear the topic; the identity says whose it is (as rmw_fastrtps sorts them out).
      if (reply.to != asking->identity()) continue;
      ++own;
      EXPECT_EQ(asked->at(reply.sequence), reply.message);
    }
    EXPECT_EQ(own, asked->size());
  }
  const auto names = clients.wait(100);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), 2U);
}

/// Clients ask as soon as they see the service, which may be before the service sees them. That it
/// takes a second then is discovery's: what was lost of it is said again each second.
TEST_P(Services, AClientThatAsksAtOnceIsAnswered) {
  Participant server(settings());
  server.serve(spawn, echo);
  for (int i = 0; i < 3; ++i) {
    SpawnClient asking = client();
    ASSERT_TRUE(asking.finds_service());
    (void)asking.ask("at once");
    EXPECT_EQ(asking.replies().wait().size(), 1U) << "attempt " << i;
  }
}

TEST(Service, AnswersWaitForTheReaderOfTheClient) {
  const OwnDomain domain;
  DomainSettings settings;
  settings.domain = domain.number();
  settings.is_loopback_only = settings.is_udp_only = true;
  Inbox<std::string> answered;
  Participant server(settings);
  server.serve(spawn, [&](Payload request, const std::string& client, const Answer& answer) {
    echo(request, client, answer);
    answered.put(client);
  });
  SpawnClient asking(domain.number(), Convention::plain, spawn.name, {.listens = false});
  SpawnClient other(domain.number(), Convention::plain, spawn.name);
  ASSERT_TRUE(asking.finds_service() && other.finds_service());
  (void)asking.ask("early");
  (void)asking.ask("second");
  ASSERT_EQ(answered.wait(2).size(), 2U);
  asking.listen();
  const auto replies = asking.replies().wait(2);
  ASSERT_EQ(replies.size(), 2U);
  EXPECT_EQ(replies[0].message, "early");
  EXPECT_EQ(replies[1].message, "second");
  EXPECT_TRUE(std::all_of(replies.begin(), replies.end(), [&](const SpawnClient::Reply& reply) {
    return reply.to == asking.identity();
  }));
}

/// Nodes of ROS 2 know of no loopback: they come with the library's own transports.
TEST_P(Services, OnThisMachineAloneAreThereForNodesOnAllInterfaces) {
  for (const bool is_udp_only : {false, true}) {
    DomainSettings here = settings();
    here.is_udp_only = is_udp_only;
    Participant server(here);
    server.serve(spawn, echo);
    SpawnClient asking(domain_.number(), GetParam(), spawn.name, {.is_loopback = false});
    ASSERT_TRUE(asking.finds_service()) << is_udp_only;
    (void)asking.ask("from a node");
    EXPECT_EQ(asking.replies().wait().at(0).message, "from a node");
  }
}

TEST_P(Services, RequestsThatAreNoneAreToldAndTheNextIsAnswered) {
  Inbox<std::string> trouble;
  DomainSettings serving = settings();
  serving.on_trouble = [&](const std::string& told) { trouble.put(told); };
  Participant server(serving);
  server.serve(spawn, [](Payload request, const std::string&, const Answer& answer) {
    const std::string name = read_spawn(request).name;
    if (name == "bad") throw Error(ErrorKind::invalid_input, "no such name");
    answer(done_reply(true, name));
  });
  SpawnClient asking = client();
  ASSERT_TRUE(asking.finds_service());
  (void)asking.ask("bad");
  (void)asking.ask("good");
  EXPECT_EQ(asking.replies().wait().at(0).message, "good");
  ASSERT_EQ(trouble.wait().size(), 1U);
  EXPECT_NE(trouble.wait()[0].find("no such name"), std::string::npos);
}

TEST_P(Services, AnswersThatOutliveTheParticipantGoNowhere) {
  Inbox<Answer> kept;
  SpawnClient asking = client();
  {
    Participant server(settings());
    server.serve(spawn,
                 [&](Payload, const std::string&, const Answer& answer) { kept.put(answer); });
    ASSERT_TRUE(asking.finds_service());
    (void)asking.ask("nobody");
    ASSERT_EQ(kept.wait().size(), 1U);
  }
  kept.wait()[0](done_reply(true, "too late"));
  EXPECT_TRUE(asking.replies().wait(1, 100ms).empty());
}

TEST_P(Services, OneThatEndsWhileItAnswersEndsInPeace) {
  for (int i = 0; i < 5; ++i) {
    SpawnClient asking = client();
    std::vector<std::thread> answering;
    {
      Inbox<Answer> kept;
      Participant server(settings());
      server.serve(spawn,
                   [&](Payload, const std::string&, const Answer& answer) { kept.put(answer); });
      ASSERT_TRUE(asking.finds_service());
      (void)asking.ask("x");
      for (const Answer& answer : kept.wait())
        for (int thread = 0; thread < 3; ++thread)
          answering.emplace_back([answer] {
            for (int n = 0; n < 100; ++n) answer(done_reply(true, "x"));
          });
    }
    for (std::thread& thread : answering) thread.join();
  }
}

INSTANTIATE_TEST_SUITE_P(By, Services, testing::Values(Convention::plain, Convention::rmw_fastrtps),
                         [](const auto& convention) {
                           return convention.param == Convention::plain ? "PlainIdentity"
                                                                        : "RmwFastrtps";
                         });

}  // namespace
}  // namespace slackwater::dds::service_test
