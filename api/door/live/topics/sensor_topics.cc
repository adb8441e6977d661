#include "api/door/live/topics/sensor_topics.h"

#include "api/door/dds/message/detection_messages.h"
#include "api/door/dds/message/sonar_messages.h"
#include "api/perception/jpeg.h"
#include "twin/render/light/heat_tones.h"

namespace slackwater::live {
namespace {

/// Of what shows pictures.
struct CameraFrame {
  const twin::TruthFrame& truth;
  const std::array<double, 9>& matrix;
};
CameraFrame camera_frame(const api::RenderView& view) {
  if (const auto* camera = std::get_if<api::CameraView>(&view.seen))
    return {camera->truth, camera->matrix};
  const auto& infrared = std::get<api::InfraredView>(view.seen);
  return {infrared.truth, infrared.matrix};
}

std::vector<std::uint8_t> jpeg_of_heat(const twin::InfraredFrame& heat) {
  twin::Picture grey{heat.wide, heat.high, {}};
  for (const std::uint8_t tone : twin::heat_tones(heat)) grey.rgb.insert(grey.rgb.end(), 3, tone);
  return api::jpeg_of(grey);
}

template <dds::SensorAxes axes>
dds::Bytes pose_message_of(const SeenView& seen, const dds::SensorStamp& of) {
  return dds::sensor_pose(seen.view.pose, axes, of.stamp);
}
dds::Bytes image_message_of(const SeenView& seen, const dds::SensorStamp& of) {
  return dds::compressed_image(seen.jpeg, of);
}
dds::Bytes info_message_of(const SeenView& seen, const dds::SensorStamp& of) {
  const CameraFrame frame = camera_frame(seen.view);
  return dds::camera_info(frame.truth.wide, frame.truth.high, frame.matrix, of);
}
dds::Bytes depth_message_of(const SeenView& seen, const dds::SensorStamp& of) {
  return dds::depth_image(camera_frame(seen.view).truth, of);
}
const api::RightView& right_of(const SeenView& seen) {
  return *std::get<api::CameraView>(seen.view.seen).right;
}
dds::Bytes right_image_message_of(const SeenView& seen, const dds::SensorStamp& of) {
  return dds::compressed_image(api::jpeg_of(right_of(seen).picture), of);
}
dds::Bytes right_info_message_of(const SeenView& seen, const dds::SensorStamp& of) {
  const api::RightView& right = right_of(seen);
  return dds::camera_info(right.picture.wide, right.picture.high, camera_frame(seen.view).matrix,
                          of, right.baseline_m);
}
dds::Bytes heat_message_of(const SeenView& seen, const dds::SensorStamp& of) {
  return dds::heat_image(std::get<api::InfraredView>(seen.view.seen).heat, of);
}
dds::Bytes points_message_of(const SeenView& seen, const dds::SensorStamp& of) {
  return dds::point_cloud(std::get<twin::LidarScan>(seen.view.seen),
                          std::get<twin::LidarSheet>(seen.sensor.device), of);
}
dds::Bytes sonar_message_of(const SeenView& seen, const dds::SensorStamp& of) {
  return dds::sonar_image(std::get<twin::SonarImage>(seen.view.seen),
                          std::get<twin::ImagingSonarSheet>(seen.sensor.device),
                          seen.sensor.most_range_m, of);
}
dds::Bytes side_scan_message_of(const SeenView& seen, const dds::SensorStamp& of) {
  return dds::side_scan_image(std::get<twin::SideScanPing>(seen.view.seen),
                              std::get<twin::SideScanSheet>(seen.sensor.device), of);
}
dds::Bytes ranges_message_of(const SeenView& seen, const dds::SensorStamp& of) {
  return dds::sonar_ranges(std::get<api::MultibeamView>(seen.view.seen).soundings,
                           std::get<twin::MultibeamSheet>(seen.sensor.device), of);
}
dds::Bytes range_message_of(const SeenView& seen, const dds::SensorStamp& of) {
  return dds::range_message(std::get<twin::EchoSounding>(seen.view.seen),
                            std::get<twin::EchoSounderSheet>(seen.sensor.device),
                            {seen.sensor.least_range_m, seen.sensor.most_range_m}, of);
}
dds::Bytes currents_message_of(const SeenView& seen, const dds::SensorStamp& of) {
  return dds::current_cloud(std::get<twin::CurrentProfile>(seen.view.seen), of);
}

using SensorTopics = std::vector<SensorTopic>;

template <dds::SensorAxes axes>
constexpr SensorTopic pose_topic{"pose", "geometry_msgs/msg/PoseStamped", pose_message_of<axes>};
constexpr SensorTopic camera_pose = pose_topic<dds::SensorAxes::camera>;
constexpr SensorTopic scanner_pose = pose_topic<dds::SensorAxes::scanner>;
constexpr SensorTopic fan_pose = pose_topic<dds::SensorAxes::fan>;
constexpr SensorTopic image_topic{"image/compressed", "sensor_msgs/msg/CompressedImage",
                                  image_message_of};
constexpr SensorTopic info_topic{"camera_info", "sensor_msgs/msg/CameraInfo", info_message_of};
constexpr SensorTopic depth_topic{"depth", "sensor_msgs/msg/Image", depth_message_of};

struct TopicsOf {
  SensorTopics operator()(const twin::CameraSheet& sheet) const {
    SensorTopics topics{image_topic, info_topic, depth_topic, camera_pose};
    if (sheet.baseline_m > 0) {
      topics.push_back(
          {"right/image/compressed", "sensor_msgs/msg/CompressedImage", right_image_message_of});
      topics.push_back({"right/camera_info", "sensor_msgs/msg/CameraInfo", right_info_message_of});
    }
    return topics;
  }
  SensorTopics operator()(const twin::InfraredSheet&) const {
    return {image_topic,
            info_topic,
            depth_topic,
            {"temperature", "sensor_msgs/msg/Image", heat_message_of},
            camera_pose};
  }
  SensorTopics operator()(const twin::LidarSheet&) const {
    return {{"points", "sensor_msgs/msg/PointCloud2", points_message_of}, scanner_pose};
  }
  SensorTopics operator()(const twin::ImagingSonarSheet&) const {
    return {{"sonar", "marine_acoustic_msgs/msg/ProjectedSonarImage", sonar_message_of}, fan_pose};
  }
  SensorTopics operator()(const twin::SideScanSheet&) const {
    return {{"sonar", "marine_acoustic_msgs/msg/ProjectedSonarImage", side_scan_message_of},
            fan_pose};
  }
  SensorTopics operator()(const twin::MultibeamSheet&) const {
    return {{"ranges", "marine_acoustic_msgs/msg/SonarRanges", ranges_message_of}, fan_pose};
  }
  SensorTopics operator()(const twin::EchoSounderSheet&) const {
    return {{"range", "sensor_msgs/msg/Range", range_message_of}, scanner_pose};
  }
  SensorTopics operator()(const twin::Adcp&) const {
    return {{"currents", "sensor_msgs/msg/PointCloud2", currents_message_of}, scanner_pose};
  }
};

}  // namespace

bool shows_pictures(const twin::RenderSensor& sensor) noexcept {
  return sensor.is_camera() || std::holds_alternative<twin::InfraredSheet>(sensor.device);
}

std::pair<int, int> size_of_picture(const api::RenderView& view) {
  const CameraFrame frame = camera_frame(view);
  return {frame.truth.wide, frame.truth.high};
}

std::vector<std::uint8_t> jpeg_of_view(const api::RenderView& view) {
  if (const auto* camera = std::get_if<api::CameraView>(&view.seen))
    return api::jpeg_of(camera->picture);
  return jpeg_of_heat(std::get<api::InfraredView>(view.seen).heat);
}

dds::Bytes detections_message_of(std::span<const api::Detection> found,
                                 const dds::SensorStamp& of) {
  std::vector<dds::FoundBox> boxes;
  for (const api::Detection& one : found)
    boxes.push_back(
        {one.of, one.confidence, one.box.left, one.box.top, one.box.right, one.box.bottom});
  return dds::detections_message(boxes, of);
}

std::vector<SensorTopic> topics_of(const twin::RenderSensor& sensor) {
  return std::visit(TopicsOf{}, sensor.device);
}

}  // namespace slackwater::live
