#include "ingest/insitu/series_levels.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/insitu/vertical_coordinate.h"

namespace slackwater::ingest {
namespace {

constexpr double shallowest_m =
    -2.0;  // a depth above the still water by less than this is a wave trough's

struct Spread {
  double median = 0;
  double width = 0;  ///< between the 5 and 95 per cent points
};

Spread spread_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    const double place = share * static_cast<double>(values.size() - 1);
    return values[static_cast<std::size_t>(std::lround(place))];
  };
  return {at(0.5), at(0.95) - at(0.05)};
}

std::string metres(double value) { return formatted("{:.4g} m", value); }

bool is_vertical_role(const netcdf::Variable& variable) {
  if (contains_ignoring_case(variable.name, "distance") ||
      contains_ignoring_case(variable.name, "height"))
    return true;
  const std::string name = variable.text("standard_name").value_or("");
  return name == "depth" || name == "height" || name == "altitude" ||
         variable.text("axis") == "Z" || variable.text("positive") || counts_from_bed(variable);
}

/// Depths of a series of the instrument itself: DEPTH(t), or a scalar.
std::vector<double> instrument_depths(const netcdf::File& file, const StationAxes& axes,
                                      std::size_t station, std::vector<std::string>& warnings) {
  const netcdf::Variable* scalar = nullptr;
  for (const netcdf::Variable& variable : file.variables()) {
    if (!is_depth_coordinate(variable)) continue;
    const bool over_time =
        variable.dimensions.size() == 1 && variable.dimensions[0] == axes.time_dimension;
    if (over_time) {
      const SeriesDimensions dimensions =
          dimensions_of(variable, axes.time_dimension, axes.station_dimension);
      const SeriesValues depths = read_series(file, variable, dimensions, station, "m", warnings);
      std::vector<double> good;
      for (std::size_t t = 0; t < depths.times; ++t) {
        if (has_value(depths.status[t])) good.push_back(depths.values[t]);
      }
      if (!good.empty()) return good;
    }
    if (variable.size() == 1) scalar = &variable;
  }
  if (scalar != nullptr) return file.read_all(*scalar);
  for (const char* attribute : {"instrument_depth", "instrument_nominal_depth", "sensor_depth"}) {
    if (const auto depth = global_number(file, attribute)) return {*depth};
  }
  return {};
}

const netcdf::Variable* level_coordinate(const netcdf::File& file, const StationAxes& axes,
                                         std::string_view level_dimension) {
  // A depth of each sample says more than the numbers of a dimension.
  for (const netcdf::Variable& variable : file.variables()) {
    const bool has_level = std::find(variable.dimensions.begin(), variable.dimensions.end(),
                                     level_dimension) != variable.dimensions.end();
    if (has_level && variable.dimensions.size() <= 3 && is_depth_coordinate(variable))
      return &variable;
  }
  if (const netcdf::Variable* same = file.find(level_dimension);
      same != nullptr && same->dimensions.size() == 1 && same->dimensions[0] == level_dimension) {
    return same;
  }
  for (const netcdf::Variable& variable : file.variables()) {
    if (variable.dimensions.size() == 1 && variable.dimensions[0] == level_dimension &&
        is_vertical_role(variable)) {
      return &variable;
    }
  }
  static_cast<void>(axes);
  return nullptr;
}

bool counts_from_sensor(const netcdf::Variable& coordinate) {
  if (counts_from_bed(coordinate)) return false;
  if (coordinate.text("reference_datum") == "sensor") return true;
  for (const char* part : {"above_sensor", "above sensor", "distance", "transducer"}) {
    if (contains_ignoring_case(coordinate.name, part) ||
        contains_ignoring_case(coordinate.text("long_name").value_or(""), part)) {
      return true;
    }
  }
  return false;
}

std::vector<bool> side_lobes(const netcdf::File& file, const std::vector<double>& distances_m,
                             bool down, double sensor_depth_m,
                             const std::optional<double>& water_depth_m) {
  std::optional<double> angle = global_number(file, "beam_angle");
  if (!angle) angle = global_number(file, "instrument_beam_angle");
  if (!angle || *angle <= 0.0 || *angle >= 45.0 || distances_m.size() < 2) return {};
  if (down && !water_depth_m) return {};
  const double range_m = down ? *water_depth_m - sensor_depth_m : sensor_depth_m;
  const double bin_m = std::abs(distances_m[1] - distances_m[0]);
  const double pulse_m =
      global_number(file, "transmit_pulse_length_cm").value_or(100.0 * bin_m) / 100.0;
  const double clear_m = range_m * std::cos(*angle * constants::pi / 180.0) - (bin_m + pulse_m);
  std::vector<bool> reached;
  reached.reserve(distances_m.size());
  for (const double distance : distances_m) reached.push_back(distance > clear_m);
  return reached;
}

/// Bins counted from a profiler.
SeriesLevels profiler_levels(const netcdf::File& file, const netcdf::Variable& coordinate,
                             const std::vector<double>& distances_m,
                             const std::vector<double>& sensor_depths_m,
                             const std::optional<double>& water_depth_m,
                             std::vector<std::string>& warnings) {
  if (sensor_depths_m.empty()) {
    throw Error(ErrorKind::invalid_input,
                "'" + coordinate.name +
                    "' counts from the sensor, whose depth the file does "
                    "not state; expected a variable DEPTH or an attribute instrument_depth");
  }
  const Spread sensor = spread_of(sensor_depths_m);
  const std::string said =
      lower_case(file.text("orientation").value_or(coordinate.text("positive").value_or("up")));
  const bool says_down = said.starts_with("down");
  const auto wet_share = [&](bool down) {
    std::size_t wet = 0;
    for (const double distance : distances_m) {
      const double depth = sensor.median + (down ? distance : -distance);
      if (depth >= shallowest_m && depth <= water_depth_m.value_or(12000.0)) ++wet;
    }
    return static_cast<double>(wet) / static_cast<double>(distances_m.size());
  };
  const bool down = wet_share(says_down) >= 0.5 || wet_share(says_down) >= wet_share(!says_down)
                        ? says_down
                        : !says_down;
  if (down != says_down) {
    warnings.push_back("the profiler at " + metres(sensor.median) + " is said to look " +
                       (says_down ? "down" : "up") +
                       ", which leaves most bins out of the water; read as looking " +
                       (down ? "down" : "up"));
  }
  const double bin_m = distances_m.size() > 1 ? std::abs(distances_m[1] - distances_m[0]) : 1.0;
  if (sensor.width > 0.5 * bin_m) {
    warnings.push_back("the depth of the sensor spans " + metres(sensor.width) +
                       " (nine tenths of the time), more than "
                       "half a bin of " +
                       metres(bin_m) + "; depths of the bins are medians");
  }
  SeriesLevels levels;
  levels.kind = VerticalKind::depth_m;
  for (const double distance : distances_m)
    levels.levels_m.push_back(sensor.median + (down ? distance : -distance));
  levels.side_lobe = side_lobes(file, distances_m, down, sensor.median, water_depth_m);
  return levels;
}

/// Depths that the file gives for each level, perhaps for each time too.
SeriesLevels stated_levels(const netcdf::File& file, const StationAxes& axes,
                           const netcdf::Variable& coordinate, std::size_t levels,
                           std::size_t station, bool of_water,
                           const std::optional<double>& water_depth_m,
                           std::vector<std::string>& warnings) {
  const SeriesDimensions dimensions =
      dimensions_of(coordinate, axes.time_dimension, axes.station_dimension);
  netcdf::Variable with_unit = coordinate;
  if (!coordinate.text("units")) {
    with_unit.attributes.push_back({"units", netcdf::Type::character, std::string("m")});
    warnings.push_back("'" + coordinate.name + "' has no units; read as metres");
  }
  const SeriesValues depths = read_series(file, with_unit, dimensions, station, "m", warnings);
  if (depths.levels != levels) {
    throw Error(ErrorKind::invalid_input, "'" + coordinate.name + "' has " +
                                              std::to_string(depths.levels) + " levels; expected " +
                                              std::to_string(levels));
  }
  SeriesLevels out;
  out.kind = VerticalKind::depth_m;
  double widest_m = 0;
  for (std::size_t k = 0; k < levels; ++k) {
    std::vector<double> here;
    for (std::size_t t = 0; t < depths.times; ++t) {
      const double depth = depths.values[depths.at(t, k)];
      if (has_value(depths.status[depths.at(t, k)])) here.push_back(depth);
    }
    if (here.empty()) {
      throw Error(ErrorKind::invalid_input, "'" + coordinate.name + "' has no depth for level " +
                                                std::to_string(k + 1) +
                                                "; expected metres below the sea surface");
    }
    const Spread spread = spread_of(std::move(here));
    widest_m = std::max(widest_m, spread.width);
    out.levels_m.push_back(spread.median);
  }
  if (of_water)
    out.levels_m = depths_of(coordinate, std::move(out.levels_m), water_depth_m, warnings);
  const double spacing_m = levels > 1 ? std::abs(out.levels_m[1] - out.levels_m[0]) : 1.0;
  if (widest_m > 0.5 * spacing_m) {
    warnings.push_back("depths in '" + coordinate.name + "' span up to " + metres(widest_m) +
                       " over time, more than half the spacing of " + metres(spacing_m) +
                       "; medians are used");
  }
  return out;
}

SeriesLevels at_height(double height_m) { return {VerticalKind::height_m, {height_m}, {}}; }
SeriesLevels at_depth(double depth_m) { return {VerticalKind::depth_m, {depth_m}, {}}; }

}  // namespace

SeriesLevels levels_of_series(const netcdf::File& file, const StationAxes& axes,
                              const SeriesValues& series, std::string_view level_dimension,
                              std::size_t station, const std::optional<double>& water_depth_m,
                              const std::optional<double>& default_height_m,
                              std::vector<std::string>& warnings) {
  const std::optional<double> own_depth = series.variable->number("sensor_depth");
  const std::optional<double> own_height = series.variable->number("sensor_height");
  if (series.realm == Realm::surface) return {};
  const netcdf::Variable* own =
      series.levels == 1 ? own_vertical(file, axes, *series.variable) : nullptr;
  if (series.realm == Realm::air && series.levels == 1) {
    if (own_height) return at_height(*own_height);
    if (own_depth && *own_depth < 0.0) return at_height(-*own_depth);
    if (own != nullptr && !is_depth_coordinate(*own))
      return at_height(own_level_m(file, axes, *own, station, warnings));
    for (const netcdf::Variable& variable : file.variables()) {
      if (variable.size() == 1 && variable.text("standard_name") == "height" &&
          variable.text("units")) {
        const SeriesDimensions dimensions =
            dimensions_of(variable, axes.time_dimension, axes.station_dimension);
        return at_height(read_series(file, variable, dimensions, 0, "m", warnings).values.at(0));
      }
    }
    const double height = default_height_m.value_or(10.0);
    warnings.push_back("no height stated for '" + series.source_name + "'; taken as " +
                       metres(height));
    return at_height(height);
  }
  const netcdf::Variable* coordinate =
      level_dimension.empty() ? nullptr : level_coordinate(file, axes, level_dimension);
  if (series.realm == Realm::air) {
    if (coordinate == nullptr || coordinate->text("positive") == "down") {
      throw Error(ErrorKind::invalid_input,
                  "'" + series.source_name + "' has " + std::to_string(series.levels) +
                      " levels without heights; expected a height coordinate in metres");
    }
    SeriesLevels levels = stated_levels(file, axes, *coordinate, series.levels, station, false,
                                        water_depth_m, warnings);
    levels.kind = VerticalKind::height_m;
    for (double& level : levels.levels_m) level = std::abs(level);
    return levels;
  }
  if (series.levels == 1 && own_depth && *own_depth >= 0.0) return at_depth(*own_depth);
  if (own != nullptr) {
    const double level_m = own_level_m(file, axes, *own, station, warnings);
    return at_depth(depths_of(*own, {level_m}, water_depth_m, warnings).front());
  }
  // Distances from a sensor run along the levels alone; what varies in time too is a depth of each
  // sample.
  if (coordinate != nullptr && coordinate->dimensions.size() == 1 &&
      counts_from_sensor(*coordinate)) {
    std::vector<double> distances = file.read_all(*coordinate);
    return profiler_levels(file, *coordinate, distances,
                           instrument_depths(file, axes, station, warnings), water_depth_m,
                           warnings);
  }
  if (coordinate != nullptr)
    return stated_levels(file, axes, *coordinate, series.levels, station, true, water_depth_m,
                         warnings);
  if (series.levels == 1) {
    const std::vector<double> depths = instrument_depths(file, axes, station, warnings);
    if (!depths.empty()) return at_depth(spread_of(depths).median);
  }
  throw Error(ErrorKind::invalid_input,
              "no depth stated for '" + series.source_name +
                  "'; expected a depth coordinate or an attribute sensor_depth");
}

}  // namespace slackwater::ingest
