#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "api/ask/render/render_view.h"
#include "api/door/dds/message/sensor_messages.h"
#include "api/perception/detection.h"
#include "twin/render/sheet/render_sensor.h"

// What a sensor saw, as messages of ROS 2 (api/docs/dds.md): of a run that goes on, and of one that
// is over.

namespace slackwater::live {

struct SeenView {
  const twin::RenderSensor& sensor;
  const api::RenderView& view;
  const std::vector<std::uint8_t>& jpeg;  ///< of it, where it is a picture
};

struct SensorTopic {
  using ToMessage = dds::Bytes (*)(const SeenView& seen, const dds::SensorStamp& of);
  const char* name;  ///< below NAME/SENSOR: "image/compressed"
  const char* type;  ///< "sensor_msgs/msg/CompressedImage"
  ToMessage message;
};
/// By device; of what shows pictures the picture comes first.
[[nodiscard]] std::vector<SensorTopic> topics_of(const twin::RenderSensor& sensor);

/// What a detector found in a picture of a camera: a topic beside those, for who asks for it.
inline constexpr const char* detections_topic = "detections";
inline constexpr const char* detections_type = "vision_msgs/msg/Detection2DArray";
[[nodiscard]] dds::Bytes detections_message_of(std::span<const api::Detection> found,
                                               const dds::SensorStamp& of);

/// Cameras, of light or of heat: for people, too.
[[nodiscard]] bool shows_pictures(const twin::RenderSensor& sensor) noexcept;
/// Of what shows pictures: width and height, pixels.
[[nodiscard]] std::pair<int, int> size_of_picture(const api::RenderView& view);
[[nodiscard]] std::vector<std::uint8_t> jpeg_of_view(const api::RenderView& view);

}  // namespace slackwater::live
