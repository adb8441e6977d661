// Stores that cannot be written, and stores that were damaged: told clearly, never made worse.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/support/product_files_for_tests.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests {
namespace {

using namespace std::chrono;

constexpr UtcDay day = sys_days{2025y / March / 6};

bool contains(const std::string& text, const std::string& word) {
  return text.find(word) != std::string::npos;
}

TEST(UnwritableStore, BelowAFileIsUnavailableAndNamesTheFolder) {
  const TemporaryFolder folder;
  write_bytes(folder / "file", "not a folder");
  const StoreForTests store(folder / "file" / "store");
  const auto product = write_product(folder / "currents.nc", current_product(day));
  const ProgramResult result = store.run({"ingest", product.string()});
  EXPECT_EQ(result.exit_code, 5) << result.err;
  EXPECT_TRUE(contains(result.err, (folder / "file").string())) << result.err;
}

TEST(UnwritableStore, InTheKernelsFoldersIsUnavailable) {
  const TemporaryFolder folder;
  const StoreForTests store("/proc/slackwater-store");
  const auto product = write_product(folder / "currents.nc", current_product(day));
  const ProgramResult result = store.run({"ingest", product.string()});
  EXPECT_EQ(result.exit_code, 5) << result.err;
  EXPECT_TRUE(contains(result.err, "/proc/slackwater-store")) << result.err;
}

TEST(AbsentStore, IsNotFoundByEveryReaderAndNotMadeByThem) {
  const StoreForTests store;
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"store", "list"},
        {"profile", "--site", store.site(), "--time", "2025-03-07T06:00:00Z"}}) {
    const ProgramResult result = store.run(command);
    EXPECT_EQ(result.exit_code, 4) << command[0] << result.err;
    EXPECT_TRUE(contains(result.err, store.store().string())) << result.err;
    EXPECT_TRUE(contains(result.err, "ingest")) << "what to do: " << result.err;
    EXPECT_FALSE(std::filesystem::exists(store.store())) << command[0];
  }
}

/// A sound store with two days and one forecast, to be damaged.
class DamagedStore : public ::testing::Test {
 protected:
  DamagedStore() {
    store_.ingest_days(day, 2);
    const ProgramResult result =
        store_.run({"forecast", "--site", store_.site(), "--at", "2025-03-08T05:00:00Z", "--json"});
    if (result.exit_code != 0) throw std::runtime_error(result.err);
    forecast_file_ = content_of(nlohmann::json::parse(store_.listing())["forecasts"][0]);
    current_file_ = content_of(nlohmann::json::parse(store_.listing())["granules"][0]);
  }

  [[nodiscard]] std::filesystem::path content_of(const nlohmann::json& row) const {
    const auto sha256 = row.at("content_sha256").get<std::string>();
    return store_.store() / "files" / sha256.substr(0, 2) / (sha256 + ".nc");
  }

  void flip_a_byte(const std::filesystem::path& file, double where) const {
    std::string bytes = read_bytes(file);
    const auto at = static_cast<std::size_t>(where * static_cast<double>(bytes.size()));
    bytes[at] = static_cast<char>(bytes[at] ^ 0x55);
    std::filesystem::permissions(file, std::filesystem::perms::owner_write,
                                 std::filesystem::perm_options::add);
    write_bytes(file, bytes);
  }

  /// `store check` says that this file is at fault, with advice.
  void expect_found(const std::string& what) {
    const ProgramResult check = store_.run({"store", "check", "--json"});
    EXPECT_EQ(check.exit_code, 3) << check.out << check.err;
    const auto report = nlohmann::json::parse(check.out);
    EXPECT_FALSE(report["sound"].get<bool>());
    const auto& findings = report["findings"];
    const bool named =
        std::any_of(findings.begin(), findings.end(), [&](const nlohmann::json& finding) {
          return finding["harmful"].get<bool>() &&
                 contains(finding["found"].get<std::string>(), what) &&
                 !finding["advice"].get<std::string>().empty();
        });
    EXPECT_TRUE(named) << what << " in " << check.out;
  }

  StoreForTests store_;
  std::filesystem::path forecast_file_;
  std::filesystem::path current_file_;
};

TEST_F(DamagedStore, CatalogueOverwrittenWithTextIsRefusedByEveryCommandAndLeftAlone) {
  const auto product = write_product(store_.file("more.nc"), current_product(day + days(2)));
  write_bytes(store_.store() / "catalogue.sqlite", std::string(8192, 'x'));
  const auto digests = store_.digests();
  const std::string site = store_.site();
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"store", "list"},
        {"ingest", product.string()},
        {"forecast", "--site", site, "--at", "2025-03-08T05:00:00Z"},
        {"profile", "--site", site, "--time", "2025-03-08T05:00:00Z"},
        {"verify", "--site", site},
        {"hindcast", "--site", site, "--from", "2025-03-06", "--to", "2025-03-07"},
        {"store", "prune", "--orphans"}}) {
    const ProgramResult result = store_.run(command);
    EXPECT_EQ(result.exit_code, 3) << command[0] << ": " << result.err;
    EXPECT_TRUE(contains(result.err, "catalogue.sqlite")) << command[0] << ": " << result.err;
    EXPECT_TRUE(contains(result.err, "store check"))
        << command[0] << " says what to do: " << result.err;
    EXPECT_EQ(store_.digests(), digests) << command[0];
  }
  expect_found("catalogue.sqlite");
}

TEST_F(DamagedStore, CatalogueCutInHalfIsFound) {
  const std::string whole = read_bytes(store_.store() / "catalogue.sqlite");
  write_bytes(store_.store() / "catalogue.sqlite", whole.substr(0, whole.size() / 2));
  expect_found("catalogue.sqlite");
}

TEST_F(DamagedStore, LostCatalogueIsNotReplacedByAnEmptyOne) {
  std::filesystem::remove(store_.store() / "catalogue.sqlite");
  std::filesystem::remove(store_.store() / "catalogue.sqlite-wal");
  std::filesystem::remove(store_.store() / "catalogue.sqlite-shm");
  const auto digests = store_.digests();
  const auto product = write_product(store_.file("more.nc"), current_product(day + days(2)));
  const ProgramResult result = store_.run({"ingest", product.string()});
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_EQ(store_.digests(), digests);
  EXPECT_EQ(store_.run({"store", "check"}).exit_code, 3);
}

TEST_F(DamagedStore, FlippedByteInACurrentFileIsFoundAndMendedByIngestingAgain) {
  flip_a_byte(current_file_, 0.6);
  expect_found(current_file_.filename().string().substr(0, 12));
  std::filesystem::remove(current_file_);
  expect_found(current_file_.filename().string().substr(0, 12));
  store_.ingest(store_.file("currents-2025-03-06.nc"));
  EXPECT_EQ(store_.run({"store", "check"}).exit_code, 0);
}

TEST_F(DamagedStore, DamagedForecastIsAnErrorThatNamesItsFileNotANumber) {
  write_bytes(forecast_file_, read_bytes(forecast_file_).substr(0, 2000));
  expect_found(forecast_file_.filename().string().substr(0, 12));
  const ProgramResult result =
      store_.run({"profile", "--site", store_.site(), "--time", "2025-03-08T05:00:00Z"});
  EXPECT_EQ(result.exit_code, 3) << result.out << result.err;
  EXPECT_TRUE(contains(result.err, forecast_file_.filename().string())) << result.err;
  EXPECT_TRUE(result.out.empty()) << result.out;
}

TEST_F(DamagedStore, LostForecastFileIsAnErrorThatNamesIt) {
  std::filesystem::remove(forecast_file_);
  const ProgramResult result =
      store_.run({"profile", "--site", store_.site(), "--time", "2025-03-08T05:00:00Z"});
  EXPECT_TRUE(result.exit_code == 3 || result.exit_code == 4) << result.exit_code << result.err;
  EXPECT_TRUE(contains(result.err, forecast_file_.filename().string())) << result.err;
}

TEST_F(DamagedStore, LostCurrentFileStopsNoCommandWithoutSayingSo) {
  std::filesystem::remove(current_file_);
  const ProgramResult result =
      store_.run({"forecast", "--site", store_.site(), "--at", "2025-03-08T05:00:00Z"});
  if (result.exit_code == 0) {
    EXPECT_TRUE(contains(result.out, "DEGRADED")) << result.out;
  } else {
    EXPECT_TRUE(result.exit_code == 3 || result.exit_code == 4) << result.exit_code;
    EXPECT_TRUE(contains(result.err, current_file_.filename().string())) << result.err;
  }
}

TEST_F(DamagedStore, ALeftoverOfAKilledProcessIsANoteNotAProblemAndPruneRemovesIt) {
  const auto orphan =
      store_.store() / "files" / "ab" / std::string("ab").append(62, '0').append(".nc");
  std::filesystem::create_directories(orphan.parent_path());
  write_bytes(orphan, "unnamed");
  const ProgramResult check = store_.run({"store", "check"});
  EXPECT_EQ(check.exit_code, 0) << check.out;
  EXPECT_TRUE(contains(check.out, "note")) << check.out;
  EXPECT_EQ(store_.run({"store", "prune", "--orphans"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(orphan));
}

TEST_F(DamagedStore, PruneNeverTakesAnIssuedForecastUnlessTold) {
  const std::string before = read_bytes(forecast_file_);
  ASSERT_EQ(store_.run({"store", "prune", "--older-than", "2026-01-01"}).exit_code, 0);
  EXPECT_EQ(read_bytes(forecast_file_), before);
  EXPECT_EQ(nlohmann::json::parse(store_.listing())["forecasts"].size(), 1U);
  EXPECT_EQ(store_.run({"store", "check"}).exit_code, 0);
  ASSERT_EQ(store_.run({"store", "prune", "--older-than", "2026-01-01", "--forecasts"}).exit_code,
            0);
  EXPECT_EQ(nlohmann::json::parse(store_.listing())["forecasts"].size(), 0U);
}

}  // namespace
}  // namespace slackwater::tests
