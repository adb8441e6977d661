// Whose values a forecast is made from, through the program: made-up products in a real store, the
// same whatever the order of ingest, and said before and after.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "fields/wind/log_profile.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_which_value_counts_test {
namespace {

using namespace std::chrono;
using nlohmann::json;

constexpr UtcDay first_day = sys_days{2025y / March / 3};
constexpr UtcDay day = sys_days{2025y / March / 9};
constexpr const char* five_o_clock = "2025-03-10T05:00:00Z";
constexpr const char* regional = "NWSHELF_ANALYSISFORECAST_PHY_004_013";
constexpr const char* global = "GLOBAL_ANALYSISFORECAST_PHY_001_024";

ProductForTests titled(ProductForTests product, const std::string& title) {
  product.title = title;
  return product;
}

/// The water without its tide and drift: what a product knows that has none.
ProductForTests still(ProductForTests product) {
  product.quantity("uo").value = [](const ProductCell&) { return 0.05; };
  product.quantity("vo").value = [](const ProductCell&) { return 0.02; };
  return product;
}

ProductForTests blowing(ProductForTests product, double east_m_s, double north_m_s) {
  product.quantity("eastward_wind").value = [=](const ProductCell&) { return east_m_s; };
  product.quantity("northward_wind").value = [=](const ProductCell&) { return north_m_s; };
  return product;
}

struct NamedProduct {
  std::string file;
  ProductForTests product;
};

class WhichValueCounts : public ::testing::Test {
 protected:
  static void ingest(StoreForTests& store, const NamedProduct& named,
                     const std::string& at = "2026-01-01T00:00:00Z") {
    const auto file = write_product(store.file(named.file), named.product);
    const ProgramResult result = store.run({"ingest", "--at", at, file.string()});
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
  static json ask(StoreForTests& store, std::vector<std::string> arguments) {
    arguments.emplace_back("--json");
    const ProgramResult result = store.run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.exit_code == 0 ? json::parse(result.out) : json::object();
  }
  static json forecast(StoreForTests& store, const std::vector<std::string>& more = {},
                       const std::string& at = five_o_clock) {
    std::vector<std::string> arguments{"forecast", "--site", store.site(), "--at", at};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return ask(store, arguments);
  }
  /// Of one quantity, in time.
  static std::vector<json> uses(const json& sources, const std::string& quantity) {
    std::vector<json> found;
    for (const json& use : sources)
      if (use["quantity"] == quantity) found.push_back(use);
    return found;
  }
  /// A week of hourly currents and winds.
  static std::vector<NamedProduct> week(const std::string& title) {
    return {{"currents-" + title + ".nc", titled(current_product(first_day, 7 * 24 + 1), title)},
            {"wind.nc", wind_product(first_day, 7 * 24)}};
  }
};

TEST_F(WhichValueCounts, TheOrderOfIngestPlaysNoPartAndSourcesSayTheSameBeforehand) {
  std::vector<NamedProduct> products = week(regional);
  products.push_back({"global.nc", titled(still(current_product(first_day, 7 * 24 + 1)), global)});
  products.push_back(
      {"other-wind.nc",
       blowing(titled(wind_product(first_day, 9 * 24), "weather of somebody"), -7, 3)});
  StoreForTests forwards;
  for (const NamedProduct& product : products) ingest(forwards, product);
  StoreForTests backwards;
  for (auto product = products.rbegin(); product != products.rend(); ++product)
    ingest(backwards, *product);
  const json before = ask(forwards, {"site", "sources", forwards.site(), "--at", five_o_clock});
  const auto page = forwards.file("page.html");
  const json one = forecast(forwards, {"--html", page.string()});
  const json two = forecast(backwards);
  const json& sources = one["columns"][0]["sources"];
  EXPECT_EQ(before["sources"], sources);
  EXPECT_NE(read_bytes(page).find(sources[0]["text"].get<std::string>()), std::string::npos)
      << "and on the page";
  EXPECT_EQ(two["columns"][0]["sources"], sources);
  EXPECT_EQ(one["columns"][0]["calibration"], two["columns"][0]["calibration"]);
  ASSERT_EQ(uses(sources, "current").size(), 1u) << sources.dump(1);
  EXPECT_EQ(uses(sources, "current")[0]["product"], regional);
  const auto winds = uses(sources, "wind");
  ASSERT_EQ(winds.size(), 2u) << "one after the other";
  EXPECT_EQ(winds[0]["product"], "WIND_GLO_PHY_L4_NRT_012_004");
  EXPECT_EQ(winds[0]["to"], "2025-03-09T23:00:00Z");
  EXPECT_EQ(winds[1]["from"], "2025-03-10T00:00:00Z");
}

TEST_F(WhichValueCounts, AWindGapIsNamedAndDegrades) {
  StoreForTests store;
  for (const NamedProduct& product : week(regional)) ingest(store, product);
  ingest(store, {"ahead.nc", wind_product(day + days(1), 24)});
  ingest(store, {"later.nc", blowing(wind_product(day + days(3), 24), -12, 9)});
  const json made = forecast(store, {"--hindsight"});
  EXPECT_TRUE(made["degraded"].get<bool>());
  const auto headline = made["headline"].get<std::string>();
  EXPECT_NE(headline.find("o wind is known from 2025-03-10T23:00:00Z to 2025-03-12T00:00:00Z"),
            std::string::npos)
      << headline;
}

TEST_F(WhichValueCounts, AnotherProductStandsInDegradedAndIsHeldAgainstTheLeadingOne) {
  StoreForTests store;
  ingest(store, {"regional.nc", titled(current_product(first_day, 3 * 24 + 1), regional)});
  ingest(store, {"global.nc", titled(still(current_product(first_day, 7 * 24 + 1)), global)});
  ingest(store, {"wind.nc", wind_product(first_day, 11 * 24)});
  const json made = forecast(store, {"--hindsight"});
  EXPECT_TRUE(made["degraded"].get<bool>());
  const auto headline = made["headline"].get<std::string>();
  EXPECT_NE(headline.find(std::string("leading product ") + regional), std::string::npos)
      << headline;
  EXPECT_NE(headline.find(std::string(global) + " is used instead"), std::string::npos) << headline;
  EXPECT_NE(made["stands_in_for"], "");
  // The leading product comes back: its days are the truth, and the stand-in is seen to be wrong.
  ingest(store, {"regional2.nc", titled(current_product(day + days(1), 25), regional)});
  const json skill = ask(store, {"verify", "--site", store.site()});
  ASSERT_FALSE(skill.empty());
  for (const json& entry : skill) {
    if (entry["method"] != "forecast" || entry["variable"] != "sea_water_velocity") continue;
    EXPECT_EQ(entry["truth"], regional);
    EXPECT_GT(entry["rmse_m_s"].get<double>(), 0.1) << "the tide that it lacks";
  }
}

TEST_F(WhichValueCounts, AReplaySeesWhatWasThereThen) {
  StoreForTests store;
  for (const NamedProduct& product : week(regional)) ingest(store, product, "2025-03-10T04:00:00Z");
  const json issued = forecast(store);
  // The provider rewrites D, and a newer wind run comes in.
  ProductForTests revised = titled(current_product(day, 25), regional);
  revised.quantity("uo").value = [](const ProductCell& cell) {
    return WaterForTests::eastward_m_s(cell) + 0.3;
  };
  ingest(store, {"revised.nc", revised}, "2025-03-11T04:00:00Z");
  ProductForTests ahead = wind_product(day + days(1), 72);
  ahead.reference_time = UtcTime(day + days(1));
  ingest(store, {"ahead.nc", ahead}, "2025-03-11T04:00:00Z");
  const json again = forecast(store);
  EXPECT_EQ(again["id"], issued["id"]) << again["headline"];
  EXPECT_TRUE(again["already_issued"].get<bool>());
  const json later = forecast(store, {"--day", "2025-03-09"}, "2025-03-11T05:00:00Z");
  EXPECT_NE(later["id"], issued["id"]);
  EXPECT_NE(later["columns"][0]["calibration"], issued["columns"][0]["calibration"]);
}

/// A steady easterly at these heights, named as ECMWF names them.
ProductForTests wind_at_heights(const std::vector<std::pair<std::string, double>>& heights) {
  ProductForTests product = wind_product(first_day, 7 * 24);
  product.title = "weather of somebody";
  product.quantities.clear();
  for (const auto& [height, east_m_s] : heights) {
    product.quantities.push_back({"u" + height, "eastward_wind", "m s-1", false,
                                  [east = east_m_s](const ProductCell&) { return east; }});
    product.quantities.push_back(
        {"v" + height, "northward_wind", "m s-1", false, [](const ProductCell&) { return 0.0; }});
  }
  return product;
}

TEST_F(WhichValueCounts, WindStatedAtTenMetresCountsAndAnotherHeightOnlyWhereThereIsNone) {
  const auto wind_of = [](const ProductForTests& product) {
    StoreForTests store;
    ingest(store, {"currents.nc", titled(current_product(first_day, 7 * 24 + 1), regional)});
    ingest(store, {"wind.nc", product});
    const json made = forecast(store, {"--out", store.file("f.nc").string()});
    const Snapshot snapshot = ingest::read_forecast(store.file("f.nc"));
    const std::vector<Horizontal>& winds = snapshot.columns[0].wind_m_s;
    for (const Horizontal wind : winds)
      EXPECT_NEAR(std::abs(wind - winds.front()), 0, 1e-5) << "one height at every hour";
    return std::pair(uses(made["columns"][0]["sources"], "wind").at(0), winds.front().real());
  };
  const auto [both, at_both] = wind_of(wind_at_heights({{"10", 8.0}, {"100", 15.0}}));
  EXPECT_TRUE(both["from_height_m"].is_null()) << both;
  EXPECT_NEAR(at_both, 8.0, 1e-5) << "single precision of the file";
  const auto [high, at_high] = wind_of(wind_at_heights({{"100", 15.0}}));
  EXPECT_EQ(high["from_height_m"], 100.0);
  EXPECT_NEAR(at_high, 15.0 * log_profile_ratio(10, 100), 1e-5);
}

TEST_F(WhichValueCounts, OfTwoHeightsInTwoFilesTenMetresSpeaksAloneWhateverTheOrderAndCadence) {
  ProductForTests low = wind_at_heights({{"10", 8.0}});
  low.time = hourly_times(first_day, 11 * 24);
  // Three-hourly: an hourly 100 m would stand in every gap, were gaps filled value by value.
  std::erase_if(low.time,
                [](UtcTime time) { return (time - UtcTime(first_day)) % hours(3) != Duration(0); });
  ProductForTests high = wind_at_heights({{"100", 15.0}});
  high.time = hourly_times(first_day, 11 * 24);
  const NamedProduct files[] = {{"low.nc", low}, {"high.nc", high}};
  std::vector<json> sources;
  for (const std::size_t first : {std::size_t{0}, std::size_t{1}}) {
    StoreForTests store;
    ingest(store, {"currents.nc", titled(current_product(first_day, 7 * 24 + 1), regional)});
    ingest(store, files[first]);
    ingest(store, files[1 - first]);
    const auto winds_at = [&](const std::string& time) {
      return uses(ask(store, {"site", "sources", store.site(), "--at", time})["sources"], "wind");
    };
    const auto at_six = winds_at("2025-03-10T06:00:00Z");
    ASSERT_EQ(at_six.size(), 1u) << "one height alone";
    EXPECT_TRUE(at_six[0]["from_height_m"].is_null());
    const auto at_five = winds_at("2025-03-10T05:00:00Z");
    ASSERT_EQ(at_five.size(), 2u) << "the other goes on after the last value at 10 m";
    EXPECT_EQ(at_five[0]["to"], "2025-03-10T03:00:00Z");
    EXPECT_EQ(at_five[1]["from_height_m"], 100.0);
    EXPECT_EQ(at_five[1]["from"], "2025-03-10T04:00:00Z");
    const json made = forecast(store, {"--hindsight", "--out", store.file("f.nc").string()});
    sources.push_back(made["columns"][0]["sources"]);
    ASSERT_EQ(uses(sources.back(), "wind").size(), 1u) << sources.back().dump(1);
    const Snapshot snapshot = ingest::read_forecast(store.file("f.nc"));
    ASSERT_EQ(snapshot.columns[0].wind_m_s.size(), 73u);
    for (std::size_t t = 0; t < 73; ++t) {
      EXPECT_NEAR(std::abs(snapshot.columns[0].wind_m_s[t] - Horizontal(8, 0)), 0, 1e-5)
          << "stamp " << t << ", single precision of the file";
    }
  }
  EXPECT_EQ(sources[0], sources[1]) << "the order of ingest";
}

TEST_F(WhichValueCounts, UnderForecastTheRunOfTheIssueMorningCounts) {
  StoreForTests store;
  for (const NamedProduct& product : week(regional)) ingest(store, product);
  for (const int run : {0, 1}) {  // issued at the end of D, and after the issue time
    ProductForTests ahead = wind_product(day + days(1), 96);
    ahead.reference_time = UtcTime(day + days(1)) + hours(12 * run);
    ingest(store, {"run" + std::to_string(run) + ".nc", ahead});
  }
  const json made = forecast(store, {"--wind", "forecast"}, "2025-03-10T05:00:00Z");
  const auto winds = uses(made["columns"][0]["sources"], "wind");
  ASSERT_EQ(winds.size(), 2u);
  EXPECT_EQ(winds[1]["run"], "forecast of 2025-03-10T00:00:00Z");
  const json later =
      forecast(store, {"--wind", "forecast", "--day", "2025-03-09"}, "2025-03-10T13:00:00Z");
  EXPECT_EQ(uses(later["columns"][0]["sources"], "wind").back()["run"],
            "forecast of 2025-03-10T12:00:00Z")
      << "not by the end of D";
}

TEST_F(WhichValueCounts, SourcesOfAStoreThatHoldsNothingForTheSiteSayWhatItHolds) {
  StoreForTests store;
  ingest(store, {"wind.nc", wind_product(first_day, 24)});
  const ProgramResult result =
      store.run({"site", "sources", store.site(), "--at", "2027-01-01T00:00:00Z"});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_NE(result.err.find("the store holds nothing"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace slackwater::tests::cli_which_value_counts_test
