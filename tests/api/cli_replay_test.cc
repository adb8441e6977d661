// `forecast --at` in the past: what the job would have made then, whatever the store has learnt
// since.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "tests/support/contains.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_replay_test {
namespace {

using namespace std::chrono;
using nlohmann::json;

constexpr UtcDay first = sys_days{2025y / March / 4};
const std::string at = "2025-03-08T05:00:00Z";  // D is the 7th

json forecast(const StoreForTests& store, const std::string& issued,
              const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"forecast", "--site", store.site(), "--at", issued, "--json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const ProgramResult result = store.run(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return result.exit_code == 0 ? json::parse(result.out) : json();
}

/// The runs of wind and waves of midnight of the 8th, four days long.
void ingest_runs(const StoreForTests& store) {
  for (ProductForTests ahead :
       {wind_product(first + days(4), 96), wave_product(first + days(4), 96)}) {
    ahead.reference_time = UtcTime(first + days(4));
    for (ProductQuantity& q : ahead.quantities) {
      q.value = [value = q.value](const ProductCell& cell) { return 0.8 * value(cell); };
    }
    store.ingest(write_product(store.file("run-" + ahead.quantities[0].name + ".nc"), ahead));
  }
}

/// What a forecast says, without what differs from store to store.
json content_of(json made) {
  for (const char* key : {"id", "site_yaml", "inputs"}) made.erase(key);
  return made;
}

TEST(Replay, IsTheForecastOfThatMorningUnderAnyWindPolicy) {
  StoreForTests then;  // with the hours of the 8th that had passed
  then.ingest_days(first, 4);
  for (const ProductForTests& passed :
       {current_product(first + days(4), 6), wind_product(first + days(4), 6),
        wave_product(first + days(4), 6)})
    then.ingest(write_product(then.file("passed-" + passed.quantities[0].name + ".nc"), passed));
  ingest_runs(then);
  StoreForTests later;
  later.ingest_days(first, 8);
  ingest_runs(later);
  for (const char* wind : {"best", "forecast", "persist"}) {
    SCOPED_TRACE(wind);
    const json made = forecast(then, at, {"--wind", wind});
    const json replayed = forecast(later, at, {"--wind", wind});
    EXPECT_EQ(replayed.at("hindsight"), false);
    EXPECT_EQ(content_of(replayed), content_of(made));
    const auto current_of = [&](const StoreForTests& store) {
      return store
          .run({"profile", "--site", store.site(), "--time", "2025-03-09T14:00:00Z", "--csv"})
          .out;
    };
    EXPECT_EQ(current_of(later), current_of(then));
  }
}

TEST(Replay, TheForecastJustIssuedIsNotVerifiedOnHoursAfterIt) {
  StoreForTests store;
  store.ingest_days(first, 8);
  const json only = forecast(store, at);
  EXPECT_TRUE(only.at("verdict").is_null()) << only.at("verified");
  EXPECT_TRUE(contains(only.at("verified").get<std::string>(), "Not verified yet"))
      << only.at("verified");
}

TEST(Replay, AnEarlierForecastIsVerifiedOnTheHoursThatHadPassed) {
  StoreForTests store;
  store.ingest_days(first, 8);
  ASSERT_TRUE(forecast(store, "2025-03-07T05:00:00Z").at("verdict").is_null());
  static_cast<void>(forecast(store, "2025-03-10T05:00:00Z"));  // issued later: not known at `at`
  const json second = forecast(store, at);
  ASSERT_TRUE(second.at("verdict").is_object()) << second.at("verified");
  EXPECT_EQ(second.at("verdict").at("pairs"), 1);
  EXPECT_EQ(second.at("verdict").at("days"), json({"2025-03-06", "2025-03-06"}));
  EXPECT_EQ(second.at("verdict").at("truth_mean_h"), 0);
}

TEST(Replay, InHindsightOnlyWhereThatIsAskedForAndThenMarkedOnEveryDoor) {
  StoreForTests store;
  store.ingest_days(first, 8);
  const json honest = forecast(store, at);
  EXPECT_TRUE(contains(honest.at("headline").get<std::string>(), "he last known wind is used"))
      << honest.at("headline");
  const json made = forecast(store, at, {"--hindsight"});
  EXPECT_EQ(made.at("hindsight"), true);
  EXPECT_EQ(made.at("wind"), "best");
  EXPECT_TRUE(contains(made.at("headline").get<std::string>(), "Made in hindsight"))
      << made.at("headline");
  EXPECT_TRUE(contains(made.at("columns")[0].at("notes").dump(), "hindsight"));
  const auto answers_in_hindsight = [](const StoreForTests& asked) {
    const ProgramResult profile =
        asked.run({"profile", "--site", asked.site(), "--time", "2025-03-08T14:00:00Z", "--json"});
    return json::parse(profile.out).at("hindsight").get<bool>();
  };
  EXPECT_FALSE(answers_in_hindsight(store)) << "the honest one stays in force";
  StoreForTests alone;
  alone.ingest_days(first, 8);
  static_cast<void>(forecast(alone, at, {"--hindsight"}));
  EXPECT_TRUE(answers_in_hindsight(alone));
  const json row = json::parse(store.listing())["forecasts"].back();
  EXPECT_TRUE(contains(row.at("headline").get<std::string>(), "hindsight"));
}

TEST(Replay, OfAHindcastWithTheBestWindTheSkillIsMarkedAsHindsight) {
  StoreForTests store;
  store.ingest_days(first, 8);
  const std::vector<std::string> best{"hindcast",   "--site", store.site(), "--from",
                                      "2025-03-06", "--to",   "2025-03-08"};
  const ProgramResult text = store.run(best);
  ASSERT_EQ(text.exit_code, 0) << text.err;
  EXPECT_TRUE(contains(text.out, "Wind best (in hindsight)")) << text.out;
  EXPECT_TRUE(contains(text.out, "made in hindsight")) << text.out;
  std::vector<std::string> as_json = best;
  as_json.emplace_back("--json");
  for (const json& entry : json::parse(store.run(as_json).out))
    EXPECT_EQ(entry.at("hindsight"), true);
  as_json.insert(as_json.end(), {"--wind", "forecast"});
  for (const json& entry : json::parse(store.run(as_json).out))
    EXPECT_EQ(entry.at("hindsight"), false);
}

TEST(Replay, OfAHindcastWithASimulatedWindTheSkillAndEveryDoorSaySo) {
  StoreForTests store;
  store.ingest_days(first, 8);
  std::vector<std::string> simulated{"hindcast",   "--site",         store.site(), "--from",
                                     "2025-03-06", "--to",           "2025-03-08", "--wind",
                                     "forecast",   "--simulate-wind"};
  const ProgramResult text = store.run(simulated);
  ASSERT_EQ(text.exit_code, 0) << text.err;
  EXPECT_TRUE(contains(text.out, "Wind forecast (simulated)")) << text.out;
  EXPECT_TRUE(contains(text.out, "simulated wind forecasts")) << text.out;
  const ProgramResult profile =
      store.run({"profile", "--site", store.site(), "--time", "2025-03-09T14:00:00Z"});
  EXPECT_TRUE(contains(profile.out, "simulated wind forecast")) << profile.out;
  simulated.emplace_back("--json");
  const json entries = json::parse(store.run(simulated).out);
  ASSERT_FALSE(entries.empty());
  for (const json& entry : entries) EXPECT_EQ(entry.at("simulated_wind"), true);
  // Read back from the store they still do, beside those whose wind was known.
  static_cast<void>(store.run({"hindcast", "--site", store.site(), "--from", "2025-03-06", "--to",
                               "2025-03-08", "--wind", "persist"}));
  const json verified = json::parse(store.run({"verify", "--site", store.site(), "--json"}).out);
  std::set<std::string> winds;
  for (const json& entry : verified) {
    winds.insert(entry.at("wind").get<std::string>());
    EXPECT_EQ(entry.at("simulated_wind"), entry.at("wind") == "forecast") << entry;
  }
  EXPECT_EQ(winds, (std::set<std::string>{"forecast", "persist"}));
  const json listing = json::parse(store.listing());
  ASSERT_FALSE(listing.at("forecasts").empty());
  for (const json& row : listing.at("forecasts")) {
    EXPECT_EQ(contains(row.at("headline").get<std::string>(), "simulated wind forecast"),
              row.at("wind") == "forecast")
        << row;
  }
}

TEST(Replay, AProductThatRunsOnAndHadComeInIsUsedAsItWasThen) {
  // Waves and wind of a provider whose files say no reference time run on into the future.
  StoreForTests store;
  store.ingest_days(first, 4);
  const auto ahead = [&](const ProductForTests& product, const std::string& came_in) {
    const auto file = write_product(store.file(product.quantities[0].name + "-on.nc"), product);
    const ProgramResult result = store.run({"ingest", "--at", came_in, file.string()});
    EXPECT_EQ(result.exit_code, 0) << result.err;
  };
  ahead(wind_product(first + days(4), 96), "2025-03-08T04:50:00Z");
  ahead(wave_product(first + days(4), 96), "2025-03-08T04:50:00Z");
  const json made = forecast(store, at);
  EXPECT_EQ(made.at("degraded"), false) << made.at("headline");
  EXPECT_EQ(made.at("hindsight"), false);
  const json earlier = forecast(store, "2025-03-08T04:00:00Z");
  EXPECT_TRUE(contains(earlier.at("headline").get<std::string>(), "he last known wind is used"))
      << earlier.at("headline");
}

TEST(Replay, ASimulatedWindIsRefusedWhereItMeansNothing) {
  const StoreForTests store;
  for (const char* wind : {"best", "persist"}) {
    const ProgramResult result =
        store.run({"hindcast", "--site", store.site(), "--from", "2025-03-06", "--to", "2025-03-07",
                   "--wind", wind, "--simulate-wind"});
    EXPECT_EQ(result.exit_code, 2) << result.out;
    EXPECT_TRUE(contains(result.err, std::string("found --simulate-wind with --wind ") + wind))
        << result.err;
  }
}

TEST(Replay, HindsightIsRefusedWhereItMeansNothing) {
  StoreForTests store;
  store.ingest_days(first, 4);
  const ProgramResult result = store.run(
      {"forecast", "--site", store.site(), "--at", at, "--wind", "persist", "--hindsight"});
  EXPECT_EQ(result.exit_code, 2) << result.out;
  EXPECT_TRUE(contains(result.err, "--hindsight")) << result.err;
}

}  // namespace
}  // namespace slackwater::tests::cli_replay_test
