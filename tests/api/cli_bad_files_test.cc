// Bad product files: one clear error or the documented way through, and a store that is as it was.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "tests/support/product_files_for_tests.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_bad_files_test {
namespace {

using namespace std::chrono;

constexpr UtcDay day = sys_days{2025y / March / 6};
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// A store that holds one good file, so that "as it was" means something.
class BadFile : public ::testing::Test {
 protected:
  BadFile() { store_.ingest_days(day, 1); }

  /// The file is refused with exit code 3, the error names it and holds these words, and nothing
  /// has changed.
  void expect_refused(const std::filesystem::path& file, const std::vector<std::string>& words) {
    const std::string listing = store_.listing();
    const auto digests = store_.digests();
    const ProgramResult result = store_.run({"ingest", file.string()});
    EXPECT_EQ(result.exit_code, 3) << result.out << result.err;
    EXPECT_NE(result.err.find(file.filename().string()), std::string::npos) << result.err;
    for (const std::string& word : words)
      EXPECT_NE(result.err.find(word), std::string::npos) << word << " in: " << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1)
        << "one error, not several: " << result.err;
    EXPECT_EQ(store_.listing(), listing);
    EXPECT_EQ(store_.digests(), digests) << "the store is as it was, to the byte";
  }

  [[nodiscard]] std::filesystem::path currents(const std::function<void(ProductForTests&)>& spoil) {
    ProductForTests product = current_product(day + days(1));
    spoil(product);
    return write_product(store_.file("spoilt.nc"), product);
  }

  StoreForTests store_;
};

TEST_F(BadFile, TruncatedAtAnyPlaceIsRefused) {
  const std::string whole = read_bytes(currents([](ProductForTests&) {}));
  for (const double share : {0.001, 0.1, 0.5, 0.9, 0.999}) {
    const auto file = store_.file("cut_short.nc");
    write_bytes(
        file, whole.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole.size()))));
    expect_refused(file, {"truncated"});
  }
}

// Whole, to its last byte, though it is longer than any buffer.
TEST_F(BadFile, ALongListOfRefusalsIsToldWhole) {
  const auto folder = store_.file("many");
  std::filesystem::create_directory(folder);
  for (int i = 0; i < 60; ++i)
    write_bytes(folder / (std::string(100, 'n') + std::to_string(i) + ".nc"), "nothing");
  const ProgramResult result = store_.run({"ingest", "--json", folder.string()});
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_GT(result.out.size(), 16'384U);
  EXPECT_EQ(nlohmann::json::parse(result.out)["failed"].size(), 60U);
}

TEST_F(BadFile, EmptyIsRefused) {
  const auto file = store_.file("empty.nc");
  write_bytes(file, "");
  expect_refused(file, {"empty"});
}

TEST_F(BadFile, TextIsNotNetcdf) {
  const auto file = store_.file("page.nc");
  write_bytes(file, "<html><body>503 Service Unavailable</body></html>\n");
  expect_refused(file, {"NetCDF"});
}

TEST_F(BadFile, WithoutAnyKnownVariableIsRefusedAndTheVariablesFoundAreNamed) {
  expect_refused(currents([](ProductForTests& p) {
                   p.quantities = {{"chl", "mass_concentration_of_chlorophyll_a_in_sea_water",
                                    "mg m-3", true, [](const ProductCell&) { return 1.0; }}};
                 }),
                 {"chl", "expected"});
}

TEST_F(BadFile, OneComponentOfACurrentAloneIsToldOrStoredAsSuch) {
  const auto file = currents([](ProductForTests& p) { p.quantities.pop_back(); });
  const ProgramResult result = store_.run({"ingest", file.string(), "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;  // V may come in another file
  const auto names = nlohmann::json::parse(result.out)["files"][0]["standard_names"];
  EXPECT_EQ(names, nlohmann::json::array({"eastward_sea_water_velocity"}));
}

TEST_F(BadFile, WrongUnitIsRefusedWithBothUnits) {
  expect_refused(currents([](ProductForTests& p) { p.quantity("uo").unit = "kelvin"; }),
                 {"uo", "kelvin", "m s-1"});
}

TEST_F(BadFile, WithoutAnyValueIsRefused) {
  expect_refused(currents([](ProductForTests& p) {
                   for (auto& q : p.quantities)
                     q.value = [](const ProductCell&) { return nothing; };
                 }),
                 {"uo"});
}

TEST_F(BadFile, NanIsAMissingValueLikeTheFillValue) {
  const auto file = currents([](ProductForTests& p) { p.writes_nan = true; });
  const ProgramResult result = store_.run({"ingest", file.string()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string site = write_site(store_.file("coast.yaml"), "", 54.0, 6.7).string();
  const ProgramResult on_land =
      store_.run({"forecast", "--site", site, "--at", "2025-03-08T05:00:00Z"});
  EXPECT_EQ(on_land.exit_code, 4) << on_land.out;
  EXPECT_NE(on_land.err.find("land"), std::string::npos) << on_land.err;
}

TEST_F(BadFile, AnInfiniteOrAbsurdCurrentNeverReachesAForecast) {
  for (const double absurd : {std::numeric_limits<double>::infinity(), 400.0}) {
    StoreForTests store;
    ProductForTests product = current_product(day);
    product.quantity("uo").value = [=](const ProductCell& cell) {
      return cell.time == UtcTime(day) + hours(5) ? absurd : WaterForTests::eastward_m_s(cell);
    };
    const auto file = write_product(store.file("absurd.nc"), product);
    const ProgramResult ingest = store.run({"ingest", file.string()});
    if (ingest.exit_code == 3) continue;  // refused is good too
    ASSERT_EQ(ingest.exit_code, 0) << ingest.err;
    const ProgramResult forecast =
        store.run({"forecast", "--site", store.site(), "--at", "2025-03-07T05:00:00Z"});
    ASSERT_EQ(forecast.exit_code, 0) << forecast.err;
    const ProgramResult profile =
        store.run({"profile", "--site", store.site(), "--time", "2025-03-07T05:00:00Z", "--json"});
    ASSERT_EQ(profile.exit_code, 0) << profile.err;
    const auto answer = nlohmann::json::parse(profile.out);
    for (const auto& level : answer.at("levels")) {
      if (level.at("status") != "ok") continue;
      EXPECT_LT(level.at("sea_water_speed").get<double>(), 3.0) << absurd << ": " << profile.out;
    }
  }
}

TEST_F(BadFile, DuplicateTimesAreRefused) {
  expect_refused(currents([](ProductForTests& p) { p.time[7] = p.time[6]; }),
                 {"time", "2025-03-07T06:00:00Z"});
}

TEST_F(BadFile, BackwardTimesAreRefused) {
  expect_refused(currents([](ProductForTests& p) { std::swap(p.time[7], p.time[15]); }), {"time"});
}

TEST_F(BadFile, DepthsInAnyOrderAreTheSameWater) {
  store_.ingest(currents([](ProductForTests&) {}));
  StoreForTests shuffled;
  ProductForTests product = current_product(day + days(1));
  std::swap(product.depth_m[1], product.depth_m[3]);
  shuffled.ingest(write_product(shuffled.file("shuffled.nc"), product));
  const auto newest = [](const StoreForTests& store) {
    return nlohmann::json::parse(store.listing())["granules"]
        .back()["content_sha256"]
        .get<std::string>();
  };
  EXPECT_EQ(newest(shuffled), newest(store_));
}

TEST_F(BadFile, TwoEqualDepthsAreRefused) {
  expect_refused(currents([](ProductForTests& p) { p.depth_m[2] = p.depth_m[1]; }),
                 {"levels", "5.0"});
}

TEST_F(BadFile, LatitudesBeyondThePoleAreRefused) {
  expect_refused(currents([](ProductForTests& p) {
                   p.latitude_deg = {540, 541, 542, 543, 544};
                 }),
                 {"latitude"});
}

TEST_F(BadFile, WithoutDepthAxisTheDescriptorSettlesTheLevelOfAKnownProduct) {
  const auto file = currents([](ProductForTests& p) { p.depth_m.clear(); });
  ASSERT_EQ(store_.run({"ingest", file.string()}).exit_code, 0);
}

TEST_F(BadFile, WithoutDepthAxisAnUnknownProductIsRefused) {
  expect_refused(currents([](ProductForTests& p) {
                   p.title = "somebody's currents";
                   p.depth_m.clear();
                 }),
                 {"depth"});
}

TEST_F(BadFile, OneBadFileAmongGoodOnesIsToldAndTheGoodOnesAreKept) {
  const auto bad = store_.file("bad.nc");
  write_bytes(bad, "nothing");
  const auto good = write_product(store_.file("good.nc"), current_product(day + days(1)));
  const ProgramResult result = store_.run({"ingest", bad.string(), good.string(), "--json"});
  EXPECT_EQ(result.exit_code, 3) << result.err;
  const auto report = nlohmann::json::parse(result.out);
  ASSERT_EQ(report["files"].size(), 1U) << result.out;
  EXPECT_EQ(report["files"][0]["file"], good.string());
  ASSERT_EQ(report["failed"].size(), 1U);
  EXPECT_EQ(report["failed"][0]["file"], bad.string());
  EXPECT_EQ(nlohmann::json::parse(store_.listing())["sources"].size(), 4U);
}

TEST_F(BadFile, AnAbsentFileAndAnEmptyFolderAreNotFound) {
  const ProgramResult absent = store_.run({"ingest", store_.file("absent.nc").string()});
  EXPECT_EQ(absent.exit_code, 4);
  EXPECT_NE(absent.err.find("absent.nc"), std::string::npos) << absent.err;
  std::filesystem::create_directory(store_.file("void"));
  const ProgramResult empty = store_.run({"ingest", store_.file("void").string()});
  EXPECT_EQ(empty.exit_code, 4);
  EXPECT_NE(empty.err.find("void"), std::string::npos) << empty.err;
}

TEST_F(BadFile, WaveHeightInKelvinIsRefused) {
  ProductForTests product = wave_product(day + days(1));
  product.quantity("VHM0").unit = "kelvin";
  expect_refused(write_product(store_.file("waves.nc"), product), {"VHM0", "kelvin"});
}

}  // namespace
}  // namespace slackwater::tests::cli_bad_files_test
