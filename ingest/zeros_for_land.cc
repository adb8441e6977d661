#include "ingest/zeros_for_land.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string_view>

namespace slackwater::ingest {
namespace {

constexpr std::size_t block_values = std::size_t{1} << 20;
constexpr std::size_t most_times = 6;
constexpr std::size_t enough_times = 3;  ///< no value is exactly 0 so often by chance

/// Variables that tell land together, and those that follow.
struct ZeroSet {
  std::vector<PlannedVariable*> telling;
  std::vector<PlannedVariable*> all;
};

bool is_wave(std::string_view name) {
  return name.starts_with("sea_surface_") && name.find("wave") != std::string_view::npos;
}

std::vector<ZeroSet> sets_of(PlannedGroup& group) {
  std::vector<ZeroSet> sets(3);
  for (PlannedVariable& variable : group.variables) {
    const std::string& name = variable.description.standard_name;
    const auto add = [&](ZeroSet& set, bool tells) {
      set.all.push_back(&variable);
      if (tells) set.telling.push_back(&variable);
    };
    if (name.ends_with("ward_sea_water_velocity")) add(sets[0], true);
    if (name == "eastward_wind" || name == "northward_wind") add(sets[1], true);
    if (is_wave(name)) add(sets[2], name == "sea_surface_wave_significant_height");
  }
  std::erase_if(sets, [](const ZeroSet& set) { return set.telling.empty(); });
  return sets;
}

std::vector<std::size_t> spread_times(std::size_t times) {
  std::set<std::size_t> chosen;
  const std::size_t n = std::min(times, most_times);
  for (std::size_t i = 0; i < n; ++i) chosen.insert(n == 1 ? 0 : i * (times - 1) / (n - 1));
  return {chosen.begin(), chosen.end()};
}

/// Keeps in `zeros` the cells that are 0 at one time; false where a value is missing, or no zero is
/// left.
bool narrow(PlannedVariable& variable, const Grid& grid, std::size_t time,
            std::vector<bool>& zeros) {
  const std::size_t row_values = grid.levels() * grid.columns();
  const std::size_t rows_at_once =
      std::clamp<std::size_t>(block_values / row_values, 1, grid.rows());
  std::vector<float> values;
  DecodeCounts ignored;
  bool any = false;
  for (std::size_t first = 0; first < grid.rows(); first += rows_at_once) {
    const std::size_t rows = std::min(rows_at_once, grid.rows() - first);
    values.resize(rows * row_values);
    variable.source->read(time, 1, first, rows, values, ignored);
    std::size_t n = 0;
    for (std::size_t k = 0; k < grid.levels(); ++k) {
      std::size_t cell = (k * grid.rows() + first) * grid.columns();
      for (std::size_t i = 0; i < rows * grid.columns(); ++i, ++n, ++cell) {
        if (std::isnan(values[n])) return false;
        const bool still = zeros[cell] && values[n] == 0.0F;
        zeros[cell] = still;
        any |= still;
      }
    }
  }
  return any;
}

bool has_area(const Grid& grid, const std::vector<bool>& zeros) {
  for (std::size_t k = 0; k < grid.levels(); ++k) {
    for (std::size_t j = 0; j + 1 < grid.rows(); ++j) {
      for (std::size_t i = 0; i + 1 < grid.columns(); ++i) {
        const std::size_t cell = (k * grid.rows() + j) * grid.columns() + i;
        if (zeros[cell] && zeros[cell + 1] && zeros[cell + grid.columns()] &&
            zeros[cell + grid.columns() + 1])
          return true;
      }
    }
  }
  return false;
}

std::string names_of(const std::vector<PlannedVariable*>& variables) {
  std::string names;
  for (const PlannedVariable* variable : variables)
    names += (names.empty() ? "'" : ", '") + variable->description.source_name + "'";
  return names;
}

}  // namespace

void mark_zeros_for_land(PlannedGroup& group, std::vector<std::string>& warnings) {
  const Grid& grid = group.grid;
  if (grid.time.empty()) return;
  const std::vector<std::size_t> times = spread_times(grid.times());
  for (ZeroSet& set : sets_of(group)) {
    std::vector<bool> zeros(grid.levels() * grid.rows() * grid.columns(), true);
    const bool has_zeros = std::all_of(times.begin(), times.end(), [&](std::size_t time) {
      return std::all_of(set.telling.begin(), set.telling.end(), [&](PlannedVariable* variable) {
        return narrow(*variable, grid, time, zeros);
      });
    });
    if (!has_zeros || (times.size() < enough_times && !has_area(grid, zeros))) continue;
    const auto n = static_cast<std::size_t>(std::count(zeros.begin(), zeros.end(), true));
    if (n == zeros.size()) {
      warnings.push_back(names_of(set.telling) +
                         ": exactly 0 everywhere at every time that was looked at; check the file: "
                         "it reads as calm");
      continue;
    }
    warnings.push_back(names_of(set.telling) + ": exactly 0 at every time that was looked at in " +
                       std::to_string(n) + " of " + std::to_string(zeros.size()) +
                       " cells, and no value is missing; those zeros are taken as missing (land, "
                       "or below the bed), not as calm");
    for (PlannedVariable* variable : set.all) variable->no_values = zeros;
  }
}

void take_zeros_out(std::vector<float>& values, const std::vector<bool>& no_values,
                    const Grid& grid, std::size_t first_row, std::size_t rows,
                    DecodeCounts& counts) {
  if (no_values.empty()) return;
  const std::size_t cells = rows * grid.columns();
  for (std::size_t n = 0; n < values.size(); ++n) {
    const std::size_t level = n / cells % grid.levels();
    const std::size_t cell = (level * grid.rows() + first_row) * grid.columns() + n % cells;
    if (values[n] != 0.0F || !no_values[cell]) continue;
    values[n] = std::numeric_limits<float>::quiet_NaN();
    --counts.values;
    ++counts.missing;
  }
}

}  // namespace slackwater::ingest
