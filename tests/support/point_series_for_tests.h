#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/frame.h"
#include "fields/base/time.h"

namespace slackwater::tests {

/// Where a CF point-series file says how deep its sensors hang.
enum class SeriesLevelsForTests {
  depth_axis,        ///< (time, depth), positive down
  depth_axis_first,  ///< (depth, time)
  station_axis,      ///< (station, time, depth), one station
  upwards,           ///< (time, z), z negative, positive up
  above_bed,         ///< (time, z), heights above the sea bed, water_depth stated
  own_variables,     ///< u_5m(time), u_10m(time), each with its scalar depth
  own_stations,      ///< (station, time), depth(station)
};

/// A vector measured at a place, written as a CF point series.
struct PointSeriesForTests {
  std::string station = "M1";
  std::map<std::string, std::string> global;  ///< further global attributes
  double latitude_deg = 54.0;
  double longitude_deg = 6.5;
  std::vector<UtcTime> time;
  std::vector<double> depth_m;  ///< empty: no levels (wind at 10 m)
  std::optional<double> water_depth_m = 30;
  SeriesLevelsForTests levels = SeriesLevelsForTests::depth_axis;
  bool as_speed_and_direction = false;
  bool bare = false;  ///< variables are called what they are, no standard names
  /// Written beside every component, or the speed, as CF ancillary variables.
  std::optional<double> standard_error_m_s;
  /// The OceanSITES flag of each value (1 good, 4 bad, 0 nobody checked); empty: no flags.
  std::function<int(UtcTime, double)> flag;
  /// (east, north) at a time and depth; NaN: missing.
  std::function<Horizontal(UtcTime, double)> value;
};

/// Currents where it has depths, else wind at 10 m. Returns the path.
std::filesystem::path write_point_series(const std::filesystem::path& file,
                                         const PointSeriesForTests& series);

/// Instants from midnight of the day, every `minutes`.
[[nodiscard]] std::vector<UtcTime> stepping_times(UtcDay day, int days, int minutes);

}  // namespace slackwater::tests
