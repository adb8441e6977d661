#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fields/geo/geo_point.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {

/// The coordinates of a point-series file.
struct StationAxes {
  const netcdf::Variable* time = nullptr;
  const netcdf::Variable* latitude = nullptr;
  const netcdf::Variable* longitude = nullptr;
  std::string time_dimension;     ///< empty: one time
  std::string station_dimension;  ///< empty: one station
  std::size_t stations = 1;
};

/// Whether a latitude or longitude stands beside each value, over time and one other dimension, as
/// the Copernicus Marine toolbox writes it (`latitude(time, depth_level)`).
[[nodiscard]] bool is_place_of_each_value(const netcdf::Variable& coordinate,
                                          std::string_view time_dimension);

/// Finds time and position: by standard name, name or units; scalar `x` and `y` without attributes
/// count where the `coordinates` of a variable name them. Nothing where the file has no such
/// coordinates, or where time or position is not that of a point series (fields over latitude and
/// longitude).
[[nodiscard]] std::optional<StationAxes> station_axes_of(const netcdf::File& file);

/// The same, once for each time axis of the file: instruments with clocks of their own write
/// `time_wind` beside `time`. Empty where `station_axes_of` gives nothing.
[[nodiscard]] std::vector<StationAxes> all_station_axes_of(const netcdf::File& file);

/// Where a station stands. A buoy swings: the median of its good positions stands for it, and a
/// warning says how far it strays. Throws Error(invalid_input) where it strays more than 5 km (a
/// ship or a drifter), or has no position.
[[nodiscard]] GeoPoint position_of(const netcdf::File& file, const StationAxes& axes,
                                   std::size_t station, std::vector<std::string>& warnings);

/// What the platform is called: its code, name, site or station attribute, or `timeseries_id`; else
/// the file's name.
[[nodiscard]] std::string station_name_of(const netcdf::File& file, const StationAxes& axes,
                                          std::size_t station);

/// The water depth that the file states, metres: global attributes (site_nominal_depth,
/// water_depth, bottom_depth, ...), else a variable `sea_floor_depth_below_...` (its median).
[[nodiscard]] std::optional<double> water_depth_of(const netcdf::File& file);

/// A number in a global attribute, also where it is written as text.
[[nodiscard]] std::optional<double> global_number(const netcdf::File& file, std::string_view name);

}  // namespace slackwater::ingest
