// The vessels about a site, as `serve` answers them: what the command answers, at any time, also of
// hostile logs.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/api/door/desk/desk_served.h"
#include "tests/support/ais_table_for_tests.h"
#include "tests/support/contains.h"

namespace slackwater::tests::desk_traffic_test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// The server knows what it heard in the tests before: each has vessels of its own, and the one
/// that is held against the command is of an earlier hour than all others.
class DeskTraffic : public DeskServed {
 protected:
  void SetUp() override {
    DeskServed::SetUp();
    place_ = got("/sites/farm").at("place");
  }
  void TearDown() override { fs::remove(path("heard.csv")); }
  /// South of the farm, so many metres.
  [[nodiscard]] AisRow ship(unsigned mmsi, double south_m,
                            const std::string& time = "2025-03-04T06:08:00") const {
    AisRow row;
    row.mmsi = mmsi;
    row.time = time;
    row.latitude_deg = place_.at("latitude_deg").get<double>() - south_m / 111'300;
    row.longitude_deg = place_.at("longitude_deg").get<double>();
    return row;
  }
  static void write(const std::string& text) {
    std::ofstream(path("heard.csv"), std::ios::binary) << text;
  }
  static json at(const std::string& time) { return got("/sites/farm/traffic?at=" + time); }
  static json vessel(const json& told, unsigned mmsi) {
    for (const json& one : told.at("vessels"))
      if (one.at("mmsi") == mmsi) return one;
    return nullptr;
  }
  static bool comes(const std::function<bool(const json&)>& is_so,
                    const std::string& time = "2025-03-04T06:10:00Z") {
    return comes_true([&] { return is_so(at(time)); });
  }
  static bool is_heard(unsigned mmsi, const std::string& time = "2025-03-04T06:10:00Z") {
    return comes([=](const json& told) { return !vessel(told, mmsi).is_null(); }, time);
  }
  json place_;
};

TEST_F(DeskTraffic, IsThatOfTheCommand) {
  const AisRow first = ship(1, 4000, "2025-03-04T02:08:00");
  AisRow late = ship(3, 9000, "2025-03-04T02:08:00");
  late.course_deg = 90;
  write(ais_table_head + ais_line(ship(2, -3000, "2025-03-04T01:40:00")) + ais_line(first) +
        ais_line(late) + ais_line(ship(1, 100, "2025-03-04T02:30:00")));
  ASSERT_TRUE(is_heard(1, "2025-03-04T02:30:00Z"));
  for (const char* time : {"2025-03-04T02:10:00Z", "2025-03-04T02:09:00Z", "2025-03-04T01:00:00Z",
                           "2025-03-04T02:31:00Z", "2025-03-04T04:00:00Z"})
    EXPECT_EQ(at(time), told({"ais", path("heard.csv"), "--site", "farm", "--at", time})) << time;
  const json then = at("2025-03-04T02:10:00Z");
  const json& near = then.at("vessels").at(0);
  EXPECT_EQ(near.at("mmsi"), 1) << "marked ones first: " << then;
  EXPECT_EQ(near.at("name"), "NORTHERN STAR");
  EXPECT_EQ(near.at("kind"), "cargo ship");
  EXPECT_EQ(near.at("age_s"), 120);
  EXPECT_EQ(near.at("dead_reckoned"), true);
  // 10 kn for two minutes of the 4000 m.
  EXPECT_NEAR(near.at("distance_m").get<double>(), 4000 - 120 * 10 * 1852.0 / 3600, 10);
  EXPECT_NEAR(near.at("to_site").at("tcpa_s").get<double>(), 4000 / (10 * 1852.0 / 3600) - 120, 3);
  EXPECT_EQ(near.at("alarm"), "closing");
  EXPECT_EQ(near.at("to_turbine").at("turbine"), "T1");
  EXPECT_EQ(vessel(then, 2).at("state"), "old");
  EXPECT_EQ(vessel(then, 2).at("to_site"), nullptr);
  const json before = at("2025-03-04T01:00:00Z");
  EXPECT_TRUE(before.at("vessels").empty());
  EXPECT_TRUE(contains(before.at("in_words").get<std::string>(), "Nothing was heard by then"))
      << before;
  EXPECT_EQ(before.at("last_heard"), nullptr);
  const json after = at("2025-03-04T04:00:00Z");
  EXPECT_TRUE(after.at("vessels").empty()) << "nothing is carried on beyond the rule";
  EXPECT_TRUE(contains(after.at("in_words").get<std::string>(),
                       "last heard at 2025-03-04T02:30:00Z, 90 min before"))
      << after;
}

TEST_F(DeskTraffic, NowIsTheServersAndItsTagTellsWhetherItChanged) {
  write(ais_table_head + ais_line(ship(11, 4000)) +
        ais_line(ship(13, 4000, "2025-03-04T09:00:00")));
  ASSERT_TRUE(is_heard(11));
  EXPECT_EQ(vessel(at("2025-03-04T09:01:00Z"), 13), nullptr)
      << "the log holds it, and the server's clock has not come to it";
  const json now = got("/sites/farm/traffic");
  EXPECT_EQ(now.at("at").get<std::string>().substr(0, 15), "2025-03-04T06:1") << "as --at said";
  const std::string target = "/sites/farm/traffic?at=2025-03-04T06:10:00Z";
  const std::string tag = reply(target).field("etag");
  ASSERT_FALSE(tag.empty());
  EXPECT_EQ(reply(target, "If-None-Match: " + tag + "\r\n").status, 304);
  std::ofstream(path("heard.csv"), std::ios::app) << ais_line(ship(12, 5000));
  EXPECT_TRUE(
      comes_true([&] { return reply(target, "If-None-Match: " + tag + "\r\n").status == 200; }));
}

TEST_F(DeskTraffic, ALogThatBreaksIsSaidWithWhenTrafficWasHeardLast) {
  write(ais_table_head + ais_line(ship(21, 4000)));
  ASSERT_TRUE(is_heard(21));
  fs::remove(path("heard.csv"));
  const std::string time = "2025-03-04T06:20:00Z";
  EXPECT_TRUE(comes(
      [](const json& told) {
        const std::string words = told.at("in_words");
        return contains(words, "The log heard.csv is not there") &&
               contains(words, "last heard at 2025-03-04T06:08:00Z, 12 min before");
      },
      time))
      << at(time);
  EXPECT_EQ(vessel(at(time), 21).at("state"), "old");
  ASSERT_EQ(::mkfifo(path("heard.csv").c_str(), 0600), 0);
  EXPECT_TRUE(comes([](const json& told) {
    return contains(told.at("sources").at(0).at("trouble").dump(), "is a pipe");
  }));
  EXPECT_FALSE(contains(at(time).dump(), made_->store().parent_path().string()))
      << "paths are the server's own";
}

TEST_F(DeskTraffic, HostileNamesAreTextAndNoMore) {
  AisRow script = ship(31, 4000), control = ship(32, 4100), twenty = ship(33, 4200);
  script.name = "<script>alert(1)";
  control.name = "A\x01\x1b[31mB\x7f\xff";
  twenty.name = "\"&<>'\\/ABCDEFGHIJKLM";
  write(ais_table_head + ais_line(script) + ais_line(control) + ais_line(twenty));
  ASSERT_TRUE(is_heard(33));
  const json now = at("2025-03-04T06:10:00Z");
  EXPECT_EQ(vessel(now, 31).at("name"), script.name);
  EXPECT_EQ(vessel(now, 32).at("name"), "A[31mB") << "nothing that a terminal obeys";
  EXPECT_EQ(vessel(now, 33).at("name"), twenty.name);
  const ProgramResult text =
      made_->run({"ais", path("heard.csv"), "--site", "farm", "--at", "2025-03-04T06:10:00Z"});
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_EQ(text.out.find_first_of("\x1b\x01\x7f"), std::string::npos);
  EXPECT_TRUE(contains(text.out, "passes")) << text.out;
}

TEST_F(DeskTraffic, WhatCannotBeAnsweredIsRefused) {
  EXPECT_EQ(reply("/sites/farm/traffic?at=yesterday").status, 400);
  EXPECT_EQ(reply("/sites/farm/traffic?mmsi=1").status, 400);
  EXPECT_EQ(reply("/sites/nowhere/traffic").status, 404);
  EXPECT_EQ(got("/sites/bare/traffic").at("site"), "bare") << "no forecast is needed";
  const json document = got("/api");
  EXPECT_TRUE(document.at("paths").contains("/sites/{siteId}/traffic"));
  const ProgramResult wrong =
      made_->run({"ais", path("heard.csv"), "--at", "2025-03-04T06:10:00Z"});
  EXPECT_EQ(wrong.exit_code, 2) << "--at without --site";
}

TEST_F(DeskTraffic, LimitsAreThoseThatWereSaid) {
  write(ais_table_head + ais_line(ship(41, 4000)));
  const std::string time = "2025-03-04T06:10:00Z";
  const json strict = told(
      {"ais", path("heard.csv"), "--site", "farm", "--at", time, "--tcpa", "5min", "--cpa", "300"});
  EXPECT_EQ(strict.at("limits"), (json{{"cpa_m", 300}, {"tcpa_s", 300}}));
  EXPECT_EQ(strict.at("vessels").at(0).at("alarm"), nullptr) << "it takes ten minutes";
}

}  // namespace
}  // namespace slackwater::tests::desk_traffic_test
