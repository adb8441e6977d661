#include "ingest/gridded_plan.h"

#include <algorithm>
#include <set>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/cf/axes.h"
#include "ingest/cf/cell_methods.h"
#include "ingest/cf/settle.h"
#include "ingest/cf/time_cells.h"
#include "ingest/cf/units.h"

namespace slackwater::ingest {
namespace {

/// Announced values per byte of the file: deflate packs at most 1032 to 1, and a float has 4 bytes.
constexpr double most_values_per_byte = 4000.0;
constexpr std::size_t most_values = std::size_t{1} << 32;
constexpr std::size_t largest_packed_chunk = std::size_t{32} << 20;  // values
constexpr const char* stokes_x = "sea_surface_wave_stokes_drift_x_velocity";
constexpr const char* stokes_y = "sea_surface_wave_stokes_drift_y_velocity";

struct Candidate {
  const netcdf::Variable* variable = nullptr;
  const Quantity* quantity = nullptr;
};

/// A variable with its axes read and cut.
struct Located {
  BoundVariable bound;
  Grid grid;
  LevelAxis levels;
  AxisOrder rows;
  AxisOrder columns;
};

[[noreturn]] void refuse_nothing_wanted(const netcdf::File& file, const Product& product) {
  refuse_terrain_following(file);
  std::string found;
  int named = 0;
  for (const netcdf::Variable& variable : file.variables()) {
    if (variable.dimensions.size() < 2 || ++named > 8) continue;
    found += (found.empty() ? "" : ", ") + variable.name;
    if (const auto standard_name = variable.text("standard_name"))
      found += " (" + *standard_name + ")";
  }
  throw Error(ErrorKind::invalid_input,
              "no velocity, wave or wind variable; found " +
                  (found.empty() ? std::string("no gridded variable") : found) +
                  "; expected e.g. eastward_sea_water_velocity or a short name that product '" +
                  product.id + "' knows; leave the file out");
}

/// The quantity of a variable, also under a modifier of its standard name ("eastward_wind
/// standard_error"), so that it can be named.
const Quantity* quantity_meant(const netcdf::Variable& variable, const ProductCatalogue& products,
                               const Product& product) {
  if (const Quantity* quantity = products.quantity_of(variable, product)) return quantity;
  const std::string name = product.attribute(variable, "standard_name").value_or("");
  const std::size_t blank = name.find(' ');
  return blank == std::string::npos ? nullptr
                                    : products.vocabulary().by_standard_name(name.substr(0, blank));
}

std::vector<Candidate> wanted(const netcdf::File& file, const ProductCatalogue& products,
                              const Product& product, std::vector<std::string>& warnings) {
  std::vector<Candidate> candidates;
  std::string left_out;
  std::size_t left = 0;
  for (const netcdf::Variable& variable : file.variables()) {
    if (!variable.has_numbers() || variable.dimensions.empty()) continue;
    // A coordinate variable is no data, whatever its name.
    if (variable.dimensions.size() == 1 && variable.dimensions[0] == variable.name) continue;
    const Quantity* quantity = quantity_meant(variable, products, product);
    if (quantity == nullptr) continue;
    // What a descriptor names by this very short name, it vouches for.
    const auto statistic = product.variables.contains(variable.name)
                               ? std::nullopt
                               : statistic_in(variable, *quantity);
    if (!statistic) {
      candidates.push_back({&variable, quantity});
    } else {
      ++left;
      left_out += (left_out.empty() ? "'" : ", '") + variable.name + "' (" +
                  quantity->standard_name + "): " + *statistic;
    }
  }
  if (candidates.empty() && left > 0) {
    throw Error(ErrorKind::invalid_input,
                "found statistics of the quantity, not the quantity itself: " + left_out +
                    "; expected instants or means, of one run or over the members of an ensemble: "
                    "fetch those instead");
  }
  if (left > 0) {
    warnings.push_back("left out " + std::to_string(left) +
                       (left == 1 ? " variable that is a statistic"
                                  : " variables that are "
                                    "statistics") +
                       ", not the quantity itself: " + left_out);
  }
  if (candidates.empty()) refuse_nothing_wanted(file, product);
  return candidates;
}

/// Where in the vocabulary's list of short names this one stands: smaller is preferred.
std::size_t preference(const Candidate& candidate) {
  const auto& aliases = candidate.quantity->aliases;
  const auto found = std::find_if(aliases.begin(), aliases.end(), [&](const Alias& alias) {
    return alias.name == candidate.variable->name;
  });
  return static_cast<std::size_t>(found - aliases.begin());
}

void expect_believable_size(const netcdf::File& file, const Located& located) {
  const netcdf::Variable& variable = *located.bound.variable;
  std::size_t values = 1;
  for (const std::size_t n :
       {located.grid.times(), located.grid.levels(), located.grid.rows(), located.grid.columns()}) {
    if (__builtin_mul_overflow(values, n, &values)) values = most_values + 1;
  }
  const auto bytes = static_cast<double>(std::filesystem::file_size(file.path()));
  if (values > most_values || static_cast<double>(values) > most_values_per_byte * bytes + 1e6) {
    throw Error(ErrorKind::invalid_input,
                "variable '" + variable.name + "' announces " + std::to_string(values) +
                    " values in a file of " + std::to_string(static_cast<std::size_t>(bytes)) +
                    " bytes; expected a whole file, or give --bbox or --site");
  }
  std::size_t chunk = variable.compressed ? 1 : 0;
  for (const std::size_t n : variable.chunks) {
    if (__builtin_mul_overflow(chunk, n, &chunk)) chunk = largest_packed_chunk + 1;
  }
  if (chunk > largest_packed_chunk) {
    throw Error(ErrorKind::invalid_input,
                "variable '" + variable.name + "' is compressed in chunks of " +
                    std::to_string(chunk) + " values; expected at most " +
                    std::to_string(largest_packed_chunk) + "; rechunk it (nccopy -c)");
  }
}

Located locate(const netcdf::File& file, const Candidate& candidate, const Product& product,
               const IngestOptions& options, std::vector<std::string>& warnings) {
  Located located;
  located.bound = bind_axes(file, *candidate.variable, *candidate.quantity, product);
  const BoundVariable& bound = located.bound;
  located.levels = levels_of(file, bound, product, warnings);
  located.rows = latitude_axis(
      coordinate_values(file, *bound.latitude.coordinate, product, "degree"), options.cut);
  located.columns = longitude_axis(
      coordinate_values(file, *bound.longitude.coordinate, product, "degree"), options.cut);
  if (bound.time.coordinate != nullptr) {
    located.grid.time =
        time_cells(file, *bound.time.coordinate, *bound.variable, product, warnings);
  }
  located.grid.vertical = located.levels.kind;
  located.grid.levels_m = located.levels.order.values;
  located.grid.latitude_deg = located.rows.values;
  located.grid.longitude_deg = located.columns.values;
  expect_believable_size(file, located);
  return located;
}

Packing packing_of(const Located& located, const Product& product,
                   std::vector<std::string>& warnings) {
  const netcdf::Variable& variable = *located.bound.variable;
  const Quantity& quantity = *located.bound.quantity;
  Packing packing = Packing::of(variable, warnings);
  const auto unit = product.attribute(variable, "units");
  if (!unit && quantity.unit != "1") {
    throw Error(ErrorKind::invalid_input,
                "variable '" + variable.name + "' (" + quantity.standard_name +
                    ") has no units, and product '" + product.id +
                    "' does not give them; expected '" + quantity.unit + "'" + say_so);
  }
  if (unit)
    packing.convert(unit_conversion(*unit, quantity.unit, "variable '" + variable.name + "'"));
  packing.set_gross_range(quantity.gross);
  if (quantity.standard_name == "sea_floor_depth_below_geoid") {
    const std::string standard_name = product.attribute(variable, "standard_name").value_or("");
    const std::string positive = lower_case(product.attribute(variable, "positive").value_or(""));
    const bool up = positive == "up" || standard_name.find("height") != std::string::npos ||
                    variable.name == "elevation";
    if (up) packing.negate();
    packing.keep_only_positive();
  }
  return packing;
}

/// Raw values of a few times and levels in the middle of the cut.
std::vector<double> some_raw(const netcdf::File& file, const Located& located) {
  constexpr std::size_t most_levels = 8;
  constexpr std::size_t most_cells = 64;  // along one axis
  const BoundVariable& bound = located.bound;
  const netcdf::Variable& variable = *bound.variable;
  std::vector<std::size_t> start(variable.shape.size(), 0);
  std::vector<std::size_t> count(variable.shape.size(), 1);
  const auto middle = [&](const BoundAxis& axis, const AxisOrder& order, std::size_t most) {
    if (!axis.dimension || order.source.empty()) return;
    const auto [low, high] = std::minmax_element(order.source.begin(), order.source.end());
    const std::size_t n = *high - *low + 1;
    count[*axis.dimension] = std::min(n, most);
    start[*axis.dimension] = *low + (n - count[*axis.dimension]) / 2;
  };
  middle(bound.latitude, located.rows, most_cells);
  middle(bound.longitude, located.columns, most_cells);
  if (bound.vertical.dimension && !located.levels.order.source.empty())
    count[*bound.vertical.dimension] =
        std::min(variable.shape[*bound.vertical.dimension], most_levels);
  std::size_t size = 1;
  for (const std::size_t n : count) size *= n;
  std::vector<double> all;
  std::vector<double> piece(size);
  const std::size_t times = bound.time.dimension ? variable.shape[*bound.time.dimension] : 1;
  for (const std::size_t t : std::set<std::size_t>{0, times / 2, times - 1}) {
    if (bound.time.dimension) start[*bound.time.dimension] = t;
    file.read(variable, start, count, std::span<double>(piece));
    all.insert(all.end(), piece.begin(), piece.end());
  }
  return all;
}

std::unique_ptr<GriddedSource> source_of(const netcdf::File& file, const Located& located,
                                         const Product& product,
                                         std::vector<std::string>& warnings) {
  Packing packing = packing_of(located, product, warnings);
  if (packing.has_two_readings())
    packing.settle_limits(some_raw(file, located), located.bound.variable->name, warnings);
  return std::make_unique<GriddedSource>(file, located.bound, located.levels.order, located.rows,
                                         located.columns, packing);
}

/// The Stokes drift to take off a current that holds it, where the file has it at the same places
/// and times.
const Located* stokes_for(const Located& current, const std::vector<Located>& all) {
  const bool east = current.bound.quantity->standard_name == "eastward_sea_water_velocity";
  for (const Located& other : all) {
    if (other.bound.quantity->standard_name != (east ? stokes_x : stokes_y)) continue;
    if (other.grid.time == current.grid.time &&
        other.grid.latitude_deg == current.grid.latitude_deg &&
        other.grid.longitude_deg == current.grid.longitude_deg && current.grid.levels() == 1) {
      return &other;
    }
  }
  return nullptr;
}

bool holds_stokes(const netcdf::Variable& variable, const Product& product) {
  const auto& names = product.contains_stokes;
  return std::find(names.begin(), names.end(), variable.name) != names.end();
}

}  // namespace

std::vector<PlannedGroup> plan_gridded(const netcdf::File& file, const ProductCatalogue& products,
                                       const Product& product, const IngestOptions& options,
                                       std::vector<std::string>& warnings) {
  std::vector<Candidate> candidates = wanted(file, products, product, warnings);
  refuse_terrain_following(file);
  std::stable_sort(
      candidates.begin(), candidates.end(),
      [](const Candidate& a, const Candidate& b) { return preference(a) < preference(b); });
  std::vector<Located> all;
  all.reserve(candidates.size());
  for (const Candidate& candidate : candidates)
    all.push_back(locate(file, candidate, product, options, warnings));

  std::vector<PlannedGroup> groups;
  for (const Located& located : all) {
    const netcdf::Variable& variable = *located.bound.variable;
    const Quantity& quantity = *located.bound.quantity;
    const bool of_members = is_mean_of_members(variable);
    auto group = std::find_if(groups.begin(), groups.end(), [&](const PlannedGroup& g) {
      return g.grid == located.grid && g.is_ensemble_mean == of_members;
    });
    if (group == groups.end())
      group = groups.insert(groups.end(), PlannedGroup{located.grid, of_members, {}});
    const auto twin = std::find_if(group->variables.begin(), group->variables.end(),
                                   [&](const PlannedVariable& v) {
                                     return v.description.standard_name == quantity.standard_name;
                                   });
    if (twin != group->variables.end()) {
      warnings.push_back("'" + variable.name + "' is left out: '" + twin->description.source_name +
                         "' is the same quantity");
      continue;
    }
    PlannedVariable planned;
    planned.description = {quantity.standard_name, quantity.unit, variable.name, false, false};
    if (quantity.standard_name.ends_with("ward_sea_water_velocity") ||
        quantity.standard_name == "sea_surface_height_above_geoid")
      planned.description.has_tide = product.tide_of(variable.name);
    planned.source = source_of(file, located, product, warnings);
    if (holds_stokes(variable, product)) {
      if (const Located* stokes = stokes_for(located, all)) {
        planned.stokes = source_of(file, *stokes, product, warnings);
        warnings.push_back("'" + variable.name + "': Stokes drift '" +
                           stokes->bound.variable->name + "' subtracted");
      } else {
        planned.description.contains_stokes = true;
        warnings.push_back("'" + variable.name +
                           "' contains Stokes drift, and the file holds none to subtract");
      }
    }
    group->variables.push_back(std::move(planned));
  }
  return groups;
}

}  // namespace slackwater::ingest
