#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/comes_true.h"
#include "tests/support/farm_for_tests.h"
#include "tests/support/http_client.h"
#include "tests/support/started_program.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests {

/// `slackwater serve` over a store with a farm that has forecasts of two days, the first of which
/// came true, and a site without any; its clock shows 06:10 on the day of the last issue. It
/// listens to a log of AIS that is not there yet.
class DeskServed : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = std::make_unique<StoreForTests>();
    made_->ingest_days(parse_day("2025-03-01"), 3);
    for (const char* folder : {"sites", "plans"})
      std::filesystem::create_directories(made_->store() / folder);
    std::ofstream(made_->store() / "sites" / "farm.yaml")
        << farm("farm", "tasks: [scour_survey, cp_anode]\n");
    std::ofstream(made_->store() / "sites" / "bare.yaml") << farm("bare", "");
    std::ofstream(made_->store() / "plans" / "farm.yaml")
        << "name: One look\nsite: farm\nvessels:\n  - {id: ctv1, crews: 1, speed_kn: 20, hours: "
           "00:00-24:00}\ncrews:\n  - {id: blue, skills: [], shift: 00:00-24:00, vessel: ctv1}\n"
           "vehicles:\n  - {id: rov1, kind: rov, vessel: ctv1}\n"
           "tasks:\n  - {task: scour_survey, turbines: [T1], vehicles: [rov]}\n";
    for (const char* at : {"2025-03-03T05:00:00Z", "2025-03-04T05:00:00Z"}) {
      const ProgramResult issued = made_->run({"forecast", "--site", "farm", "--at", at});
      ASSERT_EQ(issued.exit_code, 0) << issued.err;
    }
    program_ = std::make_unique<StartedProgram>(
        made_->start({"--json", "serve", "--port", "0", "--at", "2025-03-04T06:10:00Z", "--ais",
                      path("heard.csv")},
                     made_->file("address")));
    ASSERT_TRUE(comes_true(
        [] {
          std::ifstream file(made_->file("address"));
          const auto said = nlohmann::json::parse(file, nullptr, false);
          if (said.is_object()) port_ = said.at("port").get<std::uint16_t>();
          return port_ != 0;
        },
        std::chrono::seconds(60)));
  }
  static void TearDownTestSuite() {
    if (program_) EXPECT_EQ(program_->end(SIGTERM), 0);
    program_.reset();
    made_.reset();
    port_ = 0;
  }
  void SetUp() override { ASSERT_NE(port_, 0); }

  static std::string farm(const std::string& id, const std::string& more) {
    std::string site = farm_at_the_site(*made_, more);
    const std::size_t at = site.find("id: ") + 4;
    return site.replace(at, site.find('\n', at) - at, id);
  }
  static std::string path(const std::string& name) { return made_->path(name); }
  static HttpReply reply(const std::string& target, const std::string& fields = {}) {
    HttpClient client(port_);
    client.send("GET " + target + " HTTP/1.1\r\nHost: 127.0.0.1\r\n" + fields + "\r\n");
    const auto reply = client.receive(true, std::chrono::seconds(60));
    return reply ? *reply : HttpReply{};
  }
  static nlohmann::json got(const std::string& target) {
    const HttpReply answer = reply(target);
    EXPECT_EQ(answer.status, 200) << target << "\n" << answer.body;
    return nlohmann::json::parse(answer.body, nullptr, false);
  }
  static HttpReply posted(const std::string& target, const nlohmann::json& body,
                          const std::string& fields = {}) {
    HttpClient client(port_);
    const std::string text = body.is_string() ? body.get<std::string>() : body.dump();
    client.send("POST " + target + " HTTP/1.1\r\nHost: 127.0.0.1\r\n" + fields +
                "Content-Type: application/json\r\nContent-Length: " + std::to_string(text.size()) +
                "\r\n\r\n" + text);
    const auto reply = client.receive(true, std::chrono::seconds(60));
    return reply ? *reply : HttpReply{};
  }
  /// What a command says as JSON.
  static nlohmann::json told(std::vector<std::string> arguments) {
    arguments.emplace_back("--json");
    const ProgramResult result = made_->run(std::move(arguments));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return nlohmann::json::parse(result.out, nullptr, false);
  }

  inline static std::unique_ptr<StoreForTests> made_;
  inline static std::unique_ptr<StartedProgram> program_;
  inline static std::uint16_t port_ = 0;
};

}  // namespace slackwater::tests
