#pragma once
#include <string>
#include <vector>

#include "api/show/report/report.h"
#include "api/show/report/time_text.h"
#include "fields/service/field.h"

namespace slackwater::api {

/// The speed at the depths that a page offers, every ten minutes, at the forecast's first column.
/// @param depth_m  shown first, in the water
[[nodiscard]] ReportSpeed speed_of(const Field& field, double depth_m, double slack_below_m_s,
                                   const PageClock& clock);

/// When the likely speed at a place and a depth is below a threshold, over the whole forecast.
struct SlackAt {
  std::vector<SlackWindow> windows;
  std::string no_tide;  ///< why nothing is known of it; else empty
};
/// @param place  in the water of the field, at least so deep
[[nodiscard]] SlackAt slack_at(const Field& field, const GeoPoint& place, double depth_m,
                               double below_m_s);

/// A time at which the stream is strongest: its likely speed is the largest of the three hours on
/// either side, and it falls by a tenth of it then. None where the tide is averaged away.
struct StrongestStream {
  std::size_t index = 0;  ///< of ReportSpeed::time
};
[[nodiscard]] std::vector<StrongestStream> strongest_streams(const ReportSpeed& speed,
                                                             const ReportSpeedAtDepth& at);

/// "0.82 m/s (0.64 to 1.01)".
[[nodiscard]] std::string speed_text(const ReportSpeedAtDepth& at, std::size_t index);

}  // namespace slackwater::api
