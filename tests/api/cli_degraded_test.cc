// Late or missing inputs degrade, never silence: the forecast is made, says what was missing, and
// reaches as far.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/contains.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_degraded_test {
namespace {

using namespace std::chrono;
using nlohmann::json;

constexpr UtcDay day = sys_days{2025y / March / 6};

class Degraded : public ::testing::Test {
 protected:
  void ingest(const std::string& name, const ProductForTests& product) {
    store_.ingest(write_product(store_.file(name), product));
  }
  void ingest_currents(int days_of_data) {
    for (int i = 0; i < days_of_data; ++i)
      ingest("currents" + std::to_string(i) + ".nc", current_product(day + days(i)));
  }
  void ingest_wind_and_waves(int days_of_data) {
    for (int i = 0; i < days_of_data; ++i) {
      ingest("wind" + std::to_string(i) + ".nc", wind_product(day + days(i)));
      ingest("waves" + std::to_string(i) + ".nc", wave_product(day + days(i)));
    }
  }

  json forecast(const std::string& at, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"forecast", "--site", store_.site(), "--at", at, "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramResult result = store_.run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.exit_code == 0
               ? json::parse(result.out)
               : json{{"degraded", false}, {"headline", ""}, {"day", ""}, {"valid_to", ""}};
  }
  /// Degraded, with these words on its face: in the answer, the listing and the profile.
  void expect_degraded(const json& forecast, const std::vector<std::string>& words) {
    EXPECT_TRUE(forecast["degraded"].get<bool>()) << forecast["headline"];
    const auto headline = forecast["headline"].get<std::string>();
    for (const std::string& word : words)
      EXPECT_TRUE(contains(headline, word)) << word << " in: " << headline;
    const json row = json::parse(store_.listing())["forecasts"].back();
    EXPECT_EQ(row["degraded"], true);
    EXPECT_EQ(row["headline"], headline);
  }

  StoreForTests store_;
};

TEST_F(Degraded, WithAWindForecastNothingIsMissingAndNothingIsSaidToBe) {
  ingest_currents(2);
  ingest_wind_and_waves(2);
  for (ProductForTests product :
       {wind_product(day + days(2), 96), wave_product(day + days(2), 96)}) {
    product.reference_time = UtcTime(day + days(2));
    ingest("ahead-" + product.quantities[0].name + ".nc", product);
  }
  const json made = forecast("2025-03-08T05:00:00Z");
  EXPECT_FALSE(made["degraded"].get<bool>()) << made["headline"];
}

TEST_F(Degraded, NoWindDropsTheWindDrivenPartAndSaysSo) {
  ingest_currents(2);
  const json made = forecast("2025-03-08T05:00:00Z");
  expect_degraded(made, {"wind"});
  EXPECT_FALSE(made["columns"][0]["calibration"]["wind_used"].get<bool>());
}

TEST_F(Degraded, NoWindForecastIsNamed) {
  ingest_currents(2);
  ingest_wind_and_waves(2);
  expect_degraded(forecast("2025-03-08T05:00:00Z"), {"he last known wind is used"});
}

/// The wind product with all of it times a factor.
ProductForTests wind_times(UtcDay first, int hours, double factor) {
  ProductForTests product = wind_product(first, hours);
  for (ProductQuantity& q : product.quantities)
    q.value = [value = q.value, factor](const ProductCell& cell) { return factor * value(cell); };
  return product;
}

TEST_F(Degraded, ACalmWithoutAnyWaveProductIsCalmWaterAndSaysWhereThatComesFrom) {
  ingest_currents(3);
  ingest("calm.nc", wind_times(day, 24 * 7, 0.01));
  const json made = forecast("2025-03-09T05:00:00Z");
  expect_degraded(made, {"computed from the wind alone", "fetch of 200 km is assumed"});
  EXPECT_EQ(made["waves"]["source"], "computed from the wind");
  EXPECT_EQ(made["waves"]["computed"]["highest_m"], 0.0);
  EXPECT_EQ(made["failed"], json::array());
  EXPECT_FALSE(made["columns"][0]["calibration"].is_null()) << "the current is forecast";
  const ProgramResult profile =
      store_.run({"profile", "--site", store_.site(), "--time", "2025-03-10T12:00:00Z", "--json"});
  ASSERT_EQ(profile.exit_code, 0) << profile.err;
  const json waves = json::parse(profile.out)["waves"];
  EXPECT_EQ(waves["sea_surface_wave_significant_height"], 0.0);
  EXPECT_EQ(waves["source"], "computed from the wind");
  const ProgramResult hindcast = store_.run(
      {"hindcast", "--site", store_.site(), "--from", "2025-03-07", "--to", "2025-03-08"});
  EXPECT_EQ(hindcast.exit_code, 0) << hindcast.err;
}

TEST_F(Degraded, WavesOfTheWindAreToldInTableProfileAndFile) {
  ingest_currents(2);
  for (int i = 0; i < 6; ++i)
    ingest("wind" + std::to_string(i) + ".nc", wind_product(day + days(i)));
  const ProgramResult table =
      store_.run({"forecast", "--site", store_.site(), "--at", "2025-03-08T05:00:00Z"});
  ASSERT_EQ(table.exit_code, 0) << table.err;
  EXPECT_TRUE(contains(table.out, "o wave product is stored: the waves are computed from the wind"))
      << table.out;
  EXPECT_TRUE(contains(table.out, "Waves: computed from the wind.")) << table.out;
  EXPECT_TRUE(contains(table.out, "  computed from the wind\n"))
      << "and in each row: " << table.out;
  const ProgramResult profile =
      store_.run({"profile", "--site", store_.site(), "--time", "2025-03-08T12:00:00Z"});
  EXPECT_TRUE(contains(profile.out, "(computed from the wind)")) << profile.out;
}

TEST_F(Degraded, APastForecastThatCannotBeReadTakesNothingFromTheNewOneAndIsNamed) {
  ingest_currents(3);
  ingest_wind_and_waves(3);
  forecast("2025-03-07T05:00:00Z");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(store_.store())) {
    // The only forecast there is; product files keep what they are.
    if (!entry.is_regular_file()) continue;
    const std::string bytes = read_bytes(entry.path());
    if (!contains(bytes, "slackwater_headline")) continue;
    std::filesystem::permissions(entry.path(), std::filesystem::perms::owner_write,
                                 std::filesystem::perm_options::add);
    write_bytes(entry.path(), "not a forecast any more");
  }
  const ProgramResult result =
      store_.run({"forecast", "--site", store_.site(), "--at", "2025-03-09T05:00:00Z", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json made = json::parse(result.out);
  EXPECT_TRUE(contains(made["verified"], "could not be scored: forecast 1 of site test_site"))
      << made["verified"];
  EXPECT_TRUE(made["verdict"].is_null());
  const json listed = json::parse(store_.listing())["forecasts"];
  ASSERT_EQ(listed.size(), 2u);
  EXPECT_EQ(listed.back()["id"], made["id"]);
}

TEST_F(Degraded, AMissingDayFallsBackToTheLastGoodOneAndStillReachesAsFar) {
  ingest_currents(2);
  ingest_wind_and_waves(3);
  const json made = forecast("2025-03-09T05:00:00Z", {"--day", "2025-03-08"});
  expect_degraded(made, {"2025-03-08", "2025-03-07"});
  EXPECT_EQ(made["day"], "2025-03-07");
  EXPECT_EQ(made["valid_to"], "2025-03-12T00:00:00Z") << "72 h beyond the day asked for";
}

TEST_F(Degraded, AProviderMoreThanADayLateIsNamedWithoutBeingAskedForADay) {
  ingest_currents(2);
  ingest_wind_and_waves(2);
  const json usual =
      forecast("2025-03-09T05:00:00Z");  // the newest analysed day is X-2, as it often is
  EXPECT_FALSE(contains(usual["headline"].get<std::string>(), "missing")) << usual["headline"];
  const json late = forecast("2025-03-12T05:00:00Z");
  expect_degraded(late, {"2025-03-07", "missing"});
  EXPECT_EQ(late["valid_to"], "2025-03-14T00:00:00Z")
      << "72 h beyond the day that should have been there";
}

TEST_F(Degraded, WindAndWavesAloneAreForecastWithoutACurrent) {
  ingest_wind_and_waves(2);
  const json made = forecast("2025-03-08T05:00:00Z");
  expect_degraded(made, {"current", "wind and waves"});
  const ProgramResult profile =
      store_.run({"profile", "--site", store_.site(), "--time", "2025-03-08T12:00:00Z", "--json"});
  EXPECT_EQ(profile.exit_code, 0) << profile.err;
  const json answer = json::parse(profile.out);
  for (const json& level : answer.at("levels")) {
    EXPECT_NE(level["status"], "ok") << "a missing current is a status, never calm water";
  }
}

TEST_F(Degraded, AWeekOldStoreStillAnswersAndATooOldOneSaysSo) {
  ingest_currents(2);
  ingest_wind_and_waves(2);
  expect_degraded(forecast("2025-03-15T05:00:00Z"), {"2025-03-07"});
  for (const char* at : {"2025-04-20T05:00:00Z", "2026-03-01T05:00:00Z"}) {
    const ProgramResult result = store_.run({"forecast", "--site", store_.site(), "--at", at});
    EXPECT_EQ(result.exit_code, 4) << result.out;
    EXPECT_TRUE(contains(result.err, "ingest")) << result.err;
  }
}

TEST_F(Degraded, ADamagedStoredFileIsLeftOutNamedAndMendedByIngestingItAgain) {
  ingest_currents(2);
  ingest_wind_and_waves(2);
  const auto content_of = [&](const std::string& product_file) {
    const json list = json::parse(store_.listing());
    for (const json& source : list["sources"]) {
      if (source["name"] != product_file) continue;
      for (const json& granule : list["granules"]) {
        if (granule["source_sha256"] != source["sha256"]) continue;
        const auto sha256 = granule["content_sha256"].get<std::string>();
        return store_.store() / "files" / sha256.substr(0, 2) / (sha256 + ".nc");
      }
    }
    return std::filesystem::path();
  };
  const json whole = forecast("2025-03-08T05:00:00Z");
  int minute = 1;
  for (const char* name : {"waves1.nc", "wind1.nc", "currents0.nc"}) {
    const auto content = content_of(name);
    std::string bytes = read_bytes(content);
    bytes.insert(bytes.begin() + 700, 'x');  // some such bytes crash the library that reads them
    write_bytes(content, bytes);
    expect_degraded(forecast("2025-03-08T05:0" + std::to_string(minute++) + ":00Z"),
                    {name, "is damaged and left out", "slackwater store check"});
    const ProgramResult again = store_.run({"ingest", store_.file(name).string(), "--json"});
    ASSERT_EQ(again.exit_code, 0) << again.err;
    EXPECT_TRUE(json::parse(again.out)["files"][0]["repaired"].get<bool>()) << again.out;
    const json mended = forecast("2025-03-08T05:0" + std::to_string(minute++) + ":00Z");
    EXPECT_FALSE(contains(mended["headline"].get<std::string>(), "damaged")) << mended["headline"];
    EXPECT_EQ(mended["degraded"], whole["degraded"]);
  }
}

TEST_F(Degraded, NothingButDamagedFilesIsAnErrorThatNamesThem) {
  ingest_currents(1);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(store_.store() / "files"))
    if (entry.is_regular_file()) write_bytes(entry.path(), "no NetCDF");
  const ProgramResult result =
      store_.run({"forecast", "--site", store_.site(), "--at", "2025-03-07T05:00:00Z"});
  EXPECT_EQ(result.exit_code, 3) << result.out;
  EXPECT_TRUE(contains(result.err, "currents0.nc")) << result.err;
}

TEST_F(Degraded, TheDepthOfTheWaterComesFromTheSiteElseTheBathymetryElseTheDeepestWetLevel) {
  ingest_currents(2);
  const auto site = store_.file("bare.yaml");
  write_bytes(site, "id: bare\nlatitude_deg: 54.0\nlongitude_deg: 6.5\n");
  const auto source = [&] {
    const ProgramResult result =
        store_.run({"forecast", "--site", site.string(), "--at", "2025-03-08T05:00:00Z", "--json"});
    return result.exit_code == 0
               ? json::parse(result.out)["columns"][0]["water_depth_source"].get<std::string>()
               : result.err;
  };
  EXPECT_EQ(source(), "deepest wet level");
  ingest("bathymetry.nc", bathymetry_product());
  EXPECT_EQ(source(), "bathymetry");
  write_bytes(site, "id: bare\nlatitude_deg: 54.0\nlongitude_deg: 6.5\nwater_depth_m: 31\n");
  EXPECT_EQ(source(), "site");
}

}  // namespace
}  // namespace slackwater::tests::cli_degraded_test
