#pragma once
#include <span>
#include <string>

#include "api/door/dds/message/sensor_messages.h"

namespace slackwater::dds {

/// What a detector found in a picture: a rectangle in pixels from its upper left corner.
struct FoundBox {
  std::string of;
  double score = 0;  ///< 0 to 1
  double left = 0, top = 0, right = 0, bottom = 0;
};

/// vision_msgs/msg/Detection2DArray: of each find one hypothesis, whose pose says nothing, and its
/// box. Centres as ROS and OpenCV count: (0, 0) is the middle of the first pixel.
[[nodiscard]] Bytes detections_message(std::span<const FoundBox> found, const SensorStamp& of);

}  // namespace slackwater::dds
