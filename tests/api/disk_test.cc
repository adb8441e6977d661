// Full and read-only disks: the program says which folder and what to do, and the store is sound
// throughout.
#include <gtest/gtest.h>
#include <sys/mount.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/contains.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::disk_test {
namespace {

using namespace std::chrono;
using nlohmann::json;

constexpr UtcDay day = sys_days{2025y / March / 6};
constexpr const char* at = "2025-03-08T05:00:00Z";

/// A disk in memory that is small enough to fill.
class SmallDisk {
 public:
  explicit SmallDisk(const char* options) {
    problem_ = ::mount("tmpfs", folder_.path().c_str(), "tmpfs", 0, options) == 0 ? 0 : errno;
  }
  ~SmallDisk() {
    if (is_mounted()) ::umount2(folder_.path().c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  [[nodiscard]] bool is_mounted() const { return problem_ == 0; }
  [[nodiscard]] const char* problem() const { return std::strerror(problem_); }
  [[nodiscard]] std::filesystem::path store() const { return folder_ / "store"; }

  /// Fills it up to so many bytes.
  void fill(std::uintmax_t leave_bytes) const {
    std::ofstream ballast(folder_ / "ballast", std::ios::binary);
    const std::vector<char> page(4096, 'x');
    for (auto free = std::filesystem::space(folder_.path()).available;
         free >= leave_bytes + page.size(); free -= page.size()) {
      ballast.write(page.data(), static_cast<std::streamsize>(page.size()));
    }
  }
  void free() const { std::filesystem::remove(folder_ / "ballast"); }
  [[nodiscard]] bool make_read_only() const {
    return ::mount("tmpfs", folder_.path().c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr) == 0;
  }

 private:
  TemporaryFolder folder_;
  int problem_ = 0;
};

#define SLACKWATER_NEEDS_DISK(disk, options) \
  const SmallDisk disk(options);             \
  if (!disk.is_mounted()) GTEST_SKIP() << "cannot mount a tmpfs here: " << disk.problem()

void expect_told(const ProgramResult& result, const SmallDisk& disk) {
  EXPECT_EQ(result.exit_code, 5) << result.out << result.err;
  EXPECT_TRUE(contains(result.err, disk.store().string())) << "names the folder: " << result.err;
  EXPECT_TRUE(contains(result.err, "space")) << "says what to do: " << result.err;
}

/// Sound now, and after space is freed; the command then works.
void expect_unharmed(const StoreForTests& store, const SmallDisk& disk, const std::string& listing,
                     const std::vector<std::string>& command) {
  disk.free();
  const ProgramResult check = store.run({"store", "check"});
  EXPECT_EQ(check.exit_code, 0) << check.out << check.err;
  EXPECT_EQ(store.listing(), listing) << "nothing of a failed command is kept";
  const ProgramResult again = store.run(command);
  EXPECT_EQ(again.exit_code, 0) << again.err;
  const ProgramResult later = store.run({"store", "check", "--json"});
  EXPECT_EQ(later.exit_code, 0) << later.out;
  EXPECT_EQ(json::parse(later.out)["findings"].size(), 0U) << later.out;
}

TEST(FullDisk, StopsAnIngestWithoutHarm) {
  for (const std::uintmax_t left : {0U, 4096U, 16384U, 40960U}) {
    SCOPED_TRACE(std::to_string(left) + " bytes left");
    SLACKWATER_NEEDS_DISK(disk, "size=1m");
    const StoreForTests store(disk.store());
    store.ingest_days(day, 1);
    const std::string listing = store.listing();
    const auto product = write_product(store.file("more.nc"), current_product(day + days(1), 72));
    disk.fill(left);
    expect_told(store.run({"ingest", product.string()}), disk);
    expect_unharmed(store, disk, listing, {"ingest", product.string()});
  }
}

TEST(FullDisk, StopsAForecastWithoutHarm) {
  for (const std::uintmax_t left : {0U, 4096U, 16384U, 40960U}) {
    SCOPED_TRACE(std::to_string(left) + " bytes left");
    SLACKWATER_NEEDS_DISK(disk, "size=1m");
    const StoreForTests store(disk.store());
    store.ingest_days(day, 2);
    const std::string listing = store.listing();
    const std::vector<std::string> forecast{"forecast", "--site", store.site(), "--at", at};
    disk.fill(left);
    expect_told(store.run(forecast), disk);
    expect_unharmed(store, disk, listing, forecast);
  }
}

TEST(FullDisk, StillAnswersAProfileAndACheck) {
  SLACKWATER_NEEDS_DISK(disk, "size=1m");
  const StoreForTests store(disk.store());
  store.ingest_days(day, 2);
  const std::string site = store.site();
  ASSERT_EQ(store.run({"forecast", "--site", site, "--at", at}).exit_code, 0);
  disk.fill(0);
  const ProgramResult profile =
      store.run({"profile", "--site", site, "--time", "2025-03-08T12:00:00Z"});
  EXPECT_EQ(profile.exit_code, 0) << profile.err;
  const ProgramResult check = store.run({"store", "check"});
  EXPECT_EQ(check.exit_code, 0) << check.out << check.err;
  const ProgramResult list = store.run({"store", "list"});
  EXPECT_EQ(list.exit_code, 0) << list.err;
}

TEST(FullDisk, StopsTheOutputFileWithoutAHalfOne) {
  SLACKWATER_NEEDS_DISK(disk, "size=1m");
  const StoreForTests store;  // the store has space, the place of --out has none
  store.ingest_days(day, 2);
  const auto out = disk.store().parent_path() / "forecast.nc";
  disk.fill(8192);
  const ProgramResult result =
      store.run({"forecast", "--site", store.site(), "--at", at, "--out", out.string()});
  EXPECT_EQ(result.exit_code, 5) << result.err;
  EXPECT_TRUE(contains(result.err, "forecast.nc")) << result.err;
  EXPECT_FALSE(std::filesystem::exists(out));
  EXPECT_FALSE(std::filesystem::exists(out.string() + ".partial")) << "nothing half is left behind";
  EXPECT_EQ(store.run({"store", "check"}).exit_code, 0);
}

TEST(FullDisk, CannotBeginAStore) {
  SLACKWATER_NEEDS_DISK(disk, "size=64k");
  const StoreForTests store(disk.store());
  disk.fill(4096);
  const auto product = write_product(store.file("currents.nc"), current_product(day));
  expect_told(store.run({"ingest", product.string()}), disk);
  disk.free();
}

TEST(ReadOnlyDisk, AnswersQueriesAndRefusesToWrite) {
  SLACKWATER_NEEDS_DISK(disk, "size=4m");
  const StoreForTests store(disk.store());
  store.ingest_days(day, 3);
  const std::string site = store.site();
  ASSERT_EQ(store.run({"forecast", "--site", site, "--at", at}).exit_code, 0);
  const std::string listing = store.listing();
  const auto product = write_product(store.file("more.nc"), current_product(day + days(3)));
  ASSERT_TRUE(disk.make_read_only()) << std::strerror(errno);
  EXPECT_EQ(store.listing(), listing);
  for (const std::vector<std::string>& query :
       {std::vector<std::string>{"profile", "--site", site, "--time", "2025-03-08T12:00:00Z"},
        {"store", "check"},
        {"site", "check", site, "--at", at},
        {"verify", "--site", site}}) {
    const ProgramResult result = store.run(query);
    EXPECT_EQ(result.exit_code, 0) << query[0] << ": " << result.err;
  }
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"ingest", product.string()},
        {"forecast", "--site", site, "--at", at},
        {"hindcast", "--site", site, "--from", "2025-03-06", "--to", "2025-03-07"},
        {"store", "prune", "--orphans"}}) {
    const ProgramResult result = store.run(command);
    EXPECT_EQ(result.exit_code, 5) << command[0] << ": " << result.err;
    EXPECT_TRUE(contains(result.err, disk.store().string())) << result.err;
  }
}

}  // namespace
}  // namespace slackwater::tests::disk_test
