#include "api/door/live/topics/water_publisher.h"

namespace slackwater::live {

bool is_due(double t_s, double every_s, double& last_s) noexcept {
  constexpr double soon_s = 1e-6;  // what rounding leaves of a number of steps
  if (last_s >= 0 && t_s < last_s + every_s - soon_s) return false;
  last_s = t_s;
  return true;
}

WaterPublisher::WaterPublisher(Stream& stream, const std::string& site) : stream_(stream) {
  const auto open = [&](const char* what, const char* type) {
    return stream.open("/" + site + "/" + what, type, latched_quality);
  };
  profile_ = open("current_profile", "slackwater_msgs/msg/CurrentProfile");
  wind_ = open("wind", "geometry_msgs/msg/Vector3Stamped");
  wave_ = open("wave", "slackwater_msgs/msg/SeaState");
  tide_ = open("tide_level", "std_msgs/msg/Float64");
}

void WaterPublisher::speak(const dds::SiteWater& water, const SeaSample& sea, const dds::Stamp& now,
                           double t_s) {
  constexpr double profile_every_s = 600, water_every_s = 60;
  const UtcTime time = dds::time_of(now);
  if (is_due(t_s, profile_every_s, profile_s_))
    stream_.publish(profile_, now, dds::current_profile(water, time, now));
  if (!is_due(t_s, water_every_s, minute_s_)) return;
  stream_.publish(wind_, now, dds::wind(water, time, now));
  stream_.publish(wave_, now, dds::wave(sea, now));
  stream_.publish(tide_, now, dds::tide_level(water, time));
}

}  // namespace slackwater::live
