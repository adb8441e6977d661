// Small and read-only file systems, as root may mount them.
#include <gtest/gtest.h>
#include <sys/mount.h>

#include <cerrno>
#include <cstring>

#include "data/store/store.h"
#include "fields/base/error.h"
#include "tests/data/store/sample_rows.h"
#include "tests/data/store/worker_process.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::store::tests::hostile_disk_test {
namespace {

using slackwater::tests::TemporaryFolder;

class HostileDisk : public testing::Test {
 protected:
  void SetUp() override {
    if (::mount("tmpfs", temporary_.path().c_str(), "tmpfs", 0, "size=2m") != 0) {
      GTEST_SKIP() << "cannot mount a tmpfs here: " << std::strerror(errno);
    }
    mounted_ = true;
  }
  void TearDown() override {
    if (mounted_) ::umount2(temporary_.path().c_str(), MNT_DETACH);
  }
  void make_read_only() {
    ASSERT_EQ(::mount("", temporary_.path().c_str(), "", MS_REMOUNT | MS_RDONLY, ""), 0)
        << std::strerror(errno);
  }
  void expect_not_writable() const {
    try {
      Store store = Store::open(folder_, OpenMode::create_or_write);
      samples::ingest(store, 99);
      ADD_FAILURE() << "wrote on a read-only file system";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::unavailable) << error.message();
      EXPECT_NE(error.message().find("--store"), std::string::npos) << error.message();
    }
  }

  TemporaryFolder temporary_;
  std::filesystem::path folder_ = temporary_ / "store";
  bool mounted_ = false;
};

TEST_F(HostileDisk, FullIsReportedStoresNothingAndWorkGoesOnWithSpace) {
  int refusals = 0;
  int commits = 0;
  // Leave more and more room: wherever it runs out, the answer is the same.
  for (std::size_t room = 0; room < 200'000; room += 12'288) {
    SCOPED_TRACE("room for " + std::to_string(room) + " bytes");
    Store store = Store::open(folder_, OpenMode::create_or_write);
    samples::ingest(store, 1);
    const int number = 100 + static_cast<int>(room / 12'288);
    auto granules = samples::granules(store, number);
    const auto space = std::filesystem::space(temporary_.path()).available;
    samples::write_file(temporary_ / "filler", std::string(space > room ? space - room : 0, 'f'));
    bool stored = false;
    try {
      stored = store.commit_ingest(samples::source(number), granules);
      ++commits;
    } catch (const Error& error) {
      ++refusals;
      EXPECT_EQ(error.kind(), ErrorKind::unavailable) << error.message();
      EXPECT_NE(error.message().find("no space left"), std::string::npos) << error.message();
    }
    EXPECT_TRUE(store.check(true).sound);
    std::filesystem::remove(temporary_ / "filler");
    if (!stored) {
      EXPECT_TRUE(samples::ingest(store, number));
    }
    EXPECT_TRUE(store.find_source(samples::source(1).sha256, ""));
    EXPECT_TRUE(store.find_source(samples::source(number).sha256, ""));
    store.prune({samples::source(number + 1).ingested_at, false, true});
  }
  EXPECT_GT(refusals, 2);
  EXPECT_GT(commits, 2);
}

TEST_F(HostileDisk, FullFromTheStartMakesNoStore) {
  samples::write_file(temporary_ / "filler",
                      std::string(std::filesystem::space(temporary_.path()).available, 'f'));
  try {
    static_cast<void>(Store::open(folder_, OpenMode::create_or_write));
    FAIL() << "made a store on a full disk";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::unavailable) << error.message();
  }
  std::filesystem::remove(temporary_ / "filler");
  Store store = Store::open(folder_, OpenMode::create_or_write);
  EXPECT_TRUE(samples::ingest(store, 1));
}

TEST_F(HostileDisk, ReadOnlyIsReadAndNotWritten) {
  {
    Store store = Store::open(folder_, OpenMode::create_or_write);
    samples::ingest(store, 1);
    samples::issue(store, 1);
  }
  ASSERT_FALSE(std::filesystem::exists(folder_ / "catalogue.sqlite-shm"));
  make_read_only();
  Store store = Store::open(folder_, OpenMode::read_only);
  EXPECT_TRUE(store.find_source(samples::source(1).sha256, ""));
  EXPECT_EQ(store.list_forecasts().size(), 1U);
  EXPECT_TRUE(store.check(true).sound);
  expect_not_writable();
}

/// After a crash the newest rows are in the WAL only; they must not be missed.
TEST_F(HostileDisk, ReadOnlyAfterACrashShowsTheNewestRows) {
  for (const bool with_shared_memory : {true, false}) {
    SCOPED_TRACE(with_shared_memory ? "with -shm" : "without -shm");
    {
      WorkerProcess worker(folder_, {"loop:1"});
      ASSERT_TRUE(worker.wait_for("done forecast:2"));
    }
    ASSERT_GT(std::filesystem::file_size(folder_ / "catalogue.sqlite-wal"), 0U);
    if (!with_shared_memory) std::filesystem::remove(folder_ / "catalogue.sqlite-shm");
    make_read_only();
    {
      Store store = Store::open(folder_, OpenMode::read_only);
      EXPECT_TRUE(store.find_source(samples::source(2).sha256, ""));
      EXPECT_GE(store.list_forecasts().size(), 2U);
      EXPECT_TRUE(store.check(true).sound);
      expect_not_writable();
    }
    ASSERT_EQ(::mount("", temporary_.path().c_str(), "", MS_REMOUNT, ""), 0);
    std::filesystem::remove_all(folder_);
  }
}

}  // namespace
}  // namespace slackwater::store::tests::hostile_disk_test
