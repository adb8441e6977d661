#include "ingest/insitu/station.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "fields/base/error.h"
#include "fields/base/numbers/statistics.h"
#include "fields/base/text.h"
#include "ingest/insitu/series_values.h"

namespace slackwater::ingest {
namespace {

constexpr double farthest_mooring_m = 5000.0;
constexpr double worth_telling_m = 10.0;
constexpr std::size_t most_depths = std::size_t{1} << 20U;

bool named(const netcdf::Variable& variable, std::initializer_list<std::string_view> names) {
  const std::string lower = lower_case(variable.name);
  return std::find(names.begin(), names.end(), lower) != names.end();
}

/// Whether a variable runs along one dimension at most; others may be there with a length of 1 (a
/// lone station).
bool runs_along_one_dimension(const netcdf::Variable& variable) {
  return std::count_if(variable.shape.begin(), variable.shape.end(),
                       [](std::size_t length) { return length != 1; }) <= 1;
}

/// The dimension a time runs along: the long one, else the last.
std::string dimension_of_time(const netcdf::Variable& time) {
  for (std::size_t i = 0; i < time.shape.size(); ++i) {
    if (time.shape[i] != 1) return time.dimensions[i];
  }
  return time.dimensions.empty() ? std::string() : time.dimensions.back();
}

bool is_time(const netcdf::Variable& variable) {
  return variable.has_numbers() && runs_along_one_dimension(variable) &&
         contains_ignoring_case(variable.text("units").value_or(""), " since ");
}

bool is_coordinate_variable(const netcdf::Variable& variable) {
  return variable.dimensions.size() == 1 && variable.dimensions[0] == variable.name;
}

const netcdf::Variable* time_of(const netcdf::File& file) {
  const netcdf::Variable* found = nullptr;
  for (const netcdf::Variable& variable : file.variables()) {
    if (!is_time(variable)) continue;
    if (is_coordinate_variable(variable)) return &variable;
    const bool says_time = variable.text("standard_name") == "time" || named(variable, {"time"});
    if (says_time && found == nullptr) found = &variable;
  }
  return found;
}

const netcdf::Variable* horizontal(const netcdf::File& file, const char* standard_name,
                                   std::initializer_list<std::string_view> names) {
  for (const netcdf::Variable& variable : file.variables()) {
    if (variable.text("standard_name") == standard_name && variable.has_numbers()) return &variable;
  }
  for (const netcdf::Variable& variable : file.variables()) {
    if (named(variable, names) && variable.has_numbers()) return &variable;
  }
  return nullptr;
}

/// Scalar `x` or `y` that a variable names in its `coordinates`.
const netcdf::Variable* bare_scalar(const netcdf::File& file, const char* name) {
  const netcdf::Variable* found = file.find(name);
  if (found == nullptr || found->size() != 1 || !found->has_numbers()) return nullptr;
  for (const netcdf::Variable& variable : file.variables()) {
    std::istringstream words(variable.text("coordinates").value_or(""));
    for (std::string word; words >> word;) {
      if (word == name) return found;
    }
  }
  return nullptr;
}

/// The positions of one station, fill and bad ones left out; longitudes run on from the first.
std::vector<GeoPoint> positions_of(const netcdf::File& file, const StationAxes& axes,
                                   std::size_t station) {
  const std::vector<double> latitudes = file.read_all(*axes.latitude);
  const std::vector<double> longitudes = file.read_all(*axes.longitude);
  std::size_t first = 0;
  std::size_t last = std::min(latitudes.size(), longitudes.size());
  if (!axes.station_dimension.empty() && latitudes.size() == axes.stations) {
    first = station;
    last = station + 1;
  }
  std::vector<SampleStatus> flags;
  if (const netcdf::Variable* found = file.find("POSITION_QC");
      found != nullptr && found->size() == latitudes.size()) {
    flags = flags_of(file, *found);
  }
  const double latitude_fill = axes.latitude->number("_FillValue").value_or(std::nan(""));
  const double longitude_fill = axes.longitude->number("_FillValue").value_or(std::nan(""));
  std::vector<GeoPoint> points;
  for (std::size_t i = first; i < last; ++i) {
    if (latitudes[i] == latitude_fill || longitudes[i] == longitude_fill) continue;
    if (!flags.empty() && !has_value(flags[i])) continue;
    if (!(std::abs(latitudes[i]) <= 90.0) || !(std::abs(longitudes[i]) <= 360.0)) continue;
    points.push_back(GeoPoint::from_degrees(latitudes[i], longitudes[i]));
  }
  return points;
}

}  // namespace

bool is_place_of_each_value(const netcdf::Variable& coordinate, std::string_view time_dimension) {
  return coordinate.dimensions.size() == 2 && !time_dimension.empty() &&
         std::find(coordinate.dimensions.begin(), coordinate.dimensions.end(), time_dimension) !=
             coordinate.dimensions.end();
}

std::optional<double> global_number(const netcdf::File& file, std::string_view name) {
  for (const netcdf::Attribute& attribute : file.attributes()) {
    if (attribute.name != name) continue;
    if (const auto number = attribute.number()) return number;
    const std::string text = attribute.text().value_or("");
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (end != text.c_str() && std::isfinite(value)) return value;
  }
  return std::nullopt;
}

std::optional<StationAxes> station_axes_of(const netcdf::File& file) {
  StationAxes axes;
  axes.time = time_of(file);
  axes.latitude = horizontal(file, "latitude", {"latitude", "lat"});
  axes.longitude = horizontal(file, "longitude", {"longitude", "lon"});
  if (axes.latitude == nullptr && axes.longitude == nullptr) {
    axes.latitude = bare_scalar(file, "y");
    axes.longitude = bare_scalar(file, "x");
  }
  if (axes.time == nullptr || axes.latitude == nullptr || axes.longitude == nullptr)
    return std::nullopt;
  if (axes.latitude->size() != axes.longitude->size()) return std::nullopt;
  axes.time_dimension = dimension_of_time(*axes.time);
  if (is_place_of_each_value(*axes.latitude, axes.time_dimension) &&
      axes.latitude->dimensions == axes.longitude->dimensions)
    return axes;
  if (axes.latitude->dimensions.size() > 1) return std::nullopt;

  if (!axes.latitude->dimensions.empty() &&
      axes.latitude->dimensions == axes.longitude->dimensions &&
      axes.latitude->dimensions[0] != axes.time_dimension) {
    axes.station_dimension = axes.latitude->dimensions[0];
    axes.stations = axes.latitude->size();
  } else if (axes.latitude->size() > 1 && axes.latitude->size() != axes.time->size()) {
    return std::nullopt;
  }
  return axes;
}

std::vector<StationAxes> all_station_axes_of(const netcdf::File& file) {
  std::vector<StationAxes> all;
  const auto first = station_axes_of(file);
  if (!first) return all;
  all.push_back(*first);
  for (const netcdf::Variable& variable : file.variables()) {
    if (&variable == first->time || !is_time(variable) || !is_coordinate_variable(variable) ||
        variable.name == first->time_dimension || variable.name == first->station_dimension) {
      continue;
    }
    StationAxes other = *first;
    other.time = &variable;
    other.time_dimension = variable.name;
    all.push_back(std::move(other));
  }
  return all;
}

GeoPoint position_of(const netcdf::File& file, const StationAxes& axes, std::size_t station,
                     std::vector<std::string>& warnings) {
  const std::vector<GeoPoint> points = positions_of(file, axes, station);
  if (points.empty()) {
    throw Error(ErrorKind::invalid_input, "no position: '" + axes.latitude->name + "' and '" +
                                              axes.longitude->name +
                                              "' hold no latitude and longitude; expected degrees");
  }
  std::vector<double> latitudes;
  std::vector<double>
      offsets;  // of longitude from the first position: the antimeridian does not split them
  for (const GeoPoint& point : points) {
    latitudes.push_back(point.latitude_deg());
    offsets.push_back(
        normalised_longitude_deg(point.longitude_deg() - points.front().longitude_deg()));
  }
  const GeoPoint middle =
      points.size() == 1
          ? points.front()
          : GeoPoint::from_degrees(upper_median(latitudes),
                                   points.front().longitude_deg() + upper_median(offsets));
  double farthest_m = 0;
  GeoPoint last_measured = middle;
  for (const GeoPoint& point : points) {
    if (point == last_measured) continue;
    farthest_m = std::max(farthest_m, distance_m(middle, point));
    last_measured = point;
  }
  const std::string told = std::to_string(std::lround(farthest_m)) + " m from its median position";
  if (farthest_m > farthest_mooring_m) {
    throw Error(ErrorKind::invalid_input, "the platform strays " + told +
                                              "; expected a mooring or a fixed platform (" +
                                              std::to_string(std::lround(farthest_mooring_m)) +
                                              " m at most), not a ship or a drifter");
  }
  if (farthest_m > worth_telling_m) {
    warnings.push_back("the platform moves up to " + told + ", which is used for it");
  }
  return middle;
}

std::string station_name_of(const netcdf::File& file, const StationAxes& axes,
                            std::size_t station) {
  for (const netcdf::Variable& variable : file.variables()) {
    if (variable.text("cf_role") != "timeseries_id" || variable.type != netcdf::Type::character)
      continue;
    std::string all = file.read_text(variable);
    if (axes.stations == 1) return all;
    const std::size_t width = variable.shape.empty() ? 0 : variable.shape.back();
    if (width > 0 && station * width < variable.size() && all.size() > station * width) {
      std::string name = all.substr(station * width, width);
      while (!name.empty() && (name.back() == ' ' || name.back() == '\0')) name.pop_back();
      if (!name.empty()) return name;
    }
  }
  for (const char* attribute :
       {"platform_code", "station", "site_code", "platform_name", "station_name", "name", "id"}) {
    std::string name = file.text(attribute).value_or("");
    if (name.find_first_not_of(' ') == std::string::npos) continue;
    return axes.stations == 1 ? name : name + "-" + std::to_string(station + 1);
  }
  const std::string stem = file.path().stem().string();
  return axes.stations == 1 ? stem : stem + "-" + std::to_string(station + 1);
}

std::optional<double> water_depth_of(const netcdf::File& file) {
  const auto believable = [](double depth) { return depth > 0.0 && depth < 12000.0; };
  for (const char* attribute :
       {"site_nominal_depth", "water_depth", "water_depth_m", "bottom_depth", "sea_floor_depth",
        "sea_floor_depth_below_sea_surface", "site_depth"}) {
    const auto depth = global_number(file, attribute);
    if (depth && believable(*depth)) return depth;
  }
  for (const netcdf::Variable& variable : file.variables()) {
    const std::string name = variable.text("standard_name").value_or(variable.name);
    const bool is_it = name.starts_with("sea_floor_depth_below_") ||
                       named(variable, {"water_depth", "bottom_depth", "sea_floor_depth"});
    if (!is_it || !variable.has_numbers() || variable.size() > most_depths) continue;
    std::vector<double> depths = file.read_all(variable);
    std::erase_if(depths, [&](double depth) { return !believable(depth); });
    if (!depths.empty()) return upper_median(std::move(depths));
  }
  return std::nullopt;
}

}  // namespace slackwater::ingest
