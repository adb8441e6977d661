#include "ingest/grib/grib_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <tuple>

#include "fields/base/error.h"
#include "ingest/cf/granule_file.h"
#include "ingest/copernicus/product.h"
#include "ingest/decoded/staged_files.h"
#include "ingest/grib/inventory.h"

namespace slackwater::ingest {
namespace {

using grib::FieldEntry;
using grib::Inventory;
using grib::MessageFile;
using grib::Parameter;
using grib::RegularGrid;

constexpr std::size_t block_values = 16U << 20U;  ///< 64 MiB of float

/// What separates granules; a run of nothing is the analyses of all runs.
struct GranuleKey {
  std::optional<UtcTime> run;
  std::optional<int> member;
  std::size_t grid = 0;
  bool mean = false;
  bool of_members = false;  ///< the mean over an ensemble's members
  bool at_height = false;
  std::string centre;
  auto operator<=>(const GranuleKey&) const = default;
};

/// A granule as planned: which field of the file stands at each (variable, time, level).
struct Plan {
  Granule granule;
  std::size_t grid = 0;
  std::map<std::tuple<std::size_t, std::size_t, std::size_t>, const FieldEntry*> field_at;
};

std::string describe(const FieldEntry& entry) {
  return std::string(entry.parameter->short_name) +
         (entry.height_m ? " at " + std::to_string(std::lround(*entry.height_m)) + " m"
                         : std::string()) +
         " of " + format_utc(entry.cell.end) + " (run " + format_utc(entry.run) +
         (entry.member ? ", member " + std::to_string(*entry.member) : std::string()) +
         (entry.is_ensemble_mean ? ", mean of the members" : "") + ")";
}

template <typename T>
std::size_t index_in(const std::vector<T>& sorted, const T& value) {
  return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), value) -
                                  sorted.begin());
}

bool earlier(const TimeCell& a, const TimeCell& b) {
  return std::pair(a.end, a.start) < std::pair(b.end, b.start);
}

/// How long after its reference time a run is published: of ECMWF the last step of a run of 00 UTC
/// comes at 07:34 (ECMWF's dissemination schedule); nobody says of others.
Duration published_after(const std::string& centre) {
  using std::chrono::hours;
  using std::chrono::minutes;
  return centre == "ecmf" ? hours(7) + minutes(34) : Duration(0);
}

void apply_status(Granule& granule, const GranuleKey& key, const IngestOptions& options) {
  granule.status = key.run ? DataStatus::forecast : DataStatus::analysis;
  granule.reference_time = key.run;
  if (options.issued && options.as != DataStatus::analysis) {
    granule.status = DataStatus::forecast;
    granule.reference_time = options.issued;
  }
  if (!options.as) return;
  granule.status = *options.as;
  if (*options.as == DataStatus::analysis) granule.reference_time.reset();
  if (*options.as == DataStatus::forecast && !granule.reference_time) {
    throw Error(
        ErrorKind::usage,
        "the file holds analyses, so --as forecast needs the time of issue; add --issued TIME");
  }
}

/// Plans one granule of the fields in `entries`, all of one key and one set of heights.
Plan plan_granule(const GranuleKey& key, const std::vector<const FieldEntry*>& entries,
                  const RegularGrid& grid, const IngestOptions& options) {
  Plan plan;
  plan.grid = key.grid;
  Granule& granule = plan.granule;
  granule.grid.latitude_deg = grid.latitude_deg;
  granule.grid.longitude_deg = grid.longitude_deg;
  granule.grid.vertical = key.at_height ? VerticalKind::height_m : VerticalKind::none;
  granule.ensemble_member = key.member;
  granule.product_id = "NWP_" + key.centre;
  if (key.of_members) granule.dataset_id = ensemble_mean_dataset;
  granule.attribution =
      key.centre == "ecmf"
          ? "Contains data of the European Centre for Medium-Range Weather Forecasts (ECMWF)"
          : "Contains weather model data of the centre '" + key.centre + "'";
  if (!options.issued) granule.published_after = published_after(key.centre);
  if (options.product) {
    granule.product_id = options.product->id;
    granule.attribution = options.product->attribution;
  }
  apply_status(granule, key, options);

  std::vector<TimeCell> times;
  std::set<double> heights;
  std::vector<const Parameter*> parameters;
  for (const FieldEntry* entry : entries) {
    times.push_back(entry->cell);
    if (entry->height_m) heights.insert(*entry->height_m);
    if (std::none_of(parameters.begin(), parameters.end(), [&](auto* p) {
          return p->standard_name == entry->parameter->standard_name;
        })) {
      parameters.push_back(entry->parameter);
    }
  }
  std::sort(times.begin(), times.end(), earlier);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  for (std::size_t t = 1; t < times.size(); ++t) {
    if (times[t].start < times[t - 1].end || times[t].end == times[t - 1].end) {
      throw Error(ErrorKind::invalid_input,
                  "means over overlapping intervals that end at " + format_utc(times[t - 1].end) +
                      " and " + format_utc(times[t].end) +
                      "; expected intervals side by side: keep one kind of mean");
    }
  }
  granule.grid.time = times;
  granule.grid.levels_m.assign(heights.begin(), heights.end());
  std::sort(parameters.begin(), parameters.end(),
            [](auto* a, auto* b) { return a->standard_name < b->standard_name; });
  for (const Parameter* parameter : parameters) {
    GranuleVariable variable;
    variable.standard_name = parameter->standard_name;
    variable.unit = parameter->unit;
    variable.source_name = parameter->short_name;
    granule.variables.push_back(std::move(variable));
  }

  for (const FieldEntry* entry : entries) {
    const auto v = static_cast<std::size_t>(
        std::find_if(granule.variables.begin(), granule.variables.end(),
                     [&](auto& variable) {
                       return variable.standard_name == entry->parameter->standard_name;
                     }) -
        granule.variables.begin());
    const auto t = static_cast<std::size_t>(std::find(times.begin(), times.end(), entry->cell) -
                                            times.begin());
    const std::size_t k = entry->height_m ? index_in(granule.grid.levels_m, *entry->height_m) : 0;
    const auto [place, fresh] = plan.field_at.try_emplace({v, t, k}, entry);
    if (!fresh) {
      throw Error(ErrorKind::invalid_input, describe(*entry) + " is there twice, in " +
                                                grib::name_of(place->second->position) + " and " +
                                                grib::name_of(entry->position) +
                                                "; expected it once: split the file or remove one");
    }
  }
  return plan;
}

/// Half a wind is no wind: both components of each time and height, or neither.
void expect_both_components(const Plan& plan) {
  const auto& variables = plan.granule.variables;
  const auto position = [&](const char* name) {
    return static_cast<std::size_t>(
        std::find_if(variables.begin(), variables.end(),
                     [&](auto& variable) { return variable.standard_name == name; }) -
        variables.begin());
  };
  const std::size_t east = position("eastward_wind");
  const std::size_t north = position("northward_wind");
  for (const auto& [place, entry] : plan.field_at) {
    const auto& [v, t, k] = place;
    if (v != east && v != north) continue;
    if (!plan.field_at.contains({v == east ? north : east, t, k})) {
      throw Error(ErrorKind::invalid_input,
                  describe(*entry) +
                      " has no partner: expected both components of the wind; download " +
                      (v == east ? "the northward one too" : "the eastward one too"));
    }
  }
}

std::vector<Plan> plan_granules(const Inventory& inventory, const IngestOptions& options) {
  std::set<UtcTime> forecast_runs;
  std::set<UtcTime> runs;
  for (const FieldEntry& entry : inventory.fields) {
    runs.insert(entry.run);
    if (entry.cell.end > entry.run) forecast_runs.insert(entry.run);
  }
  if (options.issued && options.as != DataStatus::analysis && forecast_runs.size() > 1) {
    throw Error(ErrorKind::usage, "--issued names one run, the file holds " +
                                      std::to_string(forecast_runs.size()) +
                                      "; leave it out: each run of a GRIB "
                                      "file states its own reference time");
  }

  std::map<GranuleKey, std::vector<const FieldEntry*>> groups;
  for (const FieldEntry& entry : inventory.fields) {
    GranuleKey key;
    if (forecast_runs.contains(entry.run)) key.run = entry.run;
    key.member = entry.member;
    key.grid = entry.grid;
    key.mean = entry.cell.is_mean();
    key.of_members = entry.is_ensemble_mean;
    key.at_height = entry.height_m.has_value();
    key.centre = entry.centre;
    groups[key].push_back(&entry);
  }

  std::vector<Plan> plans;
  for (const auto& [key, entries] : groups) {
    // The components of the wind share their heights; a gust at 10 m alone gets its own granule.
    std::map<std::string_view, std::set<double>> heights_of;
    const auto family = [](const FieldEntry* entry) {
      const std::string_view name = entry->parameter->standard_name;
      return name == "northward_wind" ? std::string_view("eastward_wind") : name;
    };
    for (const FieldEntry* entry : entries) {
      heights_of[family(entry)].insert(entry->height_m.value_or(0));
    }
    std::map<std::set<double>, std::vector<const FieldEntry*>> by_heights;
    for (const FieldEntry* entry : entries) by_heights[heights_of[family(entry)]].push_back(entry);
    for (const auto& [heights, same] : by_heights) {
      plans.push_back(plan_granule(key, same, inventory.grids[key.grid], options));
      expect_both_components(plans.back());
    }
  }
  return plans;
}

/// Writes the content file of one granule; `on_field` hears each field that was unpacked.
void write_granule(MessageFile& file, const Plan& plan, const RegularGrid& grid,
                   const std::filesystem::path& content_file,
                   const std::function<void()>& on_field) {
  const Grid& shape = plan.granule.grid;
  const std::size_t columns = shape.columns();
  GranuleWriter writer(content_file, plan.granule);
  // Whole fields where they fit, since a field is unpacked as a whole; as many times as a chunk
  // holds.
  const std::size_t row_values = shape.levels() * columns;
  const std::size_t rows_at_once =
      std::clamp<std::size_t>(block_values / row_values, 1, shape.rows());
  const std::size_t times_at_once =
      std::clamp<std::size_t>(block_values / (row_values * rows_at_once), 1, writer.block().times);
  std::vector<bool> any_value(plan.granule.variables.size(), false);
  std::vector<float> block;

  const auto fill = [&](std::size_t v, std::size_t t, std::size_t k, std::size_t first_row,
                        std::size_t rows, std::span<float> into) {
    const auto found = plan.field_at.find({v, t, k});
    if (found == plan.field_at.end()) return;
    const std::vector<double> values = file.read(found->second->position).values(grid.ni * grid.nj);
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t i = 0; i < columns; ++i) {
        const double value = values[grid.source(first_row + row, i)];
        into[row * columns + i] = static_cast<float>(value);
        if (!std::isnan(value)) any_value[v] = true;
      }
    }
    if (first_row == 0) on_field();
  };

  for (std::size_t v = 0; v < plan.granule.variables.size(); ++v) {
    for (std::size_t first_time = 0; first_time < shape.times(); first_time += times_at_once) {
      const std::size_t times = std::min(times_at_once, shape.times() - first_time);
      for (std::size_t first_row = 0; first_row < shape.rows(); first_row += rows_at_once) {
        const std::size_t rows = std::min(rows_at_once, shape.rows() - first_row);
        block.assign(times * row_values * rows, std::numeric_limits<float>::quiet_NaN());
        for (std::size_t t = 0; t < times; ++t) {
          for (std::size_t k = 0; k < shape.levels(); ++k) {
            fill(v, first_time + t, k, first_row, rows,
                 std::span(block).subspan((t * shape.levels() + k) * rows * columns,
                                          rows * columns));
          }
        }
        writer.put(v, first_time, times, first_row, rows, block);
      }
    }
  }
  for (std::size_t v = 0; v < any_value.size(); ++v) {
    if (!any_value[v]) {
      throw Error(ErrorKind::invalid_input, plan.granule.variables[v].source_name + " of " +
                                                format_utc(shape.time.front().end) +
                                                " has no value at all: every point is masked; ask "
                                                "for an area where the model has data");
    }
  }
  writer.finish();
}

}  // namespace

bool is_grib(const std::filesystem::path& file) { return grib::begins_as_grib(file); }

Ingested decode_grib(const std::filesystem::path& path, const ProductCatalogue&,
                     const IngestOptions& options, const std::filesystem::path& staging_folder,
                     const Progress& progress) {
  return with_context("reading GRIB file " + path.filename().string(), [&] {
    constexpr double share_of_headers = 0.3;
    MessageFile file(path);
    const double size = static_cast<double>(file.size());
    Inventory inventory = grib::take_inventory(file, options.cut, [&](std::uint64_t offset) {
      if (progress) progress(share_of_headers * static_cast<double>(offset) / size);
    });
    const std::vector<Plan> plans = plan_granules(inventory, options);

    Ingested ingested;
    StagedFiles staged(ingested);
    ingested.warnings = inventory.warnings;
    std::size_t fields_done = 0;
    for (std::size_t i = 0; i < plans.size(); ++i) {
      const std::filesystem::path content_file =
          staging_folder / ("grib-" + std::to_string(i) + ".nc");
      write_granule(file, plans[i], inventory.grids[plans[i].grid], content_file, [&] {
        ++fields_done;
        if (progress) {
          progress(share_of_headers + (1.0 - share_of_headers) * static_cast<double>(fields_done) /
                                          static_cast<double>(inventory.fields.size()));
        }
      });
      ingested.granules.push_back({plans[i].granule, content_file});
    }
    staged.keep();
    return ingested;
  });
}

}  // namespace slackwater::ingest
