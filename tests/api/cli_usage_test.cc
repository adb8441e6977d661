// Command lines that make no sense: exit code 2, one line that says what was found, nothing done.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "api/door/cli/output_file.h"
#include "tests/support/contains.h"
#include "tests/support/error_of.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/refusal.h"
#include "tests/support/store_for_tests.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::cli_usage_test {
namespace {

using nlohmann::json;
using Arguments = std::vector<std::string>;

struct UsageCase {
  Arguments arguments;
  std::string word;  ///< of the error
};

std::vector<UsageCase> usage_cases(const std::string& site, const std::string& file) {
  const std::string time = "2025-03-08T05:00:00Z";
  return {
      {{}, "subcommand"},
      {{"frobnicate"}, "frobnicate"},
      {{"--frobnicate"}, "--frobnicate"},
      {{"forecast", "--site", site, "--frobnicate"}, "--frobnicate"},
      {{"forecast"}, "--site"},
      {{"forecast", "--site", site, "--at", "yesterday"}, "--at"},
      {{"forecast", "--site", site, "--at", "2025-03-08T05:00:00"}, "--at"},
      {{"forecast", "--site", site, "--at", time, "--wind", "nonsense"}, "nonsense"},
      {{"forecast", "--site", site, "--at", time, "--horizon", "junk"}, "--horizon"},
      {{"forecast", "--site", site, "--at", time, "--horizon", "-3h"}, "--horizon"},
      {{"forecast", "--site", site, "--at", time, "--horizon", "0h"}, "--horizon"},
      {{"forecast", "--site", site, "--at", time, "--horizon", "99d"}, "--horizon"},
      {{"forecast", "--site", site, "--day", "2025-02-30"}, "--day"},
      {{"serve", "--port", "70000"}, "--port"},
      {{"serve", "--base-url", "example.org"}, "--base-url"},
      {{"serve", "--base-url", "https://example.org/\"onload="}, "--base-url"},
      {{"serve", "--base-url", "https://example.org/?a"}, "--base-url"},
      {{"serve", "--stale-after", "soon"}, "--stale-after"},
      {{"serve", "--interface", "127.0.0.1"}, "--dds-domain"},
      {{"serve", "--dds-domain", "7", "--loopback", "--interface", "127.0.0.1"}, "--loopback"},
      {{"live", file, "--interface", "127.0.0.1"}, "--dds-domain"},
      {{"serve", "--stale-after", "0h"}, "--stale-after"},
      {{"forecast", "--site", site, "--at", time, "--day", "2025-03-08"}, "2025-03-08"},
      {{"forecast", "--site", site, "--day", "2999-01-01"}, "2999-01-01"},
      {{"ingest"}, "paths"},
      {{"ingest", file, "--bbox", "1,2,3"}, "--bbox"},
      {{"ingest", file, "--bbox", "1,2,3,x"}, "--bbox"},
      {{"ingest", file, "--bbox", "6,55,7,54"}, "--bbox"},
      {{"ingest", file, "--bbox", "6,53,7,54", "--site", site}, "--bbox"},
      {{"ingest", file, "--as", "nonsense"}, "nonsense"},
      {{"ingest", file, "--as", "forecast"}, "--issued"},
      {{"ingest", file, "--as", "analysis", "--issued", time}, "contradict"},
      {{"ingest", file, "--issued", "junk"}, "--issued"},
      {{"profile", "--site", site}, "--time"},
      {{"forecast", "--site", site, "--history", "60d"}, "--history without --print-downloads"},
      {{"forecast", "--site", site, "--print-downloads", "--history", "2d"}, "expected 3d to 730d"},
      {{"forecast", "--site", site, "--print-downloads", "--history", "731d"},
       "found --history 731d"},
      {{"forecast", "--site", site, "--print-downloads", "--history", "60"}, "--history"},
      {{"profile", "--time", time}, "--site"},
      {{"profile", "--site", site, "--time", "noon"}, "--time"},
      {{"profile", "--lat", "54", "--time", time}, "--lon"},
      {{"profile", "--lat", "95", "--lon", "6", "--time", time}, "--lat"},
      {{"profile", "--site", site, "--time", time, "--depth", "deep"}, "--depth"},
      {{"profile", "--site", site, "--time", time, "--depth", "nan"}, "--depth"},
      {{"profile", "--site", site, "--time", time, "--csv", "--json"}, "--csv"},
      {{"hindcast", "--site", site, "--from", "2025-03-07", "--to", "2025-03-06"}, "--from"},
      {{"hindcast", "--site", site, "--from", "2025-03-06", "--to", "2025-03-06", "--horizon",
        "0h"},
       "--horizon"},
      {{"hindcast", "--site", site, "--from", "2025-03-06", "--to", "2025-03-06", "--latency", "x"},
       "--latency"},
      {{"hindcast", "--site", site, "--from", "soon", "--to", "2025-03-06"}, "--from"},
      {{"verify", "--site", site, "--bands", "5"}, "bands"},
      {{"verify", "--site", site, "--bands", "50,5"}, "bands"},
      {{"verify", "--site", site, "--levels", "mine"}, "--levels"},
      {{"verify", "--site", site, "--from", "junk"}, "--from"},
      {{"ais"}, "file"},
      {{"ais", file, "--bbox", "1,2,3"}, "--bbox"},
      {{"ais", file, "--bbox", "6,55,7,54"}, "--bbox"},
      {{"ais", file, "--from", "noon"}, "--from"},
      {{"ais", file, "--from", time, "--to", "2025-03-08T04:00:00Z"}, "--from"},
      {{"ais", file, "--mmsi", "ship"}, "--mmsi"},
      {{"store"}, "subcommand"},
      {{"store", "burn"}, "burn"},
      {{"store", "prune"}, "--older-than"},
      {{"store", "prune", "--older-than", "junk"}, "--older-than"},
      {{"site", "check"}, "site"},
  };
}

std::string joined(const Arguments& arguments) {
  std::string line = "slackwater";
  for (const std::string& argument : arguments) line += " " + argument;
  return line;
}

TEST(Usage, NonsenseIsToldInOneLineWithExitCodeTwoAndChangesNothing) {
  const StoreForTests store;
  const UtcDay day = std::chrono::sys_days{std::chrono::year{2025} / 3 / 6};
  store.ingest_days(day, 2);
  const std::string file =
      write_product(store.file("more.nc"), current_product(day + std::chrono::days(2))).string();
  const auto digests = store.digests();
  for (const UsageCase& c : usage_cases(store.site(), file)) {
    const ProgramResult result = store.run(c.arguments);
    SCOPED_TRACE(joined(c.arguments) + "\n" + result.err);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_TRUE(contains(result.err, c.word)) << "does not name " << c.word;
    EXPECT_EQ(result.err.rfind("slackwater: ", 0), 0U);
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1);
  }
  EXPECT_EQ(store.digests(), digests);
}

/// Before, only `sample --out` looked at the name: a forecast went into `today.csv` as NetCDF, a
/// page into `run.nc`.
TEST(Usage, AnOutputFileOfTheWrongKindIsRefusedByEveryCommandInTheSameWords) {
  const StoreForTests store;
  const UtcDay day = std::chrono::sys_days{std::chrono::year{2025} / 3 / 6};
  store.ingest_days(day, 1);
  const std::string folder = store.file("").string();
  const std::string points = store.file("points.csv").string();
  write_bytes(points, "lat,lon\n48.85,-2.55\n");
  const std::vector<std::pair<Arguments, std::string>> outputs{
      {{"forecast", "--site", store.site(), "--at", "2025-03-08T05:00:00Z", "--out"}, ".nc"},
      {{"sample", "--site", store.site(), "--points", points, "--out"}, ".nc or .csv"},
      {{"verify", "--site", store.site(), "--html"}, ".html"},
      {{"verify", "--site", store.site(), "--csv"}, ".csv"},
      {{"hindcast", "--site", store.site(), "--from", "2025-03-06", "--to", "2025-03-06", "--html"},
       ".html"},
      {{"hindcast", "--site", store.site(), "--from", "2025-03-06", "--to", "2025-03-06", "--csv"},
       ".csv"},
      {{"simulate", "none.yaml", "--out"}, ".nc"},
      {{"simulate", "none.yaml", "--html"}, ".html"},
      {{"simulate", "none.yaml", "--csv"}, ".csv"},
      {{"replay", "none.nc", "--html"}, ".html"},
      {{"replay", "none.nc", "--csv"}, ".csv"},
      {{"ais", "none.log", "--csv"}, ".csv"}};
  const auto digests = store.digests();
  for (const auto& [command, endings] : outputs) {
    const std::string file = folder + "/out.txt";
    Arguments arguments = command;
    arguments.push_back(file);
    SCOPED_TRACE(joined(arguments));
    expect_refusal(store.run(arguments), 2,
                   {command.back() + " " + file, "expected a file name that ends in " + endings});
    EXPECT_FALSE(std::filesystem::exists(file));
  }
  EXPECT_EQ(store.digests(), digests);
}

TEST(ExpectOutput, AsksForTheEndingAndTheFolder) {
  const TemporaryFolder folder;
  const auto said = [&](const std::string& name) {
    return error_of([&] { return api::expect_output("--out", folder / name, {".nc", ".csv"}), 0; });
  };
  for (const char* name : {"out.nc", "out.csv"}) EXPECT_EQ(said(name), "no error");
  for (const char* name : {"out.txt", "out", ".nc"})
    EXPECT_TRUE(contains(said(name), "expected a file name that ends in .nc or .csv"));
  EXPECT_TRUE(contains(said("no/such/out.nc"), "found no folder"));
  EXPECT_TRUE(contains(said(""), "which is a folder"));
}

TEST(Usage, WithJsonTheErrorIsOneDocumentThatSaysTheSameAsStandardError) {
  const StoreForTests store;
  for (const auto& [arguments, kind] : std::vector<std::pair<Arguments, std::string>>{
           {{"forecast", "--site", store.site(), "--horizon", "junk"}, "usage"},
           {{"store", "list"}, "not_found"},
           {{"ingest", "/nowhere/absent.nc"}, "not_found"}}) {
    Arguments with_json = arguments;
    with_json.emplace_back("--json");
    const ProgramResult result = store.run(with_json);
    ASSERT_TRUE(json::accept(result.out)) << joined(arguments) << ": " << result.out;
    const json error = json::parse(result.out).at("error");
    EXPECT_EQ(error.at("kind"), kind) << joined(arguments);
    EXPECT_EQ("slackwater: " + error.at("message").get<std::string>() + "\n", result.err);
  }
}

TEST(Help, OfEveryCommandExitsWithZeroAndNamesItsOptions) {
  const std::vector<std::pair<Arguments, std::vector<std::string>>> commands{
      {{},
       {"ingest", "forecast", "hindcast", "profile", "verify", "store", "site", "demo", "--store",
        "--json", "Exit codes"}},
      {{"ingest"}, {"--as", "--issued", "--bbox", "--site"}},
      {{"ais"}, {"--bbox", "--from", "--to", "--mmsi", "--csv"}},
      {{"serve"}, {"--port", "--stale-after"}},
      {{"simulate"}, {"--out", "--html", "--csv"}},
      {{"forecast"},
       {"--site", "--day", "--horizon", "--wind", "--out", "--html", "--html-depth",
        "--slack-below", "--at", "--print-downloads", "--history"}},
      {{"hindcast"}, {"--site", "--from", "--to", "--wind", "--latency", "--full"}},
      {{"profile"},
       {"--site", "--lat", "--lon", "--time", "--from", "--to", "--step", "--depth", "--csv",
        "--member", "--members"}},
      {{"verify"}, {"--site", "--from", "--to", "--bands", "--levels", "--full"}},
      {{"store"}, {"check", "list", "prune"}},
      {{"store", "check"}, {"--quick"}},
      {{"store", "list"}, {"--site", "--forecasts"}},
      {{"store", "prune"}, {"--older-than", "--forecasts", "--orphans", "--dry-run"}},
      {{"site"}, {"init", "check", "list"}},
      {{"site", "init"}, {"--lat", "--lon", "--name", "--id", "--depth", "--timezone"}},
      {{"site", "check"}, {"site"}},
      {{"demo"}, {"--out", "--force"}},
  };
  for (const auto& [command, words] : commands) {
    Arguments arguments = command;
    arguments.emplace_back("--help");
    const ProgramResult result = run_program(arguments);
    EXPECT_EQ(result.exit_code, 0) << joined(arguments);
    EXPECT_TRUE(result.err.empty()) << result.err;
    for (const std::string& word : words)
      EXPECT_TRUE(contains(result.out, word)) << word << " in " << joined(arguments);
  }
  EXPECT_EQ(run_program({"--version"}).exit_code, 0);
}

}  // namespace
}  // namespace slackwater::tests::cli_usage_test
