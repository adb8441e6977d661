#include "api/door/live/topics/view_bag.h"

#include "api/door/dds/message/names.h"
#include "fields/base/error.h"

namespace slackwater::live {

ViewBag::ViewBag(const std::filesystem::path& path, UtcTime epoch, const std::string& vehicle,
                 const std::string& sensor, const twin::RenderSensor& sheet, bool is_looked_at)
    : path_(path),
      epoch_(epoch),
      sheet_(sheet),
      frame_id_(dds::ros_token(vehicle) + "/" + dds::ros_token(sensor)),
      topics_(topics_of(sheet)),
      outlet_(std::make_shared<RecordingOutlet>(path, nullptr)) {
  stream_.add(outlet_);
  for (const SensorTopic& topic : topics_)
    channels_.push_back(
        stream_.open("/" + frame_id_ + "/" + topic.name, topic.type, sensor_quality));
  if (is_looked_at)
    finds_ =
        stream_.open("/" + frame_id_ + "/" + detections_topic, detections_type, sensor_quality);
  stream_.opened();
}

ViewBag::~ViewBag() {
  if (is_closed_) return;
  (void)outlet_->close();
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void ViewBag::add(const api::RenderView& view, std::span<const api::Detection> found) {
  const std::vector<std::uint8_t> jpeg =
      shows_pictures(sheet_) ? jpeg_of_view(view) : std::vector<std::uint8_t>();
  const dds::Stamp stamp = dds::stamp_of(epoch_, view.t_s);
  for (std::size_t i = 0; i < topics_.size(); ++i)
    stream_.publish(channels_[i], stamp,
                    topics_[i].message({sheet_, view, jpeg}, {stamp, frame_id_}));
  if (finds_) stream_.publish(*finds_, stamp, detections_message_of(found, {stamp, frame_id_}));
}

std::uint64_t ViewBag::close() {
  const std::uint64_t messages = outlet_->close();
  if (outlet_->has_failed())
    throw Error(ErrorKind::unavailable,
                path_.string() +
                    ": the disk is full, or does not keep up; no bag is left. Free some "
                    "space, or take a longer step");
  is_closed_ = true;
  return messages;
}

}  // namespace slackwater::live
