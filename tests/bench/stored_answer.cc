#include "tests/bench/stored_answer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <vector>

#include "data/store/store.h"
#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "ingest/cf/granule_file.h"
#include "ingest/netcdf/file.h"

namespace slackwater::bench {
namespace {

constexpr const char* names[] = {"eastward_sea_water_velocity", "northward_sea_water_velocity"};

bool same(float a, float b) {
  return (std::isnan(a) && std::isnan(b)) ||
         std::bit_cast<unsigned>(a) == std::bit_cast<unsigned>(b);
}

std::string difference(const char* name, std::size_t t, std::size_t k, std::size_t j, std::size_t i,
                       float stored, float given) {
  char text[200];
  std::snprintf(text, sizeof text,
                "%s at time %zu, level %zu, row %zu, column %zu: %g, expected %g", name, t, k, j, i,
                static_cast<double>(stored), static_cast<double>(given));
  return text;
}

std::string count_text(std::size_t compared, std::size_t present) {
  return std::to_string(compared) + " stored values compared, " + std::to_string(present) +
         " of them not missing";
}

/// Opens the one granule that holds both components.
ingest::GranuleFile only_granule(const std::filesystem::path& folder) {
  store::Store store = store::Store::open(folder, store::OpenMode::read_only);
  const auto rows = store.find_granules({});
  if (rows.size() != 1) {
    throw Error(ErrorKind::invalid_input,
                "found " + std::to_string(rows.size()) + " granules, expected one");
  }
  return ingest::GranuleFile::open(store.content_path(rows.front().content_sha256));
}

}  // namespace

StoredAnswer compare_with(const std::filesystem::path& store, const BigProductFile& file) {
  const ingest::GranuleFile stored = only_granule(store);
  const Grid& grid = stored.granule().grid;
  const BigProductFile::Shape& shape = file.shape();
  if (grid.times() != shape.times || grid.levels() != shape.levels) {
    return {false, "the times or levels are not those of the file"};
  }
  // Where the cut begins in the file: whole 32nds of a degree.
  const auto first_row = static_cast<std::size_t>(
      std::lround((grid.latitude_deg.front() - file.latitude_deg(0)) * 32));
  const auto first_column = static_cast<std::size_t>(
      std::lround((grid.longitude_deg.front() - file.longitude_deg(0)) * 32));
  Rng rng(11, "bench/stored_answer");
  const auto any = [&](std::size_t n) {
    return std::min(n - 1, static_cast<std::size_t>(rng.uniform() * static_cast<double>(n)));
  };
  std::size_t compared = 0;
  std::size_t present = 0;
  for (int line = 0; line < 200; ++line) {
    const std::size_t t = any(grid.times());
    const std::size_t j = any(grid.rows());
    const std::size_t c = any(2);
    if (grid.time[t].centre() != file.time(t) ||
        grid.latitude_deg[j] != BigProductFile::latitude_deg(first_row + j)) {
      return {false, "a time or a latitude is not that of the file"};
    }
    const GriddedField field = stored.read(names[c], t, 1, j, 1, 0, grid.columns());
    for (std::size_t k = 0; k < grid.levels(); ++k) {
      for (std::size_t i = 0; i < grid.columns(); ++i) {
        const float found = field.values[k * grid.columns() + i];
        const float given = file.value(c, t, k, first_row + j, first_column + i);
        if (!same(found, given)) return {false, difference(names[c], t, k, j, i, found, given)};
        ++compared;
        present += std::isnan(given) ? 0 : 1;
      }
    }
  }
  return {present > 0, count_text(compared, present)};
}

StoredAnswer compare_with_netcdf(const std::filesystem::path& store,
                                 const std::filesystem::path& product) {
  const ingest::GranuleFile stored = only_granule(store);
  const Grid& grid = stored.granule().grid;
  const ingest::netcdf::File file = ingest::netcdf::File::open(product);
  std::size_t compared = 0;
  std::size_t present = 0;
  for (std::size_t c = 0; c < 2; ++c) {
    const ingest::netcdf::Variable& variable = *file.find(c == 0 ? "uo" : "vo");
    const std::vector<double> given = file.read_all(variable);
    const double fill = variable.number("_FillValue").value_or(9.969209968386869e36);
    const GriddedField field =
        stored.read(names[c], 0, grid.times(), 0, grid.rows(), 0, grid.columns());
    if (field.values.size() != given.size()) return {false, "another shape than the file's"};
    for (std::size_t n = 0; n < given.size(); ++n) {
      const bool missing = std::isnan(given[n]) || given[n] == fill;
      const float value = missing ? std::nanf("") : static_cast<float>(given[n]);
      if (!same(field.values[n], value)) {
        return {false, difference(names[c], 0, 0, 0, n, field.values[n], value)};
      }
      present += missing ? 0 : 1;
    }
    compared += given.size();
  }
  return {present > 0, count_text(compared, present)};
}

}  // namespace slackwater::bench
