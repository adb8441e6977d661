// Daylight asked for beyond the polar circle: the answer says what kind of day it is.
#include <gtest/gtest.h>

#include "ingest/cf/forecast/forecast_file.h"
#include "tests/api/windows_command.h"
#include "tests/support/made_up_forecast.h"

namespace slackwater::tests::cli_windows_polar_test {
namespace {

/// A pile off Svalbard, and a forecast of three days from that day on.
class PolarFarm {
 public:
  explicit PolarFarm(const std::string& day) {
    Snapshot snapshot = made_up_forecast({.members = 3});
    const auto later = parse_day(day) - snapshot.day;
    snapshot.day += later;
    snapshot.issued += later;
    for (UtcTime& time : snapshot.time) time += later;
    snapshot.columns.front().point = GeoPoint::from_degrees(76.5, 16.0);
    ingest::write_forecast(made_.file("polar.nc"), snapshot);
    made_.write("peek.yaml", peek(loose));
    made_.write("polar.yaml", "id: polar\nname: Polar\nlatitude_deg: 76.5\nlongitude_deg: 16.0\n" +
                                  pile_yaml +
                                  "turbines: [{id: T1, latitude_deg: 76.5, longitude_deg: 16}]\n");
  }
  [[nodiscard]] json task(const std::string& light) const {
    const ProgramResult result =
        made_.run({"windows", "--json", "--site", made_.path("polar.yaml"), "--forecast",
                   made_.path("polar.nc"), "--task", made_.path("peek.yaml"), "--light", light});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return json::accept(result.out) ? json::parse(result.out).at("tasks")[0] : json();
  }

 private:
  StoreForTests made_;
};

std::size_t open_starts(const json& task) {
  std::size_t open = 0;
  for (const json& start : task.at("starts")) open += start.at("futures_held") == 3 ? 1 : 0;
  return open;
}

TEST(PolarWindows, OfTheNightAreShutAndSayThatItIsDarkAllDay) {
  const json task = PolarFarm("2025-12-20").task("civil");
  EXPECT_EQ(open_starts(task), 0U);
  EXPECT_EQ(task.at("verdict"), "no-go");
  ASSERT_EQ(task.at("notes").size(), 1U) << task.at("notes");
  const std::string note = task.at("notes")[0];
  EXPECT_NE(note.find("dark all day"), std::string::npos) << note;
  EXPECT_NE(note.find("76.5 degrees north on 2025-12-22"), std::string::npos) << note;
  EXPECT_NE(task.at("starts")[20].at("binding").at("limit").get<std::string>().find("daylight"),
            std::string::npos);
}

TEST(PolarWindows, OfTheDayAreOpenAtMidnight) {
  const json task = PolarFarm("2025-06-20").task("sun_up");
  EXPECT_EQ(open_starts(task), task.at("starts").size());
  ASSERT_EQ(task.at("notes").size(), 1U) << task.at("notes");
  EXPECT_NE(task.at("notes")[0].get<std::string>().find("light all day"), std::string::npos);
}

TEST(PolarWindows, OfADayWithNightSayNothingOfIt) {
  const json task = PolarFarm("2025-03-18").task("sun_up");
  EXPECT_TRUE(task.at("notes").empty());
  EXPECT_GT(open_starts(task), 0U);
  EXPECT_LT(open_starts(task), task.at("starts").size());
}

}  // namespace
}  // namespace slackwater::tests::cli_windows_polar_test
