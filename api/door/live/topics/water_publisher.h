#pragma once
#include <string>

#include "api/door/dds/message/site_messages.h"
#include "api/door/live/topics/stream.h"

namespace slackwater::live {

/// Tells of the water at a site: `/SITE/current_profile` with each forecast and every 10 min,
/// `/SITE/wind`, `wave` and `tide_level` each minute.
class WaterPublisher {
 public:
  /// @param site  a token of ROS
  WaterPublisher(Stream& stream, const std::string& site);

  /// @param t_s  on the clock that the intervals are counted by
  void speak(const dds::SiteWater& water, const SeaSample& sea, const dds::Stamp& now, double t_s);
  /// There is another forecast: all is told again.
  void renew() noexcept { profile_s_ = minute_s_ = -1; }

 private:
  Stream& stream_;
  Stream::ChannelId profile_, wind_, wave_, tide_;
  double profile_s_ = -1, minute_s_ = -1;  ///< when each was told last
};

/// Whether it is time again; notes that it was. @param last_s  below 0: never yet
[[nodiscard]] bool is_due(double t_s, double every_s, double& last_s) noexcept;

}  // namespace slackwater::live
