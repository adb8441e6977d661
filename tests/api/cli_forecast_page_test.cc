// `forecast --html`: the page of any site, and how the option is refused.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/contains.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_forecast_page_test {
namespace {

using namespace std::chrono;

constexpr UtcDay day = sys_days{2025y / March / 6};
constexpr const char* at = "2025-03-09T05:00:00Z";  ///< after three days of data

TEST(ForecastHtml, IsAPageOfTheSiteThatOpensOffline) {
  const StoreForTests store;
  store.ingest_days(day, 3);
  const std::string file = store.file("page.html").string();
  const ProgramResult result = store.run({"forecast", "--site", store.site(), "--at", at, "--html",
                                          file, "--html-depth", "20", "--slack-below", "0.3"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string html = read_bytes(file);
  for (const char* words : {"At 20 m on Mon 10 Mar", "below 0.3 m/s", "Wind at 10 m", "Waves (Hs)",
                            "<details>", "How good it was", "id=\"report-data\""})
    EXPECT_TRUE(contains(html, words)) << words;
  for (const char* fetches : {"<link", "<script src", "@import"})
    EXPECT_FALSE(contains(html, fetches)) << fetches;
}

TEST(ForecastHtml, IsRefusedBeforeAnythingIsStored) {
  const StoreForTests store;
  store.ingest_days(day, 2);
  const auto digests = store.digests();
  const std::string folder = store.file("").string();
  for (const auto& [arguments, word] :
       std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"--html", "/nowhere/page.html"}, "/nowhere"},
           {{"--html", folder}, "folder"},
           {{"--html-depth", "10"}, "--html"},
           {{"--slack-below", "0.4"}, "--slack-below without --html"},
           {{"--html", store.file("p.html").string(), "--html-depth", "31"}, "30.0 m"},
           {{"--html", store.file("p.html").string(), "--slack-below", "0"}, "--slack-below"}}) {
    std::vector<std::string> command{"forecast", "--site", store.site(), "--at",
                                     "2025-03-08T05:00:00Z"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const ProgramResult result = store.run(command);
    EXPECT_EQ(result.exit_code, 2) << arguments.back() << result.err;
    EXPECT_TRUE(contains(result.err, word)) << result.err;
  }
  EXPECT_EQ(store.digests(), digests);
  EXPECT_FALSE(std::filesystem::exists(store.file("p.html")));
}

}  // namespace
}  // namespace slackwater::tests::cli_forecast_page_test
