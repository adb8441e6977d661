// The errors of own wave forecasts, gathered from what `verify` says of each.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "api/ask/windows/alpha_practice.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::api::verified_heights_test {
namespace {

using nlohmann::json;
using tests::StoreForTests;

TEST(VerifiedHeights, PoolWhatVerifySaysOfEachForecastByDayOfLead) {
  const StoreForTests made;
  made.ingest_days(parse_day("2025-03-01"), 6);
  const std::string site = made.site();
  for (const char* issued : {"2025-03-03T05:00:00Z", "2025-03-04T05:00:00Z"})
    ASSERT_EQ(
        made.run({"forecast", "--site", site, "--wind", "persist", "--day",
                  format_day(day_of(parse_utc(issued)) - std::chrono::days(1)), "--at", issued})
            .exit_code,
        0);
  const tests::ProgramResult verified = made.run({"verify", "--site", site, "--json"});
  ASSERT_EQ(verified.exit_code, 0) << verified.err;
  double pairs = 0, error = 0, squares = 0;
  std::size_t forecasts = 0;
  for (const json& entry : json::parse(verified.out)) {
    if (entry.at("variable") != "sea_surface_wave_significant_height" ||
        entry.at("method") != "forecast" || entry.at("lead_h") != json::array({0.0, 24.0}))
      continue;
    const auto n = entry.at("n").get<double>();
    pairs += n;
    error += n * entry.at("bias").get<double>();
    squares += n * entry.at("rmse").get<double>() * entry.at("rmse").get<double>();
    ++forecasts;
  }
  ASSERT_EQ(forecasts, 2U);
  const std::vector<twin::VerifiedHeights> found =
      verified_heights(find_site(site, {}), made.store(), 1);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].to_h, 24);
  EXPECT_EQ(found[0].forecasts, 2U);
  EXPECT_EQ(static_cast<double>(found[0].pairs), pairs);
  // What is printed is rounded to a tenth of a micrometre.
  EXPECT_NEAR(found[0].bias_m, error / pairs, 1e-6);
  EXPECT_NEAR(found[0].sigma_m * found[0].sigma_m + found[0].bias_m * found[0].bias_m,
              squares / pairs, 1e-6);
  EXPECT_GT(found[0].mean_height_m, 0.1);
  // Two are too few to put anything in the place of the published record.
  EXPECT_EQ(twin::with_verified(published_height_errors(), found).at(2, 12).sigma_m,
            published_height_errors().at(2, 12).sigma_m);
}

TEST(VerifiedHeights, AreNoneWhereNothingWasIssued) {
  const StoreForTests made;
  made.ingest_days(parse_day("2025-03-01"), 1);
  EXPECT_TRUE(verified_heights(find_site(made.site(), {}), made.store(), 1).empty());
}

}  // namespace
}  // namespace slackwater::api::verified_heights_test
