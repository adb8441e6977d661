#include "ingest/insitu/vertical_coordinate.h"

#include <algorithm>
#include <sstream>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/insitu/series_values.h"

namespace slackwater::ingest {
namespace {

bool is_one_of(const std::string& text, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), text) != words.end();
}

bool counts_upwards(const netcdf::Variable& variable) {
  if (const auto positive = variable.text("positive")) return lower_case(*positive) == "up";
  const std::string name = variable.text("standard_name").value_or("");
  return name == "altitude" || name == "height_above_mean_sea_level" || name == "height";
}

bool is_vertical(const netcdf::Variable& variable) {
  const std::string name = variable.text("standard_name").value_or("");
  return is_depth_coordinate(variable) || counts_from_bed(variable) || counts_upwards(variable) ||
         name == "depth" || variable.text("positive") || variable.text("axis") == "Z";
}

bool has_one_value_a_station(const netcdf::Variable& variable, const StationAxes& axes) {
  return variable.size() == 1 ||
         (variable.dimensions.size() == 1 && !axes.station_dimension.empty() &&
          variable.dimensions[0] == axes.station_dimension);
}

std::string count_of(const std::vector<double>& levels_m) {
  return std::to_string(levels_m.size()) + (levels_m.size() == 1 ? " level" : " levels");
}

}  // namespace

bool is_depth_coordinate(const netcdf::Variable& variable) {
  if (!variable.has_numbers()) return false;
  if (lower_case(variable.text("positive").value_or("")) == "up") return false;
  const std::string standard_name = variable.text("standard_name").value_or("");
  if (!standard_name.empty()) return standard_name == "depth";
  return is_one_of(lower_case(variable.name), {"depth", "deph"});
}

bool counts_from_bed(const netcdf::Variable& variable) {
  if (!variable.has_numbers()) return false;
  const std::string standard_name = variable.text("standard_name").value_or("");
  if (is_one_of(standard_name, {"height_above_sea_floor", "height_above_sea_bed"})) return true;
  // Any other vertical standard name has a foot of its own.
  if (standard_name == "depth" || standard_name == "altitude" ||
      standard_name == "height_above_mean_sea_level") {
    return false;
  }
  if (is_one_of(lower_case(variable.name), {"hab", "mab", "hasb", "height_asb"})) return true;
  const std::string said =
      lower_case(variable.name + " " + variable.text("long_name").value_or("") + " " +
                 variable.text("reference_datum").value_or(""));
  const auto says = [&](const char* part) { return said.find(part) != std::string::npos; };
  const bool bed = says("sea floor") || says("sea_floor") || says("seafloor") || says("seabed") ||
                   says("sea bed") || says("sea_bed") || says("above bottom") ||
                   says("above_bottom") || says("above bed") || says("above_bed") ||
                   says("from bed") || says("from bottom");
  return bed && !says("below");
}

const netcdf::Variable* own_vertical(const netcdf::File& file, const StationAxes& axes,
                                     const netcdf::Variable& variable) {
  std::istringstream names(variable.text("coordinates").value_or(""));
  for (std::string name; names >> name;) {
    const netcdf::Variable* found = file.find(name);
    if (found == nullptr || found == axes.latitude || found == axes.longitude ||
        found == axes.time || !found->has_numbers() || !has_one_value_a_station(*found, axes)) {
      continue;
    }
    if (is_vertical(*found)) return found;
  }
  if (axes.station_dimension.empty() || axes.stations < 2) return nullptr;
  for (const netcdf::Variable& found : file.variables()) {
    if (found.dimensions == std::vector<std::string>{axes.station_dimension} &&
        (is_depth_coordinate(found) || counts_from_bed(found))) {
      return &found;
    }
  }
  return nullptr;
}

double own_level_m(const netcdf::File& file, const StationAxes& axes,
                   const netcdf::Variable& coordinate, std::size_t station,
                   std::vector<std::string>& warnings) {
  netcdf::Variable with_unit = coordinate;
  if (!coordinate.text("units")) {
    with_unit.attributes.push_back({"units", netcdf::Type::character, std::string("m")});
    warnings.push_back("'" + coordinate.name + "' has no units; read as metres");
  }
  const SeriesDimensions dimensions =
      dimensions_of(with_unit, axes.time_dimension, axes.station_dimension);
  const SeriesValues value = read_series(file, with_unit, dimensions, station, "m", warnings);
  if (value.values.empty() || !has_value(value.status.front())) {
    throw Error(ErrorKind::invalid_input,
                "'" + coordinate.name + "' has no value; expected the level in metres");
  }
  return value.values.front();
}

std::vector<double> depths_of(const netcdf::Variable& coordinate, std::vector<double> levels_m,
                              const std::optional<double>& water_depth_m,
                              std::vector<std::string>& warnings) {
  const auto all = [&](auto holds) { return std::all_of(levels_m.begin(), levels_m.end(), holds); };
  const bool upwards = counts_upwards(coordinate);
  bool from_bed = counts_from_bed(coordinate);
  if (!from_bed && upwards && all([](double level) { return level >= 0.0; }) &&
      !all([](double level) { return level == 0.0; })) {
    from_bed = true;
    warnings.push_back("'" + coordinate.name + "' counts " + count_of(levels_m) +
                       " upwards from a foot that it does not name; read as heights above the "
                       "sea bed");
  }
  if (from_bed) {
    if (!water_depth_m) {
      throw Error(ErrorKind::invalid_input,
                  "'" + coordinate.name +
                      "' counts from the sea bed, whose depth the file does not state; expected a "
                      "global attribute water_depth (metres) or a variable "
                      "sea_floor_depth_below_sea_surface: add one (ncatted) and ingest again");
    }
    for (double& level : levels_m) level = *water_depth_m - level;
    return levels_m;
  }
  if (upwards) {
    for (double& level : levels_m) level = -level;
  } else if (all([](double level) { return level < 0.0; })) {
    warnings.push_back("'" + coordinate.name +
                       "' holds depths below zero only; read as counted downwards");
    for (double& level : levels_m) level = -level;
  }
  return levels_m;
}

}  // namespace slackwater::ingest
