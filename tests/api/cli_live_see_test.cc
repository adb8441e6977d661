// `live --see`: sensors on the vehicles of a live run, in its recording, and told at its end.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "ingest/netcdf/file.h"
#include "tests/api/door/live/live_records.h"
#include "tests/support/contains.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::cli_live_see_test {
namespace {

using nlohmann::json;

class LiveSee : public testing::Test {
 protected:
  LiveSee() {
    std::ofstream(folder_ / "run.yaml")
        << "name: seen\nseed: 7\nduration: 1min\nstep_s: 0.05\nlog_every_s: 0.5\n"
           "water: {made_up: {depth_m: 30}}\nstructures:\n  - {name: pile, kind: cylinder, "
           "north_m: 0, east_m: 0, diameter_m: 6, top_height_m: 12, bottom_depth_m: "
           "30}\nvehicles:\n"
           "  - {name: rov, model: bluerov2_heavy, start: {north_m: -7, east_m: 0, depth_m: 8}, "
           "tasks: [{do: hold}]}\n";
  }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_ / name; }
  [[nodiscard]] ProgramResult live(std::vector<std::string> more) const {
    std::vector<std::string> all{"live", path("run.yaml"), "--store", path("store")};
    all.insert(all.end(), more.begin(), more.end());
    return run_program(all);
  }
  TemporaryFolder folder_;
};

/// Behind its header: the last so many bytes of a message, as numbers.
std::vector<float> last_numbers(const LiveMessage& message, std::size_t count) {
  std::vector<float> numbers(count);
  std::memcpy(numbers.data(), &message.payload[message.payload.size() - 4 * count], 4 * count);
  return numbers;
}

/// The same moment by `live` and by `render` from its log: the same bits.
TEST_F(LiveSee, IsInTheRecordingWhatRenderSeesInTheLog) {
  const ProgramResult run =
      live({"--real-time-factor", "0", "--see", "rov/rov_camera@2", "--by", "corrosion_by_colour",
            "--record", path("run.mcap"), "--out", path("run.nc"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json told = json::parse(run.out).at("sensors").at(0);
  EXPECT_EQ(told.at("vehicle"), "rov");
  EXPECT_EQ(told.at("sensor"), "rov_camera");
  EXPECT_EQ(told.at("rate_hz"), 2);
  EXPECT_EQ(told.at("moments"), 121);
  EXPECT_EQ(told.at("seen").get<int>() + told.at("dropped").get<int>(), 121);
  EXPECT_EQ(told.at("unseen"), 0);
  EXPECT_GT(told.at("mean_ms"), 0);
  std::map<std::string, std::vector<LiveMessage>> by_topic;
  for (const LiveMessage& message : messages_of(path("run.mcap")))
    by_topic[message.topic].push_back(message);
  for (const char* topic : {"image/compressed", "camera_info", "depth", "pose", "detections"})
    EXPECT_EQ(by_topic["/rov/rov_camera/" + std::string(topic)].size(), told.at("seen")) << topic;
  ASSERT_EQ(run_program({"render", path("run.nc"), "--sensor", "rov_camera", "--at", "60s", "--out",
                         path("seen"), "--bag", path("again.mcap"), "--by", "corrosion_by_colour",
                         "--into-log", "--store", path("store")})
                .exit_code,
            0);
  // With what was found in it, the log replays as it did.
  const ProgramResult replayed = run_program({"replay", path("run.nc"), "--store", path("store")});
  EXPECT_EQ(replayed.exit_code, 0) << replayed.err;
  // Its bag has the same messages, to the byte.
  std::size_t in_bag = 0;
  for (const LiveMessage& message : messages_of(path("again.mcap"))) {
    EXPECT_EQ(message.payload, by_topic.at(message.topic).back().payload) << message.topic;
    ++in_bag;
  }
  EXPECT_EQ(in_bag, 5U);
  const ProgramResult twice =
      run_program({"render", path("run.nc"), "--sensor", "rov_camera", "--at", "60s", "--out",
                   path("seen"), "--bag", path("again.mcap"), "--store", path("store")});
  EXPECT_EQ(twice.exit_code, 3) << twice.err;
  EXPECT_EQ(messages_of(path("again.mcap")).size(), 5U) << "what lies there stays";
  const ProgramResult beyond =
      run_program({"render", path("run.nc"), "--sensor", "rov_camera", "--at", "90s", "--out",
                   path("seen"), "--bag", path("none.mcap"), "--store", path("store")});
  EXPECT_EQ(beyond.exit_code, 3) << beyond.err;
  EXPECT_FALSE(std::filesystem::exists(path("none.mcap"))) << "a whole bag or none";
  const auto file = ingest::netcdf::File::open(path("seen/rov_camera_000060.000.nc"));
  const std::vector<double> expected = file.read_all(*file.find("depth"));
  ASSERT_EQ(expected.size(), 640U * 360);
  const auto depth = last_numbers(by_topic["/rov/rov_camera/depth"].back(), expected.size());
  std::size_t other = 0, met = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    met += std::isnan(depth[i]) ? 0 : 1;
    other += depth[i] == expected[i] || (std::isnan(depth[i]) && std::isnan(expected[i])) ? 0 : 1;
  }
  EXPECT_EQ(other, 0U);
  EXPECT_GT(met, 10'000U);
}

TEST_F(LiveSee, IsToldInWordsAtTheEnd) {
  const ProgramResult run = live(
      {"--real-time-factor", "0", "--see", "rov/imaging_sonar@1", "--record", path("run.mcap")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "rov/imaging_sonar at 1 Hz: 61 moments, "));
}

TEST_F(LiveSee, WhatCannotBeIsOneLineAndNothingIsLeft) {
  const auto said = [&](const std::vector<std::string>& more, int exit_code) {
    const ProgramResult run = live(more);
    EXPECT_EQ(run.exit_code, exit_code) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_FALSE(std::filesystem::exists(path("run.mcap")));
    return run.err;
  };
  const std::string bag = path("run.mcap");
  EXPECT_TRUE(contains(said({"--see", "rov/rov_camera@2"}, 2), "nobody would see it"));
  EXPECT_TRUE(contains(said({"--record", bag, "--see", "rov/rov_camera"}, 2),
                       "expected VEHICLE/SENSOR@RATE"));
  EXPECT_TRUE(contains(said({"--record", bag, "--by", "rust_and_cracks"}, 2), "--see"));
  EXPECT_TRUE(
      contains(said({"--record", bag, "--see", "rov/multibeam@1", "--by", "rust_and_cracks"}, 2),
               "found no camera among the sensors"));
  EXPECT_TRUE(contains(said({"--record", bag, "--see", "rov/rov_camera@2", "--by", "nobody"}, 4),
                       "nobody"));
  EXPECT_TRUE(contains(said({"--record", bag, "--see", "usv/rov_camera@2"}, 4),
                       "found no vehicle usv; the run has rov"));
  EXPECT_TRUE(contains(said({"--record", bag, "--see", "rov/camera@2"}, 3), "rov_camera"));
  EXPECT_TRUE(
      contains(said({"--record", bag, "--see", "rov/uav_lidar@2"}, 3), "found it under water"));
  EXPECT_TRUE(
      contains(said({"--record", bag, "--see", "rov/rov_camera@30"}, 3), "expected at most 20 Hz"));
}

}  // namespace
}  // namespace slackwater::tests::cli_live_see_test
