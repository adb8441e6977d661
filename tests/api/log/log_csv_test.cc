#include "api/log/log_csv.h"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <sstream>

#include "fields/base/error.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::log_csv_test {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

ingest::TrajectoryFile small_log() {
  ingest::TrajectoryFile log;
  log.names = {"rov", "a, b"};
  log.epoch = parse_utc("2025-03-10T06:00:00Z");
  log.t_s = {0, 0.5};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  log.variables = {{"x", "", "m", "east", 1, {1, 2, 3, nan}},
                   {"velocity", "", "m s-1", "", 2, {1, 2, 3, 4, 5, 6, 7, 8}},
                   {"task", "", "1", "", 1, {0, 0, 1, 1}}};
  log.tables = {{"alarm", {{"begin", "s", "", {12.5}}}, {{"name", "", {"tug \"A\""}}}},
                {"empty", {{"begin", "s", "", {}}}, {}}};
  return log;
}

TEST(LogCsv, HasARowAVehicleAndTimeWithTheUnitBehindTheName) {
  const TemporaryFolder folder;
  const auto files = api::write_log_csv(small_log(), folder / "run.csv");
  EXPECT_EQ(text_of(folder / "run.csv"),
            "vehicle,time,t_s,x_m,velocity_0_m_s,velocity_1_m_s,task\n"
            "rov,2025-03-10T06:00:00Z,0,1,1,2,0\n"
            "rov,2025-03-10T06:00:00.500Z,0.5,2,3,4,0\n"
            "\"a, b\",2025-03-10T06:00:00Z,0,3,5,6,1\n"
            "\"a, b\",2025-03-10T06:00:00.500Z,0.5,,7,8,1\n");
  ASSERT_EQ(files.size(), 2U) << "a list without rows is no file";
  EXPECT_EQ(files[1], folder / "run-alarm.csv");
  EXPECT_EQ(text_of(files[1]), "name,begin_s\n\"tug \"\"A\"\"\",12.5\n");
}

TEST(LogCsv, AFullOrForbiddenPlaceIsAnErrorAndNoFile) {
  const TemporaryFolder folder;
  EXPECT_THROW((void)api::write_log_csv(small_log(), folder / "no/run.csv"), Error);
  EXPECT_FALSE(std::filesystem::exists(folder / "no"));
}

TEST(LogCsv, UnitsBecomeSuffixes) {
  EXPECT_EQ(api::unit_suffix("m s-1"), "m_s");
  EXPECT_EQ(api::unit_suffix("rad s-1"), "rad_s");
  EXPECT_EQ(api::unit_suffix("1"), "");
  EXPECT_EQ(api::unit_suffix("degrees_north"), "deg");
  EXPECT_EQ(api::unit_suffix("W"), "w");
}

}  // namespace
}  // namespace slackwater::tests::log_csv_test
