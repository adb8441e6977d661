#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "fields/geo/geo_point.h"

namespace slackwater::api {

/// A file may not hold more points.
inline constexpr std::size_t most_points = 1'000'000;

/// Places, and what their list calls them.
struct PointList {
  std::vector<GeoPoint> points;
  std::vector<std::string>
      names;  ///< one a point, perhaps empty; none where there is no such column
};

/// Points from a CSV file. Its first line names the columns: one of `latitude_deg`, `latitude`,
/// `lat` and one of `longitude_deg`, `longitude`, `lon` must be among them, in any order; names
/// stand under `name`, else `id`, `station` or `label`; other columns are left alone. A cell may
/// stand in quotes. Empty lines are passed over. Throws Error(not_found) for a file that is not
/// there, Error(invalid_input) that names the line and what was found in it.
[[nodiscard]] PointList read_points(const std::filesystem::path& file);

/// Depths in metres, ascending: "0,5,12.5", or "0/80/50": from / to / how many, evenly. Throws
/// Error(invalid_input) for what is neither, for depths that do not ascend, are negative or not
/// finite.
[[nodiscard]] std::vector<double> parse_depths(const std::string& text);

}  // namespace slackwater::api
