#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fields/geo/geo_point.h"

namespace slackwater {

/// What a turbine stands on.
enum class FoundationKind { monopile, jacket, floating };

struct Foundation {
  FoundationKind kind = FoundationKind::monopile;
  double diameter_m = 0;    ///< of a monopile or a floater; of a jacket the width between its legs
  double top_height_m = 0;  ///< of the transition piece, above mean sea level
  double draught_m = 0;     ///< of a floater
  bool operator==(const Foundation&) const = default;
};

/// A line that holds a floating foundation, straight in plan.
struct Mooring {
  std::string id;
  double bearing_deg = 0;        ///< from the turbine's axis, clockwise from true north
  double anchor_distance_m = 0;  ///< from the axis
  double fairlead_depth_m = 0;   ///< where it is fastened to the floater
  bool operator==(const Mooring&) const = default;
};

/// Where one turbine of the farm stands, and what is known of it.
struct TurbinePlace {
  std::string id;
  GeoPoint point;
  std::optional<double> water_depth_m;  ///< else that of the site
  std::optional<double> hub_height_m;
  std::optional<double> rotor_diameter_m;
  std::optional<double> landing_deg;  ///< bearing of the boat landing from the axis
  std::optional<Foundation> foundation;
  std::vector<Mooring> moorings;
};

/// A cable on or under the bed.
struct CableRoute {
  std::string id;
  std::vector<GeoPoint> route;  ///< from end to end, the turbines it joins among them
  std::optional<double> burial_depth_m;
};

/// monopile, jacket, floating.
[[nodiscard]] const char* name_of(FoundationKind kind) noexcept;

class Config;
/// latitude_deg and longitude_deg of a mapping.
[[nodiscard]] GeoPoint read_point(const Config& config);
/// `foundation` of a site or of a turbine:
///
///     {kind: monopile, diameter_m: 6, top_height_m: 20}
///     {kind: jacket, width_m: 20, top_height_m: 20}
///     {kind: floating, diameter_m: 12, draught_m: 20, top_height_m: 15}
[[nodiscard]] std::optional<Foundation> read_foundation(const Config& config);
/// `turbines` of a site. What stands beside them (`foundation`, `landing_deg`, `rotor_diameter_m`,
/// `hub_height_m`) is of those that say nothing else.
/// @throws Error(invalid_input) for ids that are there twice, moorings of what does not float
[[nodiscard]] std::vector<TurbinePlace> read_turbines(const Config& site);
/// `cables` of a site: `{id, from: TURBINE, to: TURBINE, via: [{latitude_deg, longitude_deg}],
/// burial_depth_m}`. @throws Error(invalid_input) for turbines that are not there
[[nodiscard]] std::vector<CableRoute> read_cables(const Config& site,
                                                  const std::vector<TurbinePlace>& turbines);

}  // namespace slackwater
