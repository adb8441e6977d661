#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "api/door/live/topics/stream.h"
#include "api/door/live/topics/vehicle_publisher.h"
#include "twin/run/traffic_watch.h"

namespace slackwater::live {

/// Tells of the vessels that vehicles are alarmed about, by the limits of the scenario (CPA, TCPA):
/// `/NAME/cpa_alarms`, std_msgs/msg/String with a JSON list of {"mmsi", "name", "cpa_m", "tcpa_s",
/// "is_lost"}, latched, whenever one is raised or over. "[]": none.
class AlarmPublisher {
 public:
  /// @param watch, vessels  outlive it
  AlarmPublisher(Stream& stream, const RunPlace& place, const twin::TrafficWatch& watch,
                 std::span<const twin::TrafficVessel> vessels);
  /// The next vehicle of the run. @param name  a token of ROS
  void open(const std::string& name);
  void speak(double t_s);

 private:
  /// The vessels of a list, by their MMSI, and which of them are lost.
  using Told = std::vector<std::pair<std::uint32_t, bool>>;
  struct Vehicle {
    Stream::ChannelId channel;
    std::optional<Told> told;
  };
  [[nodiscard]] std::string json_of(std::span<const twin::Alarm> alarms) const;

  Stream& stream_;
  RunPlace place_;
  const twin::TrafficWatch& watch_;
  std::span<const twin::TrafficVessel> vessels_;
  std::vector<Vehicle> vehicles_;
};

}  // namespace slackwater::live
