// Stores that cannot be written, and stores that were damaged: told clearly, never made worse.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <functional>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/support/contains.h"
#include "tests/support/http_client.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_bad_store_test {
namespace {

using namespace std::chrono;

constexpr UtcDay day = sys_days{2025y / March / 6};

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
  const auto product = store_.file("currents-2025-03-06.nc").string();
  const auto spoil = {std::function<void()>([&] { flip_a_byte(current_file_, 0.6); }),
                      std::function<void()>([&] { std::filesystem::remove(current_file_); })};
  for (const auto& spoil_it : spoil) {
    spoil_it();
    expect_found(current_file_.filename().string().substr(0, 12));
    const ProgramResult again = store_.run({"ingest", product});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_TRUE(contains(again.out, "repaired")) << again.out;
    EXPECT_EQ(store_.run({"store", "check"}).exit_code, 0);
    EXPECT_TRUE(contains(store_.run({"ingest", product}).out, "already in the store"));
  }
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

/// One byte more in a file of the store.
void insert_a_byte(const std::filesystem::path& file, std::size_t at) {
  std::string bytes = read_bytes(file);
  bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at % bytes.size()), 'x');
  std::filesystem::permissions(file, std::filesystem::perms::owner_write,
                               std::filesystem::perm_options::add);
  write_bytes(file, bytes);
}

TEST_F(DamagedStore, AByteMoreAnywhereInTheOnlyForecastIsOneErrorThatNamesIt) {
  const std::string whole = read_bytes(forecast_file_);
  for (const std::size_t at : {9U, 60U, 500U, 1300U, 2500U, 5000U, 9000U}) {
    write_bytes(forecast_file_, whole);
    insert_a_byte(forecast_file_, at);
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"profile", "--site", store_.site(), "--time",
                                   "2025-03-08T05:00:00Z"},
          {"verify", "--site", store_.site()}}) {
      const ProgramResult result = store_.run(command);
      EXPECT_EQ(result.exit_code, 3) << command[0] << at << result.out << result.err;
      EXPECT_TRUE(contains(result.err, "forecast 1 of site test_site")) << result.err;
      EXPECT_TRUE(contains(result.err, "slackwater store check")) << result.err;
      EXPECT_TRUE(result.out.empty()) << result.out;
    }
  }
}

TEST_F(DamagedStore, ADamagedForecastInForceGivesWayToAnOlderWholeOneAndIsNamed) {
  const std::string site = store_.site();
  ASSERT_EQ(store_.run({"forecast", "--site", site, "--at", "2025-03-08T06:00:00Z"}).exit_code, 0);
  const auto newest = content_of(nlohmann::json::parse(store_.listing())["forecasts"][1]);
  insert_a_byte(newest, 1300);
  const std::vector<std::string> profile{"profile", "--site", site, "--time",
                                         "2025-03-08T12:00:00Z"};
  std::vector<std::string> as_json = profile;
  as_json.emplace_back("--json");
  const ProgramResult asked = store_.run(as_json);
  ASSERT_EQ(asked.exit_code, 0) << asked.err;
  const auto answer = nlohmann::json::parse(asked.out);
  EXPECT_EQ(answer["issued"], "2025-03-08T05:00:00Z");
  ASSERT_EQ(answer["notes"].size(), 1U);
  const auto note = answer["notes"][0].get<std::string>();
  EXPECT_TRUE(contains(note, "forecast 2 of site test_site, issued 2025-03-08T06:00:00Z")) << note;
  EXPECT_TRUE(contains(note, "slackwater store check")) << note;
  const ProgramResult table = store_.run(profile);
  EXPECT_TRUE(contains(table.out, "note: forecast 2 of site")) << table.out;
  const ProgramResult near_it = store_.run(
      {"profile", "--lat", "54.001", "--lon", "6.501", "--time", "2025-03-08T12:00:00Z"});
  EXPECT_EQ(near_it.exit_code, 0) << near_it.err;
  EXPECT_TRUE(contains(near_it.out, "note: forecast 2 of site")) << near_it.out;

  write_bytes(store_.file("points.csv"), "latitude_deg,longitude_deg\n54.0,6.5\n");
  std::vector<std::string> sample{"sample",
                                  "--site",
                                  site,
                                  "--points",
                                  store_.file("points.csv").string(),
                                  "--out",
                                  store_.file("out.csv").string()};
  const ProgramResult sampled = store_.run(sample);
  EXPECT_EQ(sampled.exit_code, 0) << sampled.err;
  EXPECT_TRUE(contains(sampled.err, "forecast 2 of site")) << sampled.err;
  sample.insert(sample.end(), {"--instance", "2"});
  EXPECT_EQ(store_.run(sample).exit_code, 3) << "asked for by its number it is an error";

  store_.ingest_days(day + days(2), 1);  // the truth of what was issued
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"verify", "--site", site},
        {"forecast", "--site", site, "--at", "2025-03-09T05:00:00Z"}}) {
    const ProgramResult result = store_.run(command);
    EXPECT_EQ(result.exit_code, 0) << command[0] << result.err;
    EXPECT_TRUE(contains(result.err, "forecast 2 of site")) << command[0] << result.err;
  }
}

TEST_F(DamagedStore, ADamagedForecastDoesNotEndTheServer) {
  const std::string site = store_.site();
  ASSERT_EQ(store_.run({"forecast", "--site", site, "--at", "2025-03-08T06:00:00Z"}).exit_code, 0);
  insert_a_byte(content_of(nlohmann::json::parse(store_.listing())["forecasts"][1]), 1300);
  const auto said = store_.file("said.json");
  const pid_t server = store_.start({"serve", "--port", "0", "--json"}, said);
  std::string line;
  for (int turn = 0; turn < 500 && !contains(line, "}"); ++turn) {
    std::this_thread::sleep_for(milliseconds(20));
    line = read_bytes(said);
  }
  ASSERT_TRUE(contains(line, "}")) << line;
  const auto port = nlohmann::json::parse(line)["port"].get<std::uint16_t>();
  HttpClient client(port);
  const std::string where = "position?coords=POINT(6.5%2054)&datetime=2025-03-08T12:00:00Z";
  for (int turn = 0; turn < 3; ++turn) {
    const auto by_name =
        client.get("/collections/currents/instances/test_site_20250308T060000Z/" + where);
    ASSERT_TRUE(by_name);
    EXPECT_EQ(by_name->status, 503) << by_name->body;
    EXPECT_TRUE(contains(by_name->body, "test_site_20250308T060000Z")) << by_name->body;
    const auto in_force = client.get("/collections/currents/" + where);
    ASSERT_TRUE(in_force);
    EXPECT_EQ(in_force->status, 200) << in_force->body;
    const auto from = nlohmann::json::parse(in_force->body)["slackwater:provenance"];
    EXPECT_EQ(from["instance"], "test_site_20250308T050000Z");
    EXPECT_TRUE(contains(from["notes"].dump(), "test_site_20250308T060000Z is damaged")) << from;
  }
  const auto health = client.get("/health");
  ASSERT_TRUE(health);
  EXPECT_EQ(health->status, 200);
  EXPECT_TRUE(contains(health->body, "test_site_20250308T060000Z")) << health->body;
  ::kill(server, SIGTERM);
  EXPECT_EQ(wait_for_program(server), 0);
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
}  // namespace slackwater::tests::cli_bad_store_test
