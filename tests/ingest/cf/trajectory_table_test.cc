#include "ingest/cf/trajectory_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "ingest/cf/trajectory_file.h"
#include "tests/support/store_for_tests.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::ingest::trajectory_table_test {
namespace {

TrajectoryFile with_tables() {
  TrajectoryFile tracks;
  tracks.names = {"usv"};
  tracks.epoch = parse_utc("2025-06-02T06:00:00Z");
  tracks.t_s = {0, 1, 2};
  tracks.variables.push_back({"x", "", "m", "east", 1, {0, 1, 2}});
  tracks.tables.push_back({"alarm",
                           {{"begin", "s", "raised", {0.1, 1.0 / 3}},
                            {"cpa", "m", "as foreseen", {std::nan(""), -0.0}}},
                           {{"name", "of the vessel", {"A", "SOMETHING LONGER"}}}});
  tracks.tables.push_back({"empty", {{"begin", "s", "raised", {}}}, {}});
  return tracks;
}

TEST(TrajectoryTable, IsReadAsItWasWrittenToTheBit) {
  const slackwater::tests::TemporaryFolder folder;
  const TrajectoryFile written = with_tables();
  write_trajectories(written, folder.path() / "run.nc");
  const TrajectoryFile read = read_trajectories(folder.path() / "run.nc");
  EXPECT_EQ(read.variables.size(), 1U);
  ASSERT_EQ(read.tables.size(), 1U) << "one without rows is not written";
  const TrajectoryTable& table = *read.find_table("alarm");
  EXPECT_EQ(table.rows(), 2U);
  EXPECT_EQ(*table.text("name"), (std::vector<std::string>{"A", "SOMETHING LONGER"}));
  EXPECT_EQ(table.columns[0].units, "s");
  EXPECT_EQ(table.columns[0].long_name, "raised");
  for (const TrajectoryTable::Column& column : written.tables[0].columns) {
    const std::vector<double>* values = table.column(column.name);
    ASSERT_NE(values, nullptr);
    EXPECT_EQ(std::memcmp(values->data(), column.values.data(), 2 * sizeof(double)), 0);
  }
  EXPECT_EQ(table.column("end"), nullptr);
  EXPECT_EQ(read.find_table("empty"), nullptr);
  // What was read is written to the same bytes.
  write_trajectories(read, folder.path() / "again.nc");
  EXPECT_EQ(slackwater::tests::read_bytes(folder.path() / "again.nc"),
            slackwater::tests::read_bytes(folder.path() / "run.nc"));
}

}  // namespace
}  // namespace slackwater::ingest::trajectory_table_test
