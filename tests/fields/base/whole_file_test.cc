#include "fields/base/whole_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "fields/base/error.h"
#include "tests/support/error_of.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::whole_file_test {
namespace {

namespace fs = std::filesystem;

const std::string what_to_do =
    "; a writable folder with room was expected; check free space and permissions";

class WholeFile : public testing::Test {
 protected:
  void SetUp() override { write_text(file_, "old"); }
  /// The old file and nothing beside it.
  void expect_untouched() const {
    EXPECT_EQ(text_of(file_), "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
  }
  static std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  tests::TemporaryFolder folder_;
  fs::path file_ = folder_ / "page.html";
};

/// No file of this process grows beyond a size: a disk with no room for more.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t most) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    rlimit now = before_;
    now.rlim_cur = most;
    ::setrlimit(RLIMIT_FSIZE, &now);
  }
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST_F(WholeFile, TakesThePlaceOfTheOldOne) {
  const std::string text("new \0 text\r\n", 12);
  write_text(file_, text);
  EXPECT_EQ(text_of(file_), text);
}

TEST_F(WholeFile, AFullDiskLeavesTheOldOne) {
  const std::string text(100'000, 'x');
  std::string problem;
  {
    const SmallDisk disk(4096);
    problem = tests::error_of([&] { return write_text(file_, text), 0; });
  }
  EXPECT_EQ(problem, "writing " + file_.string() + " failed (File too large)" + what_to_do);
  expect_untouched();
  write_text(file_, text);
  EXPECT_EQ(text_of(file_), text);
}

TEST_F(WholeFile, AFolderThatMayNotBeWrittenLeavesTheOldOne) {
  // To root every folder is writable, but not one that is not there.
  const fs::path file = folder_ / "none" / "page.html";
  EXPECT_EQ(tests::error_of([&] { return write_text(file, "new"), 0; }),
            "writing " + file.string() + " failed (No such file or directory)" + what_to_do);
  fs::permissions(folder_.path(), fs::perms::owner_read | fs::perms::owner_exec);
  if (::access(folder_.path().c_str(), W_OK) != 0) {
    EXPECT_THROW(write_text(file_, "new"), Error);
  }
  fs::permissions(folder_.path(), fs::perms::owner_all);
  expect_untouched();
}

TEST_F(WholeFile, AWriterThatGivesUpLeavesTheOldOne) {
  EXPECT_THROW(write_beside(file_,
                            [](const fs::path& partial) {
                              std::ofstream(partial) << "half";
                              throw std::domain_error("no more");
                            }),
               std::domain_error);
  expect_untouched();
}

TEST_F(WholeFile, WhatCannotTakeItsPlaceIsGone) {
  fs::remove(file_);
  fs::create_directories(file_ / "in the way");
  EXPECT_EQ(tests::error_of([&] { return write_text(file_, "new"), 0; }),
            "writing " + file_.string() + " failed (Is a directory)" + what_to_do);
  EXPECT_TRUE(fs::is_directory(file_ / "in the way"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace slackwater::whole_file_test
