#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fields/base/time.h"
#include "fields/geo/geo_point.h"
#include "fields/geo/polygon.h"

namespace slackwater {

/// Where one may not be, or where others go.
enum class AreaKind { exclusion, traffic_lane };

/// From one to the other, both included; a first that is greater goes over the end of the year or
/// the day.
struct Span {
  int first = 0;
  int last = 0;
  bool operator==(const Span&) const = default;
};

/// A polygon of the sea with a meaning, in some months and at some hours.
struct ConstraintArea {
  std::string id;
  AreaKind kind = AreaKind::exclusion;
  std::string reason;             ///< "breeding terns"
  std::vector<GeoPoint> corners;  ///< in order, the last joined to the first
  std::optional<Span> months;     ///< 1 to 12; absent: all year
  std::optional<Span> hours_utc;  ///< whole hours, 0 to 23: 4 to 6 ends at 07:00; absent: all day
  std::optional<double> below_height_m;  ///< counts below this height alone; absent: at all
  std::optional<double> direction_deg;   ///< of a lane: where its traffic goes to

  /// Whether it counts at a time.
  [[nodiscard]] bool is_in_force(UtcTime time) const;
};

class Config;
/// `areas` of a site:
///
///     {id, kind: exclusion, reason, polygon: [{latitude_deg, longitude_deg}, ...], months: [4, 7],
///      hours_utc: [4, 21], below_height_m: 150}
///     {id, kind: traffic_lane, polygon: [...], direction_deg: 70}
///
/// @throws Error(invalid_input) for fewer than three corners and sides that cross
[[nodiscard]] std::vector<ConstraintArea> read_areas(const Config& site);

}  // namespace slackwater
