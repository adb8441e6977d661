// `slackwater live --see` on DDS, heard by a participant as others would write it: with
// fastddsgen's own types, beside the run, over UDP and through shared memory.
#include <csignal>
#include <cstring>
#include <fstream>

#include "marine_acoustic_msgsPubSubTypes.h"
#include "sensor_msgsPubSubTypes.h"
#include "tests/api/door/dds/generated_client.h"
#include "tests/api/door/dds/own_domain.h"
#include "tests/api/door/dds/without_leaks.h"
#include "tests/support/started_program.h"
#include "tests/support/temporary_folder.h"
#include "vision_msgsPubSubTypes.h"

namespace slackwater::tests::seen_by_others_test {
namespace {

using namespace std::chrono_literals;

const std::string pile = R"(name: seen by others
seed: 11
duration: 10min
step_s: 0.05
water: {made_up: {depth_m: 30}}
structures:
  - {name: pile, kind: cylinder, north_m: 0, east_m: 0, diameter_m: 6, top_height_m: 12,
     bottom_depth_m: 30}
vehicles:
  - {name: rov, model: bluerov2_heavy, tasks: [{do: hold}],
     start: {north_m: -7, east_m: 0.5, depth_m: 8, heading_deg: 0}}
  - {name: uav, model: x500, tasks: [{do: hold}],
     start: {north_m: -20, east_m: 0, height_m: 10, heading_deg: 0}}
)";

/// All samples of a topic.
template <typename Message, typename PubSubType>
class Heard final : public fdds::DataReaderListener {
 public:
  Heard(GeneratedParticipant& participant, const std::string& topic) {
    (void)participant.reader("rt" + topic, fdds::TypeSupport(new PubSubType), this);
  }
  void on_data_available(fdds::DataReader* reader) override {
    Message message;
    fdds::SampleInfo info;
    while (reader->take_next_sample(&message, &info) ==
           eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK)
      if (info.valid_data) inbox_.put(message);
  }
  [[nodiscard]] std::vector<Message> wait(std::size_t count) { return inbox_.wait(count, 120s); }

 private:
  Inbox<Message> inbox_;
};

class SeenByOthers : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Over, SeenByOthers, testing::Bool(),
                         [](const auto& is_udp) { return is_udp.param ? "Udp" : "SharedMemory"; });

TEST_P(SeenByOthers, PicturesDepthsCloudsAndPings) {
  using namespace sensor_msgs::msg;
  const OwnDomain domain;
  const TemporaryFolder folder;
  std::ofstream(folder / "run.yaml") << pile;
  GeneratedParticipant other(domain.number(), GetParam());
  Heard<CompressedImage, CompressedImagePubSubType> images(other,
                                                           "/rov/rov_camera/image/compressed");
  Heard<CameraInfo, CameraInfoPubSubType> infos(other, "/rov/rov_camera/camera_info");
  Heard<Image, ImagePubSubType> depths(other, "/rov/rov_camera/depth");
  Heard<PointCloud2, PointCloud2PubSubType> clouds(other, "/uav/uav_lidar/points");
  Heard<marine_acoustic_msgs::msg::ProjectedSonarImage,
        marine_acoustic_msgs::msg::ProjectedSonarImagePubSubType>
      pings(other, "/rov/imaging_sonar/sonar");
  Heard<marine_acoustic_msgs::msg::SonarRanges, marine_acoustic_msgs::msg::SonarRangesPubSubType>
      fans(other, "/rov/multibeam/ranges");
  Heard<sensor_msgs::msg::Range, RangePubSubType> sounders(other, "/rov/echo_sounder/range");
  Heard<vision_msgs::msg::Detection2DArray, vision_msgs::msg::Detection2DArrayPubSubType> finds(
      other, "/rov/rov_camera/detections");
  std::vector<std::string> arguments{
      "live",  folder / "run.yaml",   "--dds-domain", std::to_string(domain.number()),
      "--see", "rov/rov_camera@1",    "--see",        "uav/uav_lidar@1",
      "--see", "rov/imaging_sonar@1", "--see",        "rov/multibeam@1",
      "--see", "rov/echo_sounder@1",  "--by",         "rust_and_cracks"};
  if (GetParam()) arguments.insert(arguments.end(), {"--loopback", "--udp-only"});
  StartedProgram run(start_program(arguments, without_leaks(), folder / "out", folder / "err"));
  const auto image = images.wait(2);
  const auto info = infos.wait(1);
  EXPECT_EQ(finds.wait(1).front().header().frame_id(), "rov/rov_camera");
  const auto depth = depths.wait(2);
  const auto cloud = clouds.wait(2);
  const auto ping = pings.wait(2);
  const auto fan = fans.wait(1);
  const auto sounder = sounders.wait(1);
  EXPECT_EQ(run.end(SIGINT), 0);
  ASSERT_GE(image.size(), 2U);
  ASSERT_GE(info.size(), 1U);
  ASSERT_GE(depth.size(), 2U);
  ASSERT_GE(cloud.size(), 2U);
  ASSERT_GE(ping.size(), 2U);
  ASSERT_GE(fan.size(), 1U);
  ASSERT_GE(sounder.size(), 1U);

  EXPECT_EQ(image[0].header().frame_id(), "rov/rov_camera");
  EXPECT_EQ(image[0].format(), "jpeg");
  ASSERT_GT(image[0].data().size(), 1000U);
  EXPECT_EQ(image[0].data()[0], 0xFF);
  EXPECT_EQ(image[0].data()[1], 0xD8) << "a JPEG begins so";
  EXPECT_EQ(image[0].data().back(), 0xD9) << "and ends so";

  // 64 degrees over 640 square pixels: 320 / tan(32 degrees).
  EXPECT_EQ(info[0].width(), 640U);
  EXPECT_EQ(info[0].height(), 360U);
  EXPECT_NEAR(info[0].k()[0], 512.107, 5e-4);
  EXPECT_EQ(info[0].k()[2], 319.5);
  EXPECT_NEAR(info[0].k()[4], 512.107, 5e-4);
  EXPECT_EQ(info[0].k()[5], 179.5);

  // The pile's nearest place lies 4 m before the vehicle, whose camera is turned to it.
  EXPECT_EQ(depth[0].encoding(), "32FC1");
  EXPECT_EQ(depth[0].step(), 640U * 4);
  ASSERT_EQ(depth[0].data().size(), 640U * 360 * 4);
  float middle_m = 0;
  std::memcpy(&middle_m, &depth[0].data()[4 * (180 * 640 + 320)], 4);
  EXPECT_GT(middle_m, 3);
  EXPECT_LT(middle_m, 5);

  EXPECT_EQ(cloud[0].header().frame_id(), "uav/uav_lidar");
  EXPECT_EQ(cloud[0].height(), 64U);
  EXPECT_EQ(cloud[0].width(), 2048U);
  ASSERT_EQ(cloud[0].fields().size(), 4U);
  EXPECT_EQ(cloud[0].fields()[3].name(), "intensity");
  EXPECT_EQ(cloud[0].data().size(), 64U * 2048 * 16);

  EXPECT_EQ(ping[0].beam_directions().size(), 512U);
  EXPECT_EQ(ping[0].ranges().size(), 512U);
  EXPECT_EQ(ping[0].image().data().size(), 512U * 512 * 4);
  // A level bed 22 m below the vehicle, straight down: the middle of the fan.
  ASSERT_EQ(fan[0].ranges().size(), 512U);
  EXPECT_EQ(fan[0].flags()[256].flag(), 0);
  EXPECT_NEAR(fan[0].ranges()[256] * fan[0].beam_unit_vec()[256].z(), 22, 1);
  EXPECT_NEAR(sounder[0].range(), 22, 1.5);
  EXPECT_EQ(sounder[0].max_range(), 100);
  // Another moment, a second on.
  EXPECT_GE(image[1].header().stamp().sec(), image[0].header().stamp().sec() + 1);
}

}  // namespace
}  // namespace slackwater::tests::seen_by_others_test
