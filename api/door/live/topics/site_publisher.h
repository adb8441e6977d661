#pragma once
#include <span>
#include <string>
#include <vector>

#include "api/door/dds/message/site_messages.h"
#include "api/door/live/topics/stream.h"
#include "api/door/live/topics/vehicle_publisher.h"
#include "api/door/live/topics/water_publisher.h"
#include "twin/environment/environment.h"
#include "twin/run/run.h"
#include "twin/traffic/traffic_picture.h"

namespace slackwater::live {

/// Tells of the clock, the water at the origin and the traffic after each barrier.
class SitePublisher {
 public:
  /// @param site  a token of ROS
  SitePublisher(Stream& stream, const RunPlace& place, const std::string& site,
                const twin::Environment& environment, std::span<const twin::TrafficVessel> vessels);
  void speak(std::span<const twin::Seen> vehicles, double t_s);

 private:
  using ChannelId = Stream::ChannelId;
  void speak_of_turbines(const dds::Stamp& stamp);
  void speak_of_traffic(std::span<const twin::Seen> vehicles, double t_s, const dds::Stamp& stamp);

  Stream& stream_;
  RunPlace place_;
  const twin::Environment& environment_;
  twin::EnvironmentSampler sampler_;
  std::vector<twin::TrafficVessel> vessels_;
  twin::TrafficPicture picture_;
  WaterPublisher water_;
  ChannelId clock_, power_, ais_;
  double power_s_ = -1, traffic_s_ = -1;  ///< when each was told last
};

}  // namespace slackwater::live
