#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "api/door/live/topics/recording_outlet.h"
#include "api/door/live/topics/sensor_topics.h"

namespace slackwater::live {

/// What a sensor saw on a run that is over, as a bag: the topics that it has on a run that goes on
/// (`live --see --record`), each message at the time of its moment.
class ViewBag {
 public:
  /// @param path     ends in ".mcap", or a rosbag2 folder
  /// @param epoch    of the run: its start
  /// @param vehicle  its name
  /// @param sheet    outlives it
  /// @param is_looked_at  by a detector: its finds are a topic, too
  /// @throws Error(invalid_input) where something lies at the path, Error(unavailable)
  ViewBag(const std::filesystem::path& path, UtcTime epoch, const std::string& vehicle,
          const std::string& sensor, const twin::RenderSensor& sheet, bool is_looked_at);
  /// Takes the bag away, unless it was closed.
  ~ViewBag();
  ViewBag(const ViewBag&) = delete;
  ViewBag& operator=(const ViewBag&) = delete;

  /// The next moment, in the order of time.
  /// @param found  where a detector looked
  void add(const api::RenderView& view, std::span<const api::Detection> found = {});
  /// @return messages recorded @throws Error(unavailable) where it does not hold all
  std::uint64_t close();

 private:
  std::filesystem::path path_;
  UtcTime epoch_;
  const twin::RenderSensor& sheet_;
  std::string frame_id_;
  std::vector<SensorTopic> topics_;
  std::vector<Stream::ChannelId> channels_;
  std::optional<Stream::ChannelId> finds_;
  Stream stream_;
  std::shared_ptr<RecordingOutlet> outlet_;
  bool is_closed_ = false;
};

}  // namespace slackwater::live
