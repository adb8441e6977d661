// A day is forecast once: what is run again later, or in hindsight, is filed as what it is, and no
// door takes it for the forecast that was issued.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/contains.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_as_issued_test {
namespace {

using nlohmann::json;
using std::chrono::days;

const UtcDay first = parse_day("2025-03-04");
constexpr const char* morning = "2025-03-08T05:00:00Z";  // D is the 7th

class AsIssuedAtEveryDoor : public ::testing::Test {
 protected:
  AsIssuedAtEveryDoor() {
    store_.ingest_days(first, 4);
    issued_ = forecast(morning);
    store_.ingest_days(first + days(4), 4);
  }

  json run_json(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "--json");
    const ProgramResult result = store_.run(std::move(arguments));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return json::parse(result.out);
  }

  json forecast(const std::string& at, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"forecast", "--site", store_.site(), "--at", at};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_json(std::move(arguments));
  }

  void expect_the_issued_one_everywhere() {
    const std::string site = store_.site();
    EXPECT_EQ(run_json({"profile", "--site", site, "--time", "2025-03-08T14:00:00Z"}).at("issued"),
              morning);
    for (const json& entry : run_json({"verify", "--site", site, "--to", "2025-03-07"})) {
      const bool was_issued = entry.at("wind") == "best";  // no other policy was, that day
      EXPECT_EQ(entry.at("origin"), was_issued ? "forecast" : "hindcast");
      EXPECT_EQ(entry.at("issued") == morning, was_issued) << entry.at("issued");
      EXPECT_EQ(entry.at("set").at("pairs"), 1);
      EXPECT_EQ(entry.at("set").at("few"), true);
    }
  }

  StoreForTests store_;
  json issued_;
};

TEST_F(AsIssuedAtEveryDoor, APastDayThatIsRunAgainIsAHindcast) {
  EXPECT_EQ(issued_.at("origin"), "forecast");
  const std::vector<std::string> day{"--day", "2025-03-07"};
  EXPECT_EQ(forecast("2025-03-08T12:30:00Z", day).at("origin"), "hindcast");
  EXPECT_EQ(forecast("2025-03-10T05:00:00Z", day).at("origin"), "hindcast");
  EXPECT_EQ(forecast("2026-01-01T00:00:00Z", day).at("origin"), "hindcast");
  expect_the_issued_one_everywhere();
  const json row = json::parse(store_.listing()).at("forecasts").back();
  EXPECT_EQ(row.at("origin"), "hindcast");
  const ProgramResult said =
      store_.run({"forecast", "--site", store_.site(), "--at", "2026-01-01T00:00:00Z", "--day",
                  "2025-03-07", "--wind", "persist"});
  EXPECT_TRUE(contains(said.out, "filed as a hindcast: a forecast of this day")) << said.out;
  expect_the_issued_one_everywhere();
}

TEST_F(AsIssuedAtEveryDoor, AFileThatCameLateTheSameMorningMakesTheForecastOfThatDay) {
  const char* later = "2025-03-08T08:00:00Z";
  EXPECT_EQ(forecast(later, {"--day", "2025-03-07"}).at("origin"), "forecast");
  EXPECT_EQ(run_json({"verify", "--site", store_.site()}).at(0).at("issued"), later);
  EXPECT_EQ(
      run_json({"profile", "--site", store_.site(), "--time", "2025-03-08T14:00:00Z"}).at("issued"),
      later);
}

TEST_F(AsIssuedAtEveryDoor, HindsightAndHindcastsStandBehindIt) {
  EXPECT_EQ(forecast(morning, {"--day", "2025-03-07", "--hindsight"}).at("origin"), "hindcast");
  static_cast<void>(run_json(
      {"hindcast", "--site", store_.site(), "--from", "2025-03-07", "--to", "2025-03-07"}));
  expect_the_issued_one_everywhere();
  const json next = forecast("2025-03-10T05:00:00Z");
  EXPECT_EQ(next.at("verdict").at("pairs"), 1);
  EXPECT_EQ(next.at("verdict").at("origin"), "forecast");
  EXPECT_EQ(next.at("verdict").at("few"), true);
  EXPECT_TRUE(next.at("verdict").at("interval_95").is_null());
  EXPECT_EQ(next.at("verdict").at("hindsight"), false);
  EXPECT_TRUE(contains(next.at("verified"), "few")) << next.at("verified");
}

}  // namespace
}  // namespace slackwater::tests::cli_as_issued_test
