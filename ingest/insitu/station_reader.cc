#include "ingest/insitu/station_reader.h"

#include <algorithm>
#include <cmath>

#include "fields/base/error.h"
#include "ingest/cf/cell_methods.h"
#include "ingest/insitu/standard_error.h"
#include "ingest/insitu/vector_pair.h"
#include "ingest/quality/spike.h"

namespace slackwater::ingest {
namespace {

/// A surface quantity that stands in one of several levels of a file: the level with the most
/// values.
void collapse_to_fullest_level(SeriesValues& series) {
  if (series.levels == 1) return;
  std::size_t best = 0;
  std::size_t most = 0;
  for (std::size_t k = 0; k < series.levels; ++k) {
    std::size_t values = 0;
    for (std::size_t t = 0; t < series.times; ++t)
      values += std::isnan(series.values[series.at(t, k)]) ? 0 : 1;
    if (values > most) {
      most = values;
      best = k;
    }
  }
  for (std::size_t t = 0; t < series.times; ++t) {
    series.values[t] = series.values[series.at(t, best)];
    series.status[t] = series.status[series.at(t, best)];
  }
  series.values.resize(series.times);
  series.status.resize(series.times);
  series.levels = 1;
}

std::string level_dimension_of(const netcdf::Variable& variable,
                               const SeriesDimensions& dimensions) {
  return dimensions.level ? variable.dimensions[*dimensions.level] : std::string();
}

/// Reads what is wanted at one station and makes vectors of speeds and directions.
class StationReader {
 public:
  StationReader(const netcdf::File& file, const StationAxes& axes, const ProductCatalogue& products,
                std::size_t station, std::vector<std::string>& warnings)
      : file_(file), axes_(axes), products_(products), station_(station), warnings_(warnings) {}

  std::vector<PlacedSeries> read(const std::vector<Wanted>& wanted,
                                 const std::optional<double>& water_depth_m) {
    for (const Wanted& one : wanted) {
      const bool of_vector =
          is_vector_speed(one.standard_name) || is_vector_direction(one.standard_name);
      if (one.quantity == nullptr || of_vector) continue;
      SeriesValues series = series_of(one, one.quantity->unit);
      describe(series, *one.quantity);
      place(std::move(series), water_depth_m, one.quantity->height_m);
    }
    for (const Wanted& speed : wanted) {
      if (is_vector_speed(speed.standard_name)) add_vector(speed, wanted, water_depth_m);
    }
    return std::move(placed_);
  }

 private:
  /// A quantity may stand in several variables, each at a level of its own.
  [[nodiscard]] bool taken(std::string_view standard_name, const SeriesLevels& levels) const {
    return std::any_of(placed_.begin(), placed_.end(), [&](const PlacedSeries& one) {
      return one.series.standard_name == standard_name && one.levels.kind == levels.kind &&
             one.levels.levels_m == levels.levels_m;
    });
  }
  [[nodiscard]] bool taken(std::string_view standard_name) const {
    return std::any_of(placed_.begin(), placed_.end(), [&](const PlacedSeries& one) {
      return one.series.standard_name == standard_name;
    });
  }

  void leave_out(const SeriesValues& series) {
    warnings_.push_back("'" + series.source_name + "' is a second " + series.standard_name +
                        " and is left out");
  }

  SeriesValues series_of(const Wanted& wanted, const std::string& unit) {
    const SeriesDimensions dimensions =
        dimensions_of(*wanted.variable, axes_.time_dimension, axes_.station_dimension);
    SeriesValues series =
        read_series(file_, *wanted.variable, dimensions, station_, unit, warnings_);
    series.standard_name = wanted.standard_name;
    series.standard_error =
        standard_error_of(file_, *wanted.variable, axes_, station_, unit, warnings_);
    return series;
  }

  static void describe(SeriesValues& series, const Quantity& quantity) {
    series.standard_name = quantity.standard_name;
    series.unit = quantity.unit;
    series.realm = quantity.realm;
    series.gross = quantity.gross;
    series.spike = quantity.spike ? quantity.spike : spike_threshold_of(quantity.standard_name);
  }

  void place(SeriesValues series, const std::optional<double>& water_depth_m,
             const std::optional<double>& default_height_m) {
    const SeriesDimensions dimensions =
        dimensions_of(*series.variable, axes_.time_dimension, axes_.station_dimension);
    if (series.realm == Realm::surface) collapse_to_fullest_level(series);
    if (std::all_of(series.values.begin(), series.values.end(),
                    [](float v) { return std::isnan(v); })) {
      warnings_.push_back("'" + series.source_name + "' has no value at all and is left out");
      return;
    }
    SeriesLevels levels;
    try {
      levels =
          levels_of_series(file_, axes_, series, level_dimension_of(*series.variable, dimensions),
                           station_, water_depth_m, default_height_m, warnings_);
    } catch (const Error&) {
      // What cannot be placed is no reason to refuse the same quantity that could be.
      if (!taken(series.standard_name)) throw;
      return leave_out(series);
    }
    if (taken(series.standard_name, levels)) return leave_out(series);
    placed_.push_back({std::move(series), std::move(levels)});
  }

  /// Components of a speed and its direction, unless the file gives components too. The speed
  /// itself is kept where it says more: where a direction is missing. A direction alone is not
  /// kept.
  void add_vector(const Wanted& speed, const std::vector<Wanted>& wanted,
                  const std::optional<double>& water_depth_m) {
    SeriesValues speeds = series_of(speed, "m s-1");
    bool keep_speed = true;
    if (const Wanted* direction = direction_of(speed, wanted)) {
      const VectorPair* pair = vector_pair_of(speed.standard_name, direction->standard_name);
      if (is_given(pair->eastward, wanted)) return;
      const Quantity* east = products_.vocabulary().by_standard_name(pair->eastward);
      const Quantity* north = products_.vocabulary().by_standard_name(pair->northward);
      if (east != nullptr && north != nullptr) {
        Components components = components_of(*pair, speeds, series_of(*direction, "degree"));
        keep_speed = false;
        for (std::size_t i = 0; i < speeds.values.size(); ++i) {
          keep_speed |= has_value(speeds.status[i]) && std::isnan(components.east.values[i]);
        }
        describe(components.east, *east);
        describe(components.north, *north);
        place(std::move(components.east), water_depth_m, east->height_m);
        place(std::move(components.north), water_depth_m, north->height_m);
      }
    }
    if (!keep_speed) return;
    if (speed.quantity == nullptr) {
      warnings_.push_back("'" + speed.variable->name +
                          "' is a speed without a direction and is left out");
      return;
    }
    describe(speeds, *speed.quantity);
    place(std::move(speeds), water_depth_m, speed.quantity->height_m);
  }

  /// The direction of a speed: of those over the same dimensions the one with the same coordinates
  /// (sensors at several depths each have theirs), else the first.
  static const Wanted* direction_of(const Wanted& speed, const std::vector<Wanted>& wanted) {
    const Wanted* found = nullptr;
    for (const Wanted& direction : wanted) {
      if (vector_pair_of(speed.standard_name, direction.standard_name) == nullptr ||
          direction.variable->dimensions != speed.variable->dimensions) {
        continue;
      }
      const bool beside =
          direction.variable->text("coordinates") == speed.variable->text("coordinates") &&
          direction.variable->number("sensor_depth") == speed.variable->number("sensor_depth");
      if (beside) return &direction;
      if (found == nullptr) found = &direction;
    }
    return found;
  }

  /// Whether the file itself gives this component.
  static bool is_given(std::string_view component, const std::vector<Wanted>& wanted) {
    return std::any_of(wanted.begin(), wanted.end(),
                       [&](const Wanted& one) { return one.standard_name == component; });
  }

  const netcdf::File& file_;
  const StationAxes& axes_;
  const ProductCatalogue& products_;
  std::size_t station_;
  std::vector<std::string>& warnings_;
  std::vector<PlacedSeries> placed_;
};

}  // namespace

std::vector<Wanted> wanted_in(const netcdf::File& file, const StationAxes& axes,
                              const ProductCatalogue& products, const Product& product,
                              std::vector<std::string>& left_out) {
  std::vector<Wanted> wanted;
  for (const netcdf::Variable& variable : file.variables()) {
    if (variable.type == netcdf::Type::character || variable.type == netcdf::Type::string) continue;
    const bool over_time = axes.time_dimension.empty() ||
                           std::find(variable.dimensions.begin(), variable.dimensions.end(),
                                     axes.time_dimension) != variable.dimensions.end();
    std::string name = variable.text("standard_name").value_or("");
    // A variable may be called what it is, and say no more.
    const bool is_called_so =
        name.empty() && (products.vocabulary().by_standard_name(variable.name) != nullptr ||
                         is_vector_direction(variable.name));
    if (is_called_so) name = variable.name;
    if (!over_time || &variable == axes.time || &variable == axes.latitude ||
        &variable == axes.longitude || name.find("status_flag") != std::string::npos) {
      continue;
    }
    if (is_vector_speed(name) || is_vector_direction(name)) {
      wanted.push_back({&variable, name, products.vocabulary().by_standard_name(name)});
    } else if (const Quantity* quantity = is_called_so
                                              ? products.vocabulary().by_standard_name(name)
                                              : products.quantity_of(variable, product)) {
      wanted.push_back({&variable, quantity->standard_name, quantity});
    }
  }
  std::erase_if(wanted, [&](const Wanted& found) {
    if (product.variables.contains(found.variable->name)) return false;
    const auto statistic =
        statistic_in(*found.variable, found.quantity == nullptr ? Quantity{} : *found.quantity);
    if (!statistic) return false;
    left_out.push_back("'" + found.variable->name + "': " + *statistic);
    return true;
  });
  return wanted;
}

std::vector<PlacedSeries> read_station(const netcdf::File& file, const StationAxes& axes,
                                       const ProductCatalogue& products,
                                       const std::vector<Wanted>& wanted, std::size_t station,
                                       const std::optional<double>& water_depth_m,
                                       std::vector<std::string>& warnings) {
  return StationReader(file, axes, products, station, warnings).read(wanted, water_depth_m);
}

}  // namespace slackwater::ingest
