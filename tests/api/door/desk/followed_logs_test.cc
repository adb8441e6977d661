// Logs that somebody writes, rotates, breaks and takes away while they are followed.
#include "api/door/desk/followed_logs.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "tests/support/ais_table_for_tests.h"
#include "tests/support/comes_true.h"
#include "tests/support/contains.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::followed_logs_test {
namespace {

using api::desk::FollowedLogs;
using api::desk::LogFollowing;
using std::chrono::milliseconds;
namespace fs = std::filesystem;

const UtcTime late = parse_utc("2025-03-05T00:00:00Z");

std::string line(unsigned mmsi, int minute, const std::string& name = "STAR") {
  AisRow row;
  row.mmsi = mmsi;
  row.time = formatted("2025-03-04T06:{:02}:00", minute);
  row.name = name;
  return ais_line(row);
}

class FollowedLog : public testing::Test {
 protected:
  void write(const std::string& text) { std::ofstream(file_, std::ios::binary) << text; }
  void append(const std::string& text) {
    std::ofstream(file_, std::ios::binary | std::ios::app) << text;
  }
  std::unique_ptr<FollowedLogs> follow(LogFollowing following = {}) {
    following.every = milliseconds(5);
    return std::make_unique<FollowedLogs>(std::vector<fs::path>{file_}, following);
  }
  static std::size_t known(const FollowedLogs& logs) { return logs.heard(late).vessels.size(); }
  static std::string trouble(const FollowedLogs& logs) {
    return logs.heard(late).sources.at(0).trouble;
  }
  static bool says(const FollowedLogs& logs, const std::string& words) {
    return comes_true([&] { return contains(trouble(logs), words); });
  }
  static bool is_well(const FollowedLogs& logs) {
    return comes_true([&] { return trouble(logs).empty(); });
  }

  TemporaryFolder folder_;
  fs::path file_ = folder_ / "live.csv";
};

TEST_F(FollowedLog, WhatIsAddedIsHeard) {
  write(ais_table_head + line(1, 0));
  const auto logs = follow();
  ASSERT_TRUE(comes_true([&] { return known(*logs) == 1; }));
  EXPECT_TRUE(is_well(*logs));
  EXPECT_EQ(logs->heard(late).sources.at(0).file, "live.csv") << "without its folder";
  append(line(2, 1) + line(1, 1));
  ASSERT_TRUE(comes_true([&] { return known(*logs) == 2; }));
  EXPECT_EQ(logs->heard(late).last, parse_utc("2025-03-04T06:01:00Z"));
  EXPECT_EQ(logs->heard(parse_utc("2025-03-04T06:00:30Z")).vessels.size(), 1U);
}

TEST_F(FollowedLog, ALineThatIsNotWholeIsReadWhenItIs) {
  const std::string second = line(2, 1);
  write(ais_table_head + line(1, 0) + second.substr(0, 30));
  const auto logs = follow();
  ASSERT_TRUE(comes_true([&] { return known(*logs) == 1; }));
  EXPECT_TRUE(is_well(*logs));
  append(second.substr(30));
  EXPECT_TRUE(comes_true([&] { return known(*logs) == 2; }));
  EXPECT_TRUE(is_well(*logs));
}

TEST_F(FollowedLog, ARotatedLogIsReadAnewAndWhatWasHeardStays) {
  write(ais_table_head + line(1, 0) + line(2, 0) + line(3, 0));
  const auto logs = follow();
  ASSERT_TRUE(comes_true([&] { return known(*logs) == 3; }));
  fs::rename(file_, folder_ / "live.csv.1");
  EXPECT_TRUE(says(*logs, "live.csv is not there"));
  EXPECT_EQ(known(*logs), 3U);
  write("");
  EXPECT_TRUE(says(*logs, "is empty"));
  append(ais_table_head + line(4, 1));
  EXPECT_TRUE(comes_true([&] { return known(*logs) == 4; }));
  EXPECT_TRUE(is_well(*logs));
}

TEST_F(FollowedLog, ATruncatedLogIsReadFromItsBeginning) {
  write(ais_table_head + line(1, 0) + line(2, 0) + line(3, 0));
  const auto logs = follow();
  ASSERT_TRUE(comes_true([&] { return known(*logs) == 3; }));
  write(ais_table_head + line(4, 1));  // the same file, shorter
  EXPECT_TRUE(comes_true([&] { return known(*logs) == 4; }));
  // Truncated and longer than before at the next look: its beginning tells.
  std::string other = "MMSI,BaseDateTime,LAT,LON,SOG,COG\n";
  for (int i = 5; i < 15; ++i) other += formatted("{},2025-03-04T07:00:00,54,6.5,5,90\n", i);
  write(other);
  EXPECT_TRUE(comes_true([&] { return known(*logs) == 14; }));
}

TEST_F(FollowedLog, WhatIsNoFileIsSaidAndNotWaitedFor) {
  ASSERT_EQ(::mkfifo(file_.c_str(), 0600), 0);
  auto logs = follow();
  EXPECT_TRUE(says(*logs, "live.csv is a pipe, expected the file of a log"));
  fs::remove(file_);
  fs::create_symlink("/dev/zero", file_);
  EXPECT_TRUE(says(*logs, "is a device"));
  fs::remove(file_);
  fs::create_directory(file_);
  EXPECT_TRUE(says(*logs, "is a folder"));
  fs::remove(file_);
  fs::create_symlink(file_, file_);
  EXPECT_TRUE(says(*logs, "cannot be opened"));
  fs::remove(file_);
  write(ais_table_head + line(1, 0));
  EXPECT_TRUE(is_well(*logs));
  EXPECT_EQ(known(*logs), 1U);
}

TEST_F(FollowedLog, GarbageIsSaidAndWhatWasHeardStays) {
  write(ais_table_head + line(1, 0));
  const auto logs = follow();
  ASSERT_TRUE(comes_true([&] { return known(*logs) == 1; }));
  std::string garbage;
  for (int i = 0; i < 400; ++i)
    garbage +=
        "\xff"
        "garbage" +
        std::string(1, '\0') + std::to_string(i) + "\n";
  append(garbage);
  EXPECT_TRUE(says(*logs, "are no AIS (line "));
  EXPECT_EQ(known(*logs), 1U);
  append("\n" + line(2, 1));
  EXPECT_TRUE(comes_true([&] { return known(*logs) == 2; })) << "it goes on behind it";
  write(std::string(300'000, '\0'));
  EXPECT_TRUE(says(*logs, "no AIS"));
  write(
      "\x28\xB5\x2F\xFD"
      "not really packed");
  EXPECT_TRUE(says(*logs, "packed"));
  write("name,mmsi,when\na,1,2\n");
  EXPECT_TRUE(says(*logs, "rename them"));
  EXPECT_FALSE(contains(trouble(*logs), "/proc/")) << trouble(*logs);
  EXPECT_EQ(known(*logs), 2U);
}

TEST_F(FollowedLog, OfOneThatIsTooLargeTheEndIsRead) {
  std::string text = ais_table_head;
  for (unsigned i = 1; i <= 1000; ++i) text += line(i, 0);
  write(text);
  LogFollowing following;
  following.most_bytes = 10'000;
  const auto logs = follow(following);
  EXPECT_TRUE(says(*logs, "only the last"));
  EXPECT_GT(known(*logs), 50U);
  EXPECT_LT(known(*logs), 200U);
  // A hole of a terabyte in front, which no disk has: it is not read.
  fs::resize_file(file_, 1ULL << 40U);
  EXPECT_TRUE(says(*logs, "no AIS"));
  append("\n" + line(2000, 1));
  EXPECT_TRUE(
      comes_true([&] { return logs->heard(late).last == parse_utc("2025-03-04T06:01:00Z"); }));
}

TEST_F(FollowedLog, ADecoderThatIsNotThereIsSaid) {
  SLACKWATER_NEEDS_SHARED(shared);
  fs::copy_file(shared / "data/ais/danish_shore_station_2010-06-11.nmea", file_);
  LogFollowing following;
  following.decoder.command = {"no-such-decoder"};
  following.decoder.install_advice = "apt install gpsd-clients";
  const auto logs = follow(following);
  EXPECT_TRUE(says(*logs, "apt install gpsd-clients"));
}

TEST_F(FollowedLog, ARealLogWrittenBitByBitIsTheWholeLog) {
  SLACKWATER_NEEDS_SHARED(shared);
  std::ifstream stream(shared / "data/ais/danish_shore_station_2010-06-11.nmea", std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  const UtcTime then = parse_utc("2010-06-11T12:00:00Z");
  write(text);
  const auto whole = follow();
  ASSERT_TRUE(is_well(*whole));
  const auto all = whole->heard(then);
  ASSERT_GT(all.vessels.size(), 100U);
  file_ = folder_ / "growing.nmea";
  write(text.substr(0, 30'011));
  const auto growing = follow();
  for (std::size_t at = 30'011; at < text.size(); at += 40'009) {
    ASSERT_TRUE(comes_true([&] { return growing->heard(then).last.has_value(); }));
    append(text.substr(at, 40'009));
    std::this_thread::sleep_for(milliseconds(30));
  }
  EXPECT_TRUE(comes_true([&] {
    const auto now = growing->heard(then);
    if (now.vessels.size() != all.vessels.size() || now.last != all.last) return false;
    for (std::size_t i = 0; i < all.vessels.size(); ++i)
      if (!(now.vessels[i].position == all.vessels[i].position) ||
          !(now.vessels[i].identity == all.vessels[i].identity))
        return false;
    return true;
  }));
}

TEST_F(FollowedLog, ItEndsAtOnceAndQuestionsGoOnWhileItReads) {
  std::string text = ais_table_head;
  for (int i = 0; i < 200'000; ++i) text += line(1 + static_cast<unsigned>(i % 500), i % 60);
  write(text);
  const auto logs = follow();
  const auto begun = std::chrono::steady_clock::now();
  (void)logs->heard(late);
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(2));
}

}  // namespace
}  // namespace slackwater::tests::followed_logs_test
