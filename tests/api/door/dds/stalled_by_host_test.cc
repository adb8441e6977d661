// A run with people in it waits for a host of physics that does not answer: they are told for whom.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "slackwater_msgsPubSubTypes.h"
#include "tests/api/door/dds/own_domain.h"
#include "tests/api/door/dds/without_leaks.h"
#include "tests/api/door/live/live_records.h"
#include "tests/strangers/live/service_client.h"
#include "tests/support/comes_true.h"
#include "tests/support/keep_secret.h"
#include "tests/support/started_program.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/websocket_client.h"

namespace slackwater::tests::stalled_by_host_test {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;

struct StalledByHost : testing::Test {
  StalledByHost() {
    std::ofstream(folder / "run.yaml")
        << "name: test\nseed: 7\nduration: 20min\nstep_s: 0.05\nlog_every_s: 0.5\n"
           "water: {made_up: {depth_m: 60}}\nvehicles:\n"
           "  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10}, "
           "tasks: [{do: hold}]}\n";
    std::ofstream(folder / "people.yaml")
        << "people: [{name: Gus, role: spectator, token: " << token
        << ", until: 2100-01-01T00:00:00Z}]\n";
    keep_secret(folder / "people.yaml");
    run.emplace(start_program(
        {"live", folder / "run.yaml", "--dds-domain", std::to_string(domain.number()), "--people",
         "0", "--people-file", folder / "people.yaml", "--store", folder / "store"},
        without_leaks(), "/dev/null", folder / "err"));
  }
  std::string said() const {
    std::ostringstream text;
    text << std::ifstream(folder / "err").rdbuf();
    return text.str();
  }
  /// Of the page, once the run has begun.
  std::uint16_t port() const {
    const std::string before = "people: http://127.0.0.1:";
    EXPECT_TRUE(comes_true([&] { return said().find("vehicle rov") != std::string::npos; }, 60s));
    const std::string err = said();
    return static_cast<std::uint16_t>(std::stoi(err.substr(err.find(before) + before.size())));
  }
  /// Takes the physics over for `timeout_s` a step, and answers none.
  void host_in_silence(double timeout_s) {
    auto* const asks =
        node.writer<slackwater_msgs::msg::HostRequestPubSubType>("rt/rov/host/request");
    (void)node.reader<slackwater_msgs::msg::PhysicsInputPubSubType>("rt/rov/host/physics_input");
    // The run listens to hosts that it knows the writer of.
    (void)node.writer<slackwater_msgs::msg::PhysicsOutputPubSubType>("rt/rov/host/physics_output");
    ASSERT_TRUE(comes_true(
        [&] {
          peer::fdds::PublicationMatchedStatus hears;
          asks->get_publication_matched_status(hears);
          return hears.current_count > 0;
        },
        40s));
    slackwater_msgs::msg::HostRequest asked;
    asked.token(1);
    asked.version(1);
    asked.role(2);
    asked.timeout_s(timeout_s);
    asks->write(&asked);
  }
  /// The next word on the run for which it is so; null: none came.
  template <typename IsSo>
  json told_of_run(WebSocketClient& station, const IsSo& is_so) {
    const auto end = std::chrono::steady_clock::now() + 30s;
    while (std::chrono::steady_clock::now() < end) {
      const auto frame = station.receive(1s);
      if (!frame || frame->opcode != 1) continue;
      const json message = json::parse(frame->payload);
      if (message["is"] == "run" && is_so(message)) return message;
    }
    return nullptr;
  }

  const std::string token = "gus-0123456789abcdef";
  OwnDomain domain;
  TemporaryFolder folder;
  peer::Node node{domain.number()};
  std::optional<StartedProgram> run;
};

TEST_F(StalledByHost, SaysForWhomItWaitsAndGoesOnOnceTheHostIsTakenOff) {
  WebSocketClient station(port(), "/sessions/run/socket", "slackwater.session.v1, bearer." + token);
  ASSERT_EQ(station.handshake().status, 101) << said();
  ASSERT_TRUE(station.send_text(R"({"do": "hello", "name": ""})"));
  host_in_silence(6);
  const json stalled =
      told_of_run(station, [](const json& run) { return run["state"] == "stalled"; });
  ASSERT_FALSE(stalled.is_null()) << said();
  ASSERT_TRUE(stalled["by"].is_string()) << stalled;
  EXPECT_EQ(stalled["by"].get<std::string>().find("the physics of rov, dds "), 0U) << stalled;
  const json again =
      told_of_run(station, [](const json& run) { return run["state"] == "running"; });
  ASSERT_FALSE(again.is_null()) << said();
  EXPECT_TRUE(again["by"].is_null());
  // The run does not wait for its own words to be written.
  EXPECT_TRUE(comes_true([&] {
    return said().find("its answer did not come within 6 s") != std::string::npos;
  })) << said();
  EXPECT_EQ(run->end(SIGINT), 0) << said();
}

}  // namespace
}  // namespace slackwater::tests::stalled_by_host_test
