#include "ingest/cf/trajectory_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "fields/base/error.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::ingest::trajectory_file_test {
namespace {

TrajectoryFile two_tracks() {
  TrajectoryFile tracks;
  tracks.names = {"rov", "the other one"};
  tracks.epoch = parse_utc("2025-06-02T06:00:00Z");
  tracks.t_s = {0, 0.5, 1};
  tracks.variables.push_back(
      {"latitude", "latitude", "degrees_north", "latitude", 1, {54, 54.1, 54.2, 55, 55.1, 55.2}});
  std::vector<double> thrust;
  for (int i = 0; i < 24; ++i) thrust.push_back(i == 7 ? std::nan("") : 0.1 * i);
  tracks.variables.push_back({"thrust", "", "N", "thrust of each thruster", 4, thrust});
  tracks.attributes = {{"title", "a run"}, {"seed", "7"}, {"scenario", "name: x\nseed: 7\n"}};
  return tracks;
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

TEST(TrajectoryFile, ReadsWhatItWrote) {
  const slackwater::tests::TemporaryFolder folder;
  const TrajectoryFile written = two_tracks();
  write_trajectories(written, folder.path() / "run.nc");
  const TrajectoryFile read = read_trajectories(folder.path() / "run.nc");
  EXPECT_EQ(read.names, written.names);
  EXPECT_EQ(read.epoch, written.epoch);
  EXPECT_EQ(read.t_s, written.t_s);
  EXPECT_EQ(read.attributes, written.attributes);
  EXPECT_EQ(read.attribute("seed"), "7");
  ASSERT_EQ(read.variables.size(), 2U);
  const auto* thrust = read.find("thrust");
  ASSERT_NE(thrust, nullptr);
  EXPECT_EQ(thrust->per, 4U);
  EXPECT_EQ(thrust->units, "N");
  for (std::size_t i = 0; i < 24; ++i) {
    if (i == 7)
      EXPECT_TRUE(std::isnan(thrust->values[i]));
    else
      EXPECT_EQ(thrust->values[i], written.variables[1].values[i]);
  }
}

TEST(TrajectoryFile, TheSameContentIsTheSameBytes) {
  const slackwater::tests::TemporaryFolder folder;
  write_trajectories(two_tracks(), folder.path() / "one.nc");
  write_trajectories(two_tracks(), folder.path() / "a name of another length.nc");
  const std::string one = bytes_of(folder.path() / "one.nc");
  EXPECT_GT(one.size(), 1000U);
  EXPECT_EQ(one, bytes_of(folder.path() / "a name of another length.nc"));
  TrajectoryFile other = two_tracks();
  other.variables[0].values[3] = std::nextafter(55, 56);
  write_trajectories(other, folder.path() / "other.nc");
  EXPECT_NE(one, bytes_of(folder.path() / "other.nc"));
}

TEST(TrajectoryFile, RefusesOtherFiles) {
  const slackwater::tests::TemporaryFolder folder;
  EXPECT_THROW((void)read_trajectories(folder.path() / "none.nc"), Error);
  std::ofstream(folder.path() / "text.nc") << "not a NetCDF file";
  EXPECT_THROW((void)read_trajectories(folder.path() / "text.nc"), Error);
  write_trajectories(two_tracks(), folder.path() / "cut.nc");
  std::filesystem::resize_file(folder.path() / "cut.nc", 900);
  EXPECT_THROW((void)read_trajectories(folder.path() / "cut.nc"), Error);
}

}  // namespace
}  // namespace slackwater::ingest::trajectory_file_test
