#include "ingest/cf/axes.h"

#include <algorithm>
#include <array>
#include <sstream>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/cf/packing.h"
#include "ingest/cf/settle.h"
#include "ingest/cf/units.h"

namespace slackwater::ingest {
namespace {

constexpr std::size_t longest_axis = std::size_t{1} << 22;

[[noreturn]] void refuse_axis(const netcdf::Variable& variable, const std::string& why) {
  throw Error(ErrorKind::invalid_input, "variable '" + variable.name + "': " + why);
}

bool is_one_of(std::string_view text, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), text) != words.end();
}

AxisKind kind_from_units(const std::string& units) {
  if (is_one_of(units, {"degrees_north", "degree_north", "degree_n", "degrees_n", "degreen",
                        "degreesn"})) {
    return AxisKind::latitude;
  }
  if (is_one_of(units,
                {"degrees_east", "degree_east", "degree_e", "degrees_e", "degreee", "degreese"})) {
    return AxisKind::longitude;
  }
  if (units.find(" since ") != std::string::npos) return AxisKind::time;
  if (is_one_of(units, {"pa", "hpa", "mb", "millibar", "dbar", "decibar", "bar"}))
    return AxisKind::vertical;
  return AxisKind::other;
}

AxisKind kind_from_axis(const std::string& axis) {
  if (axis == "t") return AxisKind::time;
  if (axis == "z") return AxisKind::vertical;
  if (axis == "y") return AxisKind::latitude;
  if (axis == "x") return AxisKind::longitude;
  return AxisKind::other;
}

AxisKind kind_from_name(const std::string& name) {
  if (is_one_of(name, {"time", "time_counter", "valid_time", "ocean_time"})) return AxisKind::time;
  if (is_one_of(name, {"lat", "latitude", "nav_lat"})) return AxisKind::latitude;
  if (is_one_of(name, {"lon", "longitude", "nav_lon", "long"})) return AxisKind::longitude;
  if (is_one_of(name, {"depth", "deptht", "depthu", "depthv", "deph", "elevation", "height", "lev",
                       "level"}) ||
      name.starts_with("height_above_ground")) {
    return AxisKind::vertical;
  }
  return AxisKind::other;
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

bool is_named_by(const netcdf::Variable& data, const std::string& coordinate) {
  const auto words = words_of(data.text("coordinates").value_or(""));
  return std::find(words.begin(), words.end(), coordinate) != words.end();
}

/// The coordinate variable of a dimension: of its own name, else one named by `coordinates`, else
/// the only one.
const netcdf::Variable* coordinate_of(const netcdf::File& file, const netcdf::Variable& data,
                                      const std::string& dimension, const Product& product) {
  const auto runs_along = [&](const netcdf::Variable& v) {
    return v.dimensions.size() == 1 && v.dimensions[0] == dimension && v.has_numbers() &&
           v.name != data.name;
  };
  if (const netcdf::Variable* own = file.find(dimension); own != nullptr && runs_along(*own))
    return own;
  const netcdf::Variable* found = nullptr;
  for (const netcdf::Variable& candidate : file.variables()) {
    if (!runs_along(candidate) || axis_kind(candidate, product) == AxisKind::other) continue;
    if (is_named_by(data, candidate.name)) return &candidate;
    if (found == nullptr) found = &candidate;
  }
  return found;
}

/// Whether a coordinate of two dimensions runs along one of time.
bool follows_time(const netcdf::File& file, const netcdf::Variable& coordinate) {
  if (coordinate.dimensions.size() != 2) return false;
  return std::any_of(
      file.variables().begin(), file.variables().end(), [&](const netcdf::Variable& time) {
        return contains_ignoring_case(time.text("units").value_or(""), " since ") &&
               std::any_of(time.dimensions.begin(), time.dimensions.end(),
                           [&](const std::string& dimension) {
                             return std::find(coordinate.dimensions.begin(),
                                              coordinate.dimensions.end(),
                                              dimension) != coordinate.dimensions.end();
                           });
      });
}

void refuse_other_grids(const netcdf::File& file, const netcdf::Variable& data) {
  for (const std::string& name : words_of(data.text("coordinates").value_or(""))) {
    const netcdf::Variable* coordinate = file.find(name);
    if (coordinate == nullptr || coordinate->dimensions.size() < 2) continue;
    const std::string standard_name = coordinate->text("standard_name").value_or("");
    const AxisKind by_name = kind_from_name(lower_case(name));
    const AxisKind by_units = kind_from_units(lower_case(coordinate->text("units").value_or("")));
    const auto horizontal = [](AxisKind kind) {
      return kind == AxisKind::latitude || kind == AxisKind::longitude;
    };
    if (is_one_of(standard_name, {"latitude", "longitude"}) || horizontal(by_name) ||
        horizontal(by_units)) {
      if (follows_time(file, *coordinate))
        refuse_axis(data,
                    "has a place for each time (" + name +
                        " runs along time): a track or scattered observations, no grid; expected "
                        "a grid, or a series of one place with one latitude and longitude");
      refuse_axis(data,
                  "lies on a curvilinear grid (" + name + " has " +
                      std::to_string(coordinate->dimensions.size()) +
                      " dimensions); expected one-dimensional latitude and longitude; regrid it "
                      "first (cdo remapbil)");
    }
  }
}

void bind(BoundVariable& bound, AxisKind kind, const BoundAxis& axis) {
  BoundAxis* place = kind == AxisKind::time       ? &bound.time
                     : kind == AxisKind::vertical ? &bound.vertical
                     : kind == AxisKind::latitude ? &bound.latitude
                                                  : &bound.longitude;
  if (place->dimension && axis.dimension) {
    refuse_axis(*bound.variable, "has two axes of one kind, '" + place->coordinate->name +
                                     "' and '" + axis.coordinate->name +
                                     "'; expected one time, level, latitude and longitude");
  }
  if (place->coordinate == nullptr || axis.dimension) *place = axis;
}

/// Whether a scalar vertical coordinate says where this quantity is (not where another one is).
bool fits_realm(const netcdf::Variable& scalar, Realm realm, const Product& product) {
  const std::string standard_name = product.attribute(scalar, "standard_name").value_or("");
  const std::string positive = lower_case(product.attribute(scalar, "positive").value_or(""));
  const std::string name = lower_case(scalar.name);
  if (realm == Realm::sea)
    return standard_name == "depth" || (name.starts_with("dep") && positive != "up");
  if (realm == Realm::air) return standard_name == "height" || name == "height";
  return false;
}

}  // namespace

AxisKind axis_kind(const netcdf::Variable& coordinate, const Product& product) {
  const std::string standard_name = product.attribute(coordinate, "standard_name").value_or("");
  if (standard_name == "time") return AxisKind::time;
  if (standard_name == "latitude") return AxisKind::latitude;
  if (standard_name == "longitude") return AxisKind::longitude;
  if (is_one_of(standard_name,
                {"depth", "height", "altitude", "height_above_mean_sea_level",
                 "height_above_geopotential_datum", "air_pressure", "sea_water_pressure"}) ||
      standard_name.starts_with("ocean_") || standard_name.starts_with("atmosphere_")) {
    return AxisKind::vertical;
  }
  if (is_one_of(standard_name, {"forecast_reference_time", "forecast_period", "realization",
                                "projection_x_coordinate", "projection_y_coordinate",
                                "grid_latitude", "grid_longitude"})) {
    return AxisKind::other;
  }
  AxisKind kind = kind_from_units(lower_case(product.attribute(coordinate, "units").value_or("")));
  if (kind == AxisKind::other)
    kind = kind_from_axis(lower_case(product.attribute(coordinate, "axis").value_or("")));
  if (kind == AxisKind::other) kind = kind_from_name(lower_case(coordinate.name));
  if (kind == AxisKind::other && product.attribute(coordinate, "positive"))
    kind = AxisKind::vertical;
  return kind;
}

BoundVariable bind_axes(const netcdf::File& file, const netcdf::Variable& variable,
                        const Quantity& quantity, const Product& product) {
  BoundVariable bound;
  bound.variable = &variable;
  bound.quantity = &quantity;
  refuse_other_grids(file, variable);
  for (std::size_t d = 0; d < variable.dimensions.size(); ++d) {
    const std::string& dimension = variable.dimensions[d];
    const netcdf::Variable* coordinate = coordinate_of(file, variable, dimension, product);
    const AxisKind kind = coordinate == nullptr ? AxisKind::other : axis_kind(*coordinate, product);
    if (kind != AxisKind::other) {
      bind(bound, kind, {coordinate, d});
    } else if (variable.shape[d] != 1) {
      const std::string standard_name =
          coordinate == nullptr ? "" : coordinate->text("standard_name").value_or("");
      if (standard_name.starts_with("projection_") || standard_name.starts_with("grid_")) {
        refuse_axis(variable,
                    "lies on a projected or rotated grid ('" + dimension + "' is a " +
                        standard_name +
                        "); expected latitude and longitude; regrid it first (cdo remapbil)");
      }
      refuse_axis(
          variable,
          "dimension '" + dimension + "' of length " + std::to_string(variable.shape[d]) +
              (coordinate == nullptr ? " has no coordinate variable"
                                     : " is neither time, level, latitude nor longitude") +
              "; expected (time, level, latitude, longitude) with coordinates; select one slice "
              "first");
    }
  }
  for (const netcdf::Variable& scalar : file.variables()) {
    const bool is_scalar =
        scalar.dimensions.empty() || (scalar.dimensions.size() == 1 && scalar.shape[0] == 1);
    if (!is_scalar || !scalar.has_numbers() || &scalar == &variable) continue;
    const AxisKind kind = axis_kind(scalar, product);
    const bool named = is_named_by(variable, scalar.name);
    const BoundAxis axis{&scalar, std::nullopt};
    const bool dates_it = scalar.dimensions.empty() || named || !quantity.is_static;
    if (kind == AxisKind::time && bound.time.coordinate == nullptr && dates_it)
      bind(bound, kind, axis);
    if (kind == AxisKind::latitude && bound.latitude.coordinate == nullptr) bind(bound, kind, axis);
    if (kind == AxisKind::longitude && bound.longitude.coordinate == nullptr)
      bind(bound, kind, axis);
    if (kind == AxisKind::vertical && bound.vertical.coordinate == nullptr && named &&
        fits_realm(scalar, quantity.realm, product)) {
      bind(bound, kind, axis);
    }
  }
  if (bound.latitude.coordinate == nullptr || bound.longitude.coordinate == nullptr) {
    refuse_axis(variable, std::string("has no ") +
                              (bound.latitude.coordinate == nullptr ? "latitude" : "longitude") +
                              "; expected coordinate variables of latitude and longitude");
  }
  if (bound.time.coordinate == nullptr && !quantity.is_static) {
    refuse_axis(
        variable,
        "has no time, neither an axis nor a scalar coordinate; expected 'time' with units like "
        "'hours "
        "since 1950-01-01'");
  }
  return bound;
}

void refuse_terrain_following(const netcdf::File& file) {
  for (const netcdf::Variable& variable : file.variables()) {
    const std::string standard_name = variable.text("standard_name").value_or("");
    if (variable.dimensions.size() == 1 && (standard_name.starts_with("ocean_s_coordinate") ||
                                            standard_name.starts_with("ocean_sigma") ||
                                            standard_name.starts_with("ocean_double_sigma"))) {
      throw Error(ErrorKind::invalid_input,
                  "terrain-following (s) vertical coordinate ('" + variable.name + "', " +
                      standard_name +
                      "); expected levels of fixed depth; interpolate it to depths first");
    }
  }
}

LevelAxis levels_of(const netcdf::File& file, const BoundVariable& bound, const Product& product,
                    std::vector<std::string>& warnings) {
  const Quantity& quantity = *bound.quantity;
  const netcdf::Variable& data = *bound.variable;
  LevelAxis axis;
  if (quantity.realm == Realm::surface) {
    if (bound.vertical.dimension && data.shape[*bound.vertical.dimension] > 1) {
      refuse_axis(data, quantity.standard_name + " comes on " +
                            std::to_string(data.shape[*bound.vertical.dimension]) +
                            " levels; expected none or one");
    }
    return axis;
  }
  const bool air = quantity.realm == Realm::air;
  axis.kind = air ? VerticalKind::height_m : VerticalKind::depth_m;
  const Alias* alias = quantity.alias(data.name);
  const bool one_level = !bound.vertical.dimension || data.shape[*bound.vertical.dimension] == 1;
  if (air && one_level && alias != nullptr && alias->height_m) {
    axis.order = level_axis({*alias->height_m});
    return axis;
  }
  if (bound.vertical.coordinate == nullptr) {
    const std::optional<double> assumed = air ? quantity.height_m : product.current_depth_m;
    if (!assumed) {
      refuse_axis(data,
                  std::string("has no ") + (air ? "height" : "depth") +
                      ", neither an axis nor a scalar coordinate, and product '" + product.id +
                      "' does not give it; expected metres below the surface; download it with "
                      "its depth" +
                      say_so);
    }
    axis.order = level_axis({*assumed});
    return axis;
  }
  const netcdf::Variable& coordinate = *bound.vertical.coordinate;
  const std::string standard_name = product.attribute(coordinate, "standard_name").value_or("");
  const std::string name = lower_case(coordinate.name);
  std::string positive = lower_case(product.attribute(coordinate, "positive").value_or(""));
  std::vector<double> metres = coordinate_values(file, coordinate, product, "m");
  if (positive.empty()) {
    const bool down = standard_name == "depth" || name.starts_with("dep");
    const bool up = is_one_of(standard_name, {"height", "altitude"}) ||
                    name.starts_with("height") || name == "elevation";
    if (!down && !up) {
      refuse_axis(
          coordinate,
          std::string("says neither 'positive' nor a standard name; expected positive: up or "
                      "down") +
              say_so);
    }
    positive = up ? "up" : "down";
    if (down && std::all_of(metres.begin(), metres.end(), [](double z) { return z <= 0; }) &&
        std::any_of(metres.begin(), metres.end(), [](double z) { return z < 0; })) {
      warnings.push_back("axis '" + coordinate.name +
                         "' has negative depths; read as heights, positive up");
      positive = "up";
    }
  }
  if (positive != "up" && positive != "down")
    refuse_axis(coordinate, "positive is '" + positive + "'; expected up or down");
  if ((positive == "up") != air) {
    for (double& z : metres) z = z == 0.0 ? 0.0 : -z;
  }
  axis.order = level_axis(metres);
  if (axis.order.values.front() < (air ? 0.0 : -1.0)) {
    refuse_axis(coordinate,
                std::string(air ? "heights" : "depths") + " start at " +
                    std::to_string(axis.order.values.front()) +
                    " m, on the wrong side of the sea surface; expected `positive` to tell "
                    "which way they count");
  }
  return axis;
}

std::vector<double> coordinate_values(const netcdf::File& file, const netcdf::Variable& coordinate,
                                      const Product& product, std::string_view unit) {
  if (coordinate.size() > longest_axis) {
    refuse_axis(coordinate, "an axis of " + std::to_string(coordinate.size()) +
                                " places; expected at most " + std::to_string(longest_axis));
  }
  std::vector<std::string> ignored;
  Packing packing = Packing::of(coordinate, ignored);
  if (!unit.empty()) {
    const auto found = product.attribute(coordinate, "units");
    if (!found) {
      refuse_axis(coordinate, "has no units, and product '" + product.id +
                                  "' does not give them; expected '" + std::string(unit) + "'" +
                                  say_so);
    }
    const std::string what = "axis '" + coordinate.name + "'";
    const bool geographic =
        unit == "degree" && kind_from_units(lower_case(*found)) != AxisKind::other;
    if (!geographic) packing.convert(unit_conversion(*found, unit, what));
  }
  std::vector<double> values = file.read_all(coordinate);
  for (double& value : values) value = packing.coordinate(value);
  return values;
}

}  // namespace slackwater::ingest
