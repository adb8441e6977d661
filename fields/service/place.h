#pragma once
#include <string>

#include "fields/base/frame.h"
#include "fields/base/time.h"
#include "fields/geo/geo_point.h"
#include "fields/grid/status.h"
#include "fields/service/snapshot.h"

namespace slackwater {

/// Where and when a field is asked. Plain numbers: a million of them are asked at once.
struct Place {
  double longitude_deg = 0;  ///< any turn
  double latitude_deg = 0;
  double vertical_m = 0;  ///< depth below mean sea level for currents, height above it for wind
  UtcTime time{};
};

/// The mean wind at a height.
struct WindSample {
  Horizontal velocity_m_s{};  ///< towards
  SampleStatus status = SampleStatus::missing;
};

struct SeaSample {
  SeaState sea;
  SampleStatus status = SampleStatus::missing;
};

struct BedSample {
  double water_depth_m = 0;
  SampleStatus status = SampleStatus::missing;
};

/// Outside of it every answer is a status.
struct ValidRange {
  BoundingBox box;  ///< around all columns and the water they speak for
  UtcTime from{};
  UtcTime to{};
  double deepest_m = 0;  ///< the deepest bed

  /// "valid: 2.61 W..2.49 W …": what an error tells.
  [[nodiscard]] std::string text() const;
};

/// Heights above the sea for which the wind profile is made, m: from the height at which it is
/// given, where waves no longer shape it, up to a blade tip.
inline constexpr double lowest_wind_m = 1.0;
inline constexpr double highest_wind_m = 300.0;

}  // namespace slackwater
