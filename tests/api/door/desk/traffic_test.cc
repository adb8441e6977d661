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

class DeskTraffic : public DeskServed {
 protected:
  void SetUp() override {
    DeskServed::SetUp();
    place_ = got("/sites/farm").at("place");
  }
  void TearDown() override { fs::remove(path("heard.csv")); }
  /// South of the farm, so many metres.
  [[nodiscard]] AisRow ship(unsigned mmsi, double south_m) const {
    AisRow row;
    row.mmsi = mmsi;
    row.time = "2025-03-04T06:08:00";
    row.latitude_deg = place_.at("latitude_deg").get<double>() - south_m / 111'300;
    row.longitude_deg = place_.at("longitude_deg").get<double>();
    return row;
  }
  static void write(const std::string& text) {
    std::ofstream(path("heard.csv"), std::ios::binary) << text;
  }
  static json at(const std::string& time) { return got("/sites/farm/traffic?at=" + time); }
  static bool comes(const std::function<bool(const json&)>& is_so,
                    const std::string& time = "2025-03-04T06:10:00Z") {
    return comes_true([&] { return is_so(at(time)); });
  }
  static bool comes_number(std::size_t vessels) {
    return comes([=](const json& told) { return told.at("vessels").size() == vessels; });
  }
  json place_;
};

TEST_F(DeskTraffic, IsThatOfTheCommand) {
  AisRow old = ship(2, -3000), late = ship(3, 9000), later = ship(1, 100);
  old.time = "2025-03-04T05:40:00";
  late.course_deg = 90;
  later.time = "2025-03-04T06:30:00";
  write(ais_table_head + ais_line(old) + ais_line(ship(1, 4000)) + ais_line(late) +
        ais_line(later));
  ASSERT_TRUE(comes_number(3));
  for (const char* time : {"2025-03-04T06:10:00Z", "2025-03-04T06:09:00Z", "2025-03-04T05:00:00Z",
                           "2025-03-04T06:31:00Z", "2025-03-04T12:00:00Z"})
    EXPECT_EQ(at(time), told({"ais", path("heard.csv"), "--site", "farm", "--at", time})) << time;
  const json now = at("2025-03-04T06:10:00Z");
  const json& first = now.at("vessels").at(0);
  EXPECT_EQ(first.at("mmsi"), 1) << "marked ones first: " << now;
  EXPECT_EQ(first.at("name"), "NORTHERN STAR");
  EXPECT_EQ(first.at("kind"), "cargo ship");
  EXPECT_EQ(first.at("age_s"), 120);
  EXPECT_EQ(first.at("dead_reckoned"), true);
  // 10 kn for two minutes of the 4000 m.
  EXPECT_NEAR(first.at("distance_m").get<double>(), 4000 - 120 * 10 * 1852.0 / 3600, 10);
  EXPECT_NEAR(first.at("to_site").at("tcpa_s").get<double>(), 4000 / (10 * 1852.0 / 3600) - 120, 3);
  EXPECT_EQ(first.at("alarm"), "closing");
  EXPECT_EQ(first.at("to_turbine").at("turbine"), "T1");
  const json& hollow = now.at("vessels").at(1);
  EXPECT_EQ(hollow.at("state"), "old");
  EXPECT_EQ(hollow.at("to_site"), nullptr);
  const json before = at("2025-03-04T05:00:00Z");
  EXPECT_TRUE(before.at("vessels").empty());
  EXPECT_TRUE(contains(before.at("in_words").get<std::string>(), "Nothing was heard by then"))
      << before;
  EXPECT_EQ(before.at("last_heard"), nullptr);
  const json noon = at("2025-03-04T12:00:00Z");
  EXPECT_TRUE(noon.at("vessels").empty()) << "nothing is carried on beyond the rule";
  EXPECT_TRUE(contains(noon.at("in_words").get<std::string>(),
                       "last heard at 2025-03-04T06:30:00Z, 5 h 30 min before"))
      << noon;
}

TEST_F(DeskTraffic, NowIsTheServersAndItsTagTellsWhetherItChanged) {
  write(ais_table_head + ais_line(ship(1, 4000)));
  ASSERT_TRUE(comes_number(1));
  const json now = got("/sites/farm/traffic");
  EXPECT_EQ(now.at("at").get<std::string>().substr(0, 15), "2025-03-04T06:1") << "as --at said";
  const std::string target = "/sites/farm/traffic?at=2025-03-04T06:10:00Z";
  const std::string tag = reply(target).field("etag");
  ASSERT_FALSE(tag.empty());
  EXPECT_EQ(reply(target, "If-None-Match: " + tag + "\r\n").status, 304);
  std::ofstream(path("heard.csv"), std::ios::app) << ais_line(ship(2, 5000));
  EXPECT_TRUE(
      comes_true([&] { return reply(target, "If-None-Match: " + tag + "\r\n").status == 200; }));
}

TEST_F(DeskTraffic, ALogThatBreaksIsSaidWithWhenTrafficWasHeardLast) {
  fs::remove(path("heard.csv"));
  write(ais_table_head + ais_line(ship(1, 4000)));
  ASSERT_TRUE(comes_number(1));
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
  EXPECT_EQ(at(time).at("vessels").at(0).at("state"), "old");
  ASSERT_EQ(::mkfifo(path("heard.csv").c_str(), 0600), 0);
  EXPECT_TRUE(comes([](const json& told) {
    return contains(told.at("sources").at(0).at("trouble").dump(), "is a pipe");
  }));
  EXPECT_FALSE(contains(at(time).dump(), made_->store().parent_path().string()))
      << "paths are the server's own";
}

TEST_F(DeskTraffic, HostileNamesAreTextAndNoMore) {
  AisRow script = ship(1, 4000), control = ship(2, 4100), twenty = ship(3, 4200);
  script.name = "<script>alert(1)";
  control.name = "A\x01\x1b[31mB\x7f\xff";
  twenty.name = "\"&<>'\\/ABCDEFGHIJKLM";
  write(ais_table_head + ais_line(script) + ais_line(control) + ais_line(twenty));
  ASSERT_TRUE(comes_number(3));
  const json vessels = at("2025-03-04T06:10:00Z").at("vessels");
  EXPECT_EQ(vessels[0].at("name"), script.name);
  EXPECT_EQ(vessels[1].at("name"), "A[31mB") << "nothing that a terminal obeys";
  EXPECT_EQ(vessels[2].at("name"), twenty.name);
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
  write(ais_table_head + ais_line(ship(1, 4000)));
  const std::string time = "2025-03-04T06:10:00Z";
  const json strict = told(
      {"ais", path("heard.csv"), "--site", "farm", "--at", time, "--tcpa", "5min", "--cpa", "300"});
  EXPECT_EQ(strict.at("limits"), (json{{"cpa_m", 300}, {"tcpa_s", 300}}));
  EXPECT_EQ(strict.at("vessels").at(0).at("alarm"), nullptr) << "it takes ten minutes";
}

}  // namespace
}  // namespace slackwater::tests::desk_traffic_test
