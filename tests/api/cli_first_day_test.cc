// The mistakes of a first day: each has its own sentence, and what was asked for is found.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/contains.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/refusal.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_first_day_test {
namespace {

using namespace std::chrono;
using nlohmann::json;

constexpr UtcDay day = sys_days{2025y / March / 6};
constexpr const char* at = "2025-03-08T05:00:00Z";

/// Two days of water at 54.0 N 6.5 E.
class FirstDay : public ::testing::Test {
 protected:
  FirstDay() { store_.ingest_days(day, 2); }

  /// Runs a command that is refused; every word is in its one sentence.
  void expect_refused(const std::vector<std::string>& arguments, int exit_code,
                      const std::vector<std::string>& words) const {
    SCOPED_TRACE(arguments.front());
    expect_refusal(store_.run(arguments), exit_code, words);
  }

  StoreForTests store_;
};

TEST_F(FirstDay, UnknownCommandsOptionsAndSitesNameTheNearestKnownOne) {
  expect_refused({"forcast", "--site", "x"}, 2, {"forcast", "did you mean 'forecast'"});
  expect_refused({"store", "lst"}, 2, {"lst", "did you mean 'list'"});
  expect_refused({"forecast", "--site", store_.site(), "--horizn", "24h"}, 2,
                 {"--horizn", "did you mean '--horizon'"});
  expect_refused({"forecast", "--site", store_.site(), "--horizn=24h"}, 2,
                 {"did you mean '--horizon'"});
  expect_refused({"forecast", "--site", "saint_brieux", "--at", at}, 4,
                 {"did you mean 'saint_brieuc'"});
}

TEST_F(FirstDay, AFolderGivenForAFileIsCalledAFolder) {
  const std::string folder = store_.file("").string();
  expect_refused({"forecast", "--site", folder, "--at", at}, 3, {"folder", "YAML"});
  expect_refused({"forecast", "--site", store_.site(), "--at", at, "--out", folder}, 2,
                 {"folder", "--out"});
  expect_refused({"simulate", folder, "--out", store_.file("run.nc").string()}, 3,
                 {"folder", "YAML"});
  expect_refused({"sample", "--site", store_.site(), "--points", folder, "--out",
                  store_.file("s.csv").string()},
                 3, {"folder", "points"});
}

TEST_F(FirstDay, ADecimalCommaIsReadBackWithAPoint) {
  expect_refused({"profile", "--lat", "48,85", "--lon", "6", "--time", at}, 2,
                 {"48,85", "write 48.85"});
  write_bytes(store_.file("comma.yaml"), "id: a\nlatitude_deg: 48,85\nlongitude_deg: 6\n");
  expect_refused({"site", "check", store_.file("comma.yaml").string()}, 3,
                 {"latitude_deg", "48,85", "write 48.85"});
}

TEST_F(FirstDay, ATimeWithoutItsZoneIsNeverGuessed) {
  for (const auto& [text, advice] : std::vector<std::pair<std::string, std::string>>{
           {"2025-03-08T05:00:00", "it may be local time"},
           {"2025-03-08 05:00", "write 2025-03-08T05:00:00Z"},
           {"2025-03-08T05:00:00+01:00", "in UTC it is 2025-03-08T04:00:00Z"},
           {"2025-03-08T05:00-0330", "in UTC it is 2025-03-08T08:30:00Z"},
           {"2025-03-08", "write the hour too"}})
    expect_refused({"forecast", "--site", store_.site(), "--at", text}, 2, {"--at", text, advice});
}

TEST_F(FirstDay, ASwappedPlaceIsAskedAboutAndAFarOneIsToldWhatTheStoreCovers) {
  const auto swapped = write_site(store_.file("swapped.yaml"), "", 6.5, 54.0);
  expect_refused({"forecast", "--site", swapped.string(), "--at", at}, 4,
                 {"did you swap latitude and longitude?"});
  const auto far = write_site(store_.file("far.yaml"), "", -20, 100);
  const ProgramResult result = store_.run({"forecast", "--site", far.string(), "--at", at});
  EXPECT_FALSE(contains(result.err, "swap")) << result.err;
  EXPECT_TRUE(contains(result.err, "currents cover 53.75 to 54.25 N")) << result.err;
}

TEST_F(FirstDay, ASwappedPointOfAProfileIsAskedAbout) {
  ASSERT_EQ(store_.run({"forecast", "--site", store_.site(), "--at", at}).exit_code, 0);
  expect_refused({"profile", "--lat", "6.5", "--lon", "54", "--time", "2025-03-08T09:00:00Z"}, 4,
                 {"did you swap --lat and --lon?"});
}

TEST_F(FirstDay, WhenNothingIsHeldForATimeItSaysWhatIsAndTheAdviceWorks) {
  expect_refused({"forecast", "--site", store_.site(), "--at", "2026-11-01T05:00:00Z"}, 4,
                 {"currents from 2025-03-06T00:00:00Z", "wind from", "waves from",
                  "--day 2025-03-07", "--at 2025-03-08T05:00:00Z"});
  EXPECT_EQ(store_.run({"forecast", "--site", store_.site(), "--at", at}).exit_code, 0);
  EXPECT_EQ(store_.run({"forecast", "--site", store_.site(), "--day", "2025-03-07"}).exit_code, 0);
}

TEST_F(FirstDay, AnEmptyStoreSaysThatItIs) {
  const StoreForTests other;
  other.ingest(write_product(other.file("b.nc"), bathymetry_product()));
  const ProgramResult result = other.run({"forecast", "--site", other.site(), "--at", at});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_TRUE(contains(result.err, "no currents, wind or waves at all"));
  EXPECT_TRUE(contains(result.err, "--print-downloads")) << "what to fetch";
}

TEST_F(FirstDay, SiteInitWritesASiteThatForecasts) {
  store_.ingest(write_product(store_.file("bathymetry.nc"), bathymetry_product()));
  const ProgramResult made =
      store_.run({"site", "init", "--lat", "54.05", "--lon", "6.45", "--name",
                  "Parc \"Nord\", bloc 2", "--timezone", "Europe/Berlin"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const auto file = store_.store() / "sites" / "parc_nord_bloc_2.yaml";
  const std::string yaml = read_bytes(file);
  EXPECT_TRUE(contains(yaml, "water_depth_m: 30.0  # from the bathymetry in the store")) << yaml;
  const ProgramResult list = store_.run({"site", "list"});
  EXPECT_TRUE(contains(list.out, "parc_nord_bloc_2") && contains(list.out, "Parc \"Nord\", bloc 2"))
      << list.out;
  const ProgramResult issued = store_.run({"forecast", "--site", "parc_nord_bloc_2", "--at", at});
  ASSERT_EQ(issued.exit_code, 0) << issued.err;
  EXPECT_TRUE(contains(issued.out, "Europe/Berlin") && contains(issued.out, "2025-03-08 01:00 CET"))
      << issued.out;
  // Nothing is written over.
  expect_refused({"site", "init", "--lat", "54", "--lon", "6.5", "--name", "Parc Nord Bloc 2"}, 2,
                 {"parc_nord_bloc_2", "already"});
  EXPECT_EQ(read_bytes(file), yaml);
}

TEST_F(FirstDay, SiteInitRefusesWhatCannotBeASite) {
  expect_refused({"site", "init", "--lat", "6.5", "--lon", "400", "--name", "a"}, 2, {"400"});
  expect_refused({"site", "init", "--lat", "100", "--lon", "48", "--name", "a"}, 2,
                 {"did you swap --lat and --lon?"});
  expect_refused({"site", "init", "--lat", "54", "--lon", "6.5", "--name", "…"}, 2, {"--id"});
  expect_refused({"site", "init", "--lat", "54", "--lon", "6.5", "--name", "a", "--id", "../a"}, 3,
                 {"id"});
  expect_refused(
      {"site", "init", "--lat", "54", "--lon", "6.5", "--name", "a", "--timezone", "Europe/Berlim"},
      2, {"--timezone", "did you mean 'Europe/Berlin'"});
  EXPECT_FALSE(std::filesystem::exists(store_.store() / "sites"));
}

TEST_F(FirstDay, AnUnknownZoneInASiteNamesTheLineAndTheNearestZone) {
  const auto site = write_site(store_.file("zone.yaml"), "timezone: Europe/Pari\n");
  expect_refused({"site", "check", site.string()}, 3, {"timezone", "did you mean 'Europe/Paris'"});
}

TEST_F(FirstDay, StoreListShowsOneSiteOrForecastsAlone) {
  ASSERT_EQ(store_.run({"forecast", "--site", store_.site(), "--at", at}).exit_code, 0);
  const json all = json::parse(store_.run({"store", "list", "--json"}).out);
  const json near =
      json::parse(store_.run({"store", "list", "--site", store_.site(), "--json"}).out);
  EXPECT_EQ(near, all);
  write_bytes(store_.file("elsewhere.yaml"),
              "id: elsewhere\nlatitude_deg: -20\nlongitude_deg: 100\n");
  const json far = json::parse(
      store_.run({"store", "list", "--site", store_.file("elsewhere.yaml").string(), "--json"})
          .out);
  EXPECT_TRUE(far["sources"].empty() && far["granules"].empty() && far["forecasts"].empty()) << far;
  const ProgramResult forecasts = store_.run({"store", "list", "--forecasts"});
  EXPECT_TRUE(contains(forecasts.out, "1 forecasts") && !contains(forecasts.out, "product files"))
      << forecasts.out;
}

TEST_F(FirstDay, PruneDryRunSaysWhatWouldGoAndRemovesNothing) {
  ASSERT_EQ(store_.run({"forecast", "--site", store_.site(), "--at", at}).exit_code, 0);
  const auto digests = store_.digests();
  const std::vector<std::string> prune{"store",      "prune",       "--older-than",
                                       "2100-01-01", "--forecasts", "--json"};
  std::vector<std::string> dry = prune;
  dry.emplace_back("--dry-run");
  json would = json::parse(store_.run(dry).out);
  EXPECT_EQ(store_.digests(), digests);
  json did = json::parse(store_.run(prune).out);
  EXPECT_TRUE(would["dry_run"].get<bool>());
  EXPECT_FALSE(did["dry_run"].get<bool>());
  for (const char* key : {"sources", "granules", "forecasts", "content_files", "bytes"}) {
    EXPECT_EQ(would[key], did[key]) << key;
    EXPECT_GT(did[key].get<std::int64_t>(), 0) << key;
  }
}

TEST_F(FirstDay, ProfileAnswersARangeAsItAnswersEachOfItsTimes) {
  ASSERT_EQ(store_.run({"forecast", "--site", store_.site(), "--at", at}).exit_code, 0);
  const std::string site = store_.site();
  const json range =
      json::parse(store_
                      .run({"profile", "--site", site, "--from", "2025-03-08T06:00:00Z", "--to",
                            "2025-03-08T12:00:00Z", "--step", "3h", "--json"})
                      .out);
  ASSERT_EQ(range["profiles"].size(), 3U);
  const json one = json::parse(
      store_.run({"profile", "--site", site, "--time", "2025-03-08T09:00:00Z", "--json"}).out);
  EXPECT_EQ(range["profiles"][1]["time"], one["time"]);
  EXPECT_EQ(range["profiles"][1]["levels"], one["levels"]);
  EXPECT_EQ(range["issued"], one["issued"]);
  const ProgramResult csv = store_.run({"profile", "--site", site, "--from", "2025-03-08T06:00:00Z",
                                        "--to", "2025-03-08T12:00:00Z", "--depth", "10", "--csv"});
  EXPECT_EQ(std::count(csv.out.begin(), csv.out.end(), '\n'), 8) << csv.out;
  expect_refused({"profile", "--site", site, "--from", "2025-03-08T06:00:00Z", "--to",
                  "2025-04-08T06:00:00Z", "--step", "24h"},
                 4, {"2025-03-11T00:00:00Z"});
  expect_refused({"profile", "--site", site, "--time", at, "--from", at}, 2, {"--time", "--from"});
  expect_refused({"profile", "--site", site, "--from", at}, 2, {"--to"});
  expect_refused({"profile", "--site", site, "--from", at, "--to", at, "--step", "0h"}, 2,
                 {"--step"});
}

TEST_F(FirstDay, NowIsATime) {
  ASSERT_EQ(store_.run({"forecast", "--site", store_.site(), "--at", at}).exit_code, 0);
  expect_refused({"profile", "--site", store_.site(), "--time", "now"}, 4,
                 {"valid from 2025-03-08T00:00:00Z"});
}

TEST_F(FirstDay, VerifyPrintsOneVerdictAndOneTableAndTheRestWhenAsked) {
  ASSERT_EQ(store_.run({"forecast", "--site", store_.site(), "--at", at}).exit_code, 0);
  store_.ingest_days(day + days(2), 2);
  const ProgramResult brief = store_.run({"verify", "--site", store_.site()});
  ASSERT_EQ(brief.exit_code, 0) << brief.err;
  EXPECT_LE(std::count(brief.out.begin(), brief.out.end(), '\n'), 20) << brief.out;
  EXPECT_TRUE(contains(brief.out, "\n > forecast ")) << "the method's row is marked: " << brief.out;
  EXPECT_TRUE(contains(brief.out, "--full"));
  const ProgramResult full = store_.run({"verify", "--site", store_.site(), "--full"});
  EXPECT_TRUE(contains(full.out, "0-5 m")) << full.out;
  EXPECT_GT(full.out.size(), 3 * brief.out.size());
}

}  // namespace
}  // namespace slackwater::tests::cli_first_day_test
