#include "api/door/dds/message/detection_messages.h"

#include "api/door/dds/message/cdr.h"
#include "api/door/dds/message/parts.h"
#include "vision_msgs.h"

namespace slackwater::dds {
namespace {

constexpr double to_middle_of_pixel = -0.5;

vision_msgs::msg::Detection2D detection(const FoundBox& found, const SensorStamp& of) {
  vision_msgs::msg::ObjectHypothesisWithPose hypothesis;
  hypothesis.hypothesis().class_id(found.of);
  hypothesis.hypothesis().score(found.score);
  hypothesis.pose().pose().orientation().w(1);
  vision_msgs::msg::Detection2D made;
  made.header(header_message(of.stamp, of.frame_id));
  made.results().push_back(hypothesis);
  made.bbox().center().position().x(0.5 * (found.left + found.right) + to_middle_of_pixel);
  made.bbox().center().position().y(0.5 * (found.top + found.bottom) + to_middle_of_pixel);
  made.bbox().size_x(found.right - found.left);
  made.bbox().size_y(found.bottom - found.top);
  return made;
}

}  // namespace

Bytes detections_message(std::span<const FoundBox> found, const SensorStamp& of) {
  vision_msgs::msg::Detection2DArray message;
  message.header(header_message(of.stamp, of.frame_id));
  for (const FoundBox& one : found) message.detections().push_back(detection(one, of));
  return encoded(message);
}

}  // namespace slackwater::dds
