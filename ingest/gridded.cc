#include "ingest/gridded.h"

#include <algorithm>

#include "fields/base/error.h"
#include "ingest/cf/attribution.h"
#include "ingest/cf/granule_file.h"
#include "ingest/cf/settle.h"
#include "ingest/decoded/staged_files.h"
#include "ingest/gridded_plan.h"
#include "ingest/provenance.h"
#include "ingest/zeros_for_land.h"

namespace slackwater::ingest {
namespace {

constexpr std::uintmax_t largest_uncut_file = std::uintmax_t{512} << 20;
/// A unit mistake moves most values out of the believable range; a few are the provider's own
/// blunders.
constexpr double most_gross_share = 0.1;

/// Times [first, first + count) of a group that share one status.
struct Period {
  std::size_t first = 0;
  std::size_t count = 0;
  DataStatus status = DataStatus::analysis;
  std::optional<UtcTime> reference;
};

/// The status rule of fields/docs/conventions.md, which may cut a file in two: analysed up to the
/// reference time, forecast after it.
std::vector<Period> periods_of(const Grid& grid, const std::optional<UtcTime>& stated,
                               const IngestOptions& options) {
  const std::size_t times = grid.times();
  const auto reference = options.issued ? options.issued : stated;
  if (options.as == DataStatus::forecast) {
    if (!reference) {
      throw Error(ErrorKind::usage,
                  "a forecast needs its issue time and the file states none; add --issued TIME");
    }
    return {{0, times, DataStatus::forecast, reference}};
  }
  if (options.as) return {{0, times, *options.as, options.issued}};
  if (!reference || grid.time.empty()) return {{0, times, DataStatus::analysis, std::nullopt}};
  const auto later = std::find_if(grid.time.begin(), grid.time.end(),
                                  [&](const TimeCell& cell) { return cell.centre() > *reference; });
  const auto analysed = static_cast<std::size_t>(later - grid.time.begin());
  std::vector<Period> periods;
  if (analysed > 0) periods.push_back({0, analysed, DataStatus::analysis, std::nullopt});
  if (analysed < times)
    periods.push_back({analysed, times - analysed, DataStatus::forecast, reference});
  return periods;
}

std::filesystem::path free_name(const std::filesystem::path& folder) {
  for (int n = 0;; ++n) {
    std::filesystem::path name = folder / ("granule-" + std::to_string(n) + ".nc");
    if (!std::filesystem::exists(name)) return name;
  }
}

/// What happened to one variable over the whole file.
struct Outcome {
  std::string source_name;
  std::string standard_name;
  DecodeCounts counts;
};

class Work {
 public:
  Work(std::size_t values, const Progress& progress)
      : whole_(std::max<std::size_t>(values, 1)), progress_(progress) {}
  void done(std::size_t values) {
    done_ += values;
    if (progress_)
      progress_(std::min(1.0, static_cast<double>(done_) / static_cast<double>(whole_)));
  }

 private:
  std::size_t whole_;
  std::size_t done_ = 0;
  const Progress& progress_;
};

void write_variable(GranuleWriter& writer, std::size_t index, PlannedVariable& variable,
                    const Grid& grid, const Period& period, Outcome& outcome, Work& work) {
  const GranuleWriter::Block block = writer.block();
  std::vector<float> values;
  std::vector<float> stokes;
  for (std::size_t t = 0; t < period.count; t += block.times) {
    const std::size_t times = std::min(block.times, period.count - t);
    for (std::size_t j = 0; j < grid.rows(); j += block.rows) {
      const std::size_t rows = std::min(block.rows, grid.rows() - j);
      values.resize(times * grid.levels() * rows * grid.columns());
      variable.source->read(period.first + t, times, j, rows, values, outcome.counts);
      if (variable.stokes) {
        stokes.resize(values.size());
        DecodeCounts ignored;
        variable.stokes->read(period.first + t, times, j, rows, stokes, ignored);
        for (std::size_t i = 0; i < values.size(); ++i) values[i] -= stokes[i];
      }
      take_zeros_out(values, variable.no_values, grid, j, rows, outcome.counts);
      writer.put(index, t, times, j, rows, values);
      work.done(values.size());
    }
  }
}

DecodedGranule write_granule(PlannedGroup& group, const Period& period, Granule granule,
                             const std::filesystem::path& folder, std::vector<Outcome>& outcomes,
                             Work& work) {
  granule.grid = group.grid;
  if (!granule.grid.time.empty()) {
    const auto begin = group.grid.time.begin() + static_cast<std::ptrdiff_t>(period.first);
    granule.grid.time.assign(begin, begin + static_cast<std::ptrdiff_t>(period.count));
  }
  for (const PlannedVariable& variable : group.variables)
    granule.variables.push_back(variable.description);
  granule.status = period.status;
  granule.reference_time = period.reference;
  DecodedGranule decoded{std::move(granule), free_name(folder)};
  GranuleWriter writer(decoded.content_file, decoded.granule);
  for (std::size_t v = 0; v < group.variables.size(); ++v) {
    write_variable(writer, v, group.variables[v], group.grid, period, outcomes[v], work);
  }
  writer.finish();
  return decoded;
}

void judge(const std::vector<Outcome>& outcomes, const Vocabulary& vocabulary,
           const IngestOptions& options, std::vector<std::string>& warnings) {
  std::string empty;
  bool some = false;
  for (const Outcome& outcome : outcomes) {
    const std::size_t present = outcome.counts.values + outcome.counts.gross;
    if (outcome.counts.gross > 0) {
      const Range& range = vocabulary.by_standard_name(outcome.standard_name)->gross;
      const std::string what =
          "'" + outcome.source_name + "': " + std::to_string(outcome.counts.gross) + " of " +
          std::to_string(present) + " values lie outside the believable range " +
          std::to_string(range.low) + " to " + std::to_string(range.high);
      if (static_cast<double>(outcome.counts.gross) >
          most_gross_share * static_cast<double>(present)) {
        throw Error(ErrorKind::invalid_input,
                    what + "; expected few or none; check the units and the packing");
      }
      warnings.push_back(what + " and are taken as missing");
    }
    some |= outcome.counts.values > 0;
    if (outcome.counts.outside > 0)
      warnings.push_back(lost_by_limits(outcome.source_name, outcome.counts));
    if (outcome.counts.values == 0)
      empty += (empty.empty() ? "'" : ", '") + outcome.source_name + "'";
  }
  const bool by_limits = std::any_of(outcomes.begin(), outcomes.end(), [](const Outcome& outcome) {
    return outcome.counts.outside > 0;
  });
  if (!some) {
    throw Error(ErrorKind::invalid_input,
                "all values of " + empty +
                    (by_limits ? " are missing (fill, or outside the valid range that the file "
                                 "states)"
                               : " are missing (fill)") +
                    (options.cut ? " inside the cut; expected water there; choose another box"
                                 : "; expected at least one value; fetch the file again"));
  }
  if (!empty.empty()) warnings.push_back("all values of " + empty + " are missing (fill)");
}

std::string dataset_of(const Granule& common, const PlannedGroup& group) {
  if (!group.is_ensemble_mean) return common.dataset_id;
  return (common.dataset_id.empty() ? "" : common.dataset_id + " ") + ensemble_mean_dataset;
}

void drop_repeats(std::vector<std::string>& warnings) {
  std::vector<std::string> kept;
  for (std::string& warning : warnings) {
    if (std::find(kept.begin(), kept.end(), warning) == kept.end())
      kept.push_back(std::move(warning));
  }
  warnings = std::move(kept);
}

}  // namespace

Ingested decode_gridded(const netcdf::File& file, const ProductCatalogue& products,
                        const IngestOptions& options, const std::filesystem::path& staging_folder,
                        const Progress& progress) {
  const std::uintmax_t bytes = std::filesystem::file_size(file.path());
  if (bytes > largest_uncut_file && !options.cut) {
    throw Error(ErrorKind::invalid_input,
                "has " + std::to_string(bytes >> 20) +
                    " MiB; expected at most 512 MiB without a cut; give --bbox or --site");
  }
  Ingested ingested;
  StagedFiles staged(ingested);
  const Product& product = product_for(file, products, options);
  std::vector<PlannedGroup> groups =
      plan_gridded(file, products, product, options, ingested.warnings);
  const auto stated = stated_reference_time(file, product);
  Granule common;
  common.product_id = product.id;
  common.dataset_id = stated_dataset_id(file);
  common.is_regional = product.is_regional;
  // Who says when a run was issued says when it was there.
  if (!options.issued) common.published_after = product.published_after;
  common.attribution = attribution_of(file, product);

  std::size_t all_values = 0;
  for (const PlannedGroup& group : groups) all_values += group.grid.size() * group.variables.size();
  Work work(all_values, progress);
  std::vector<Outcome> outcomes;
  for (PlannedGroup& group : groups) {
    mark_zeros_for_land(group, ingested.warnings);
    if (group.is_ensemble_mean) {
      ingested.warnings.push_back(
          "'" + group.variables.front().description.source_name +
          "' is the mean over the members of an ensemble, smoother than any of them; kept apart "
          "as dataset " +
          dataset_of(common, group));
    }
    std::vector<Outcome> of_group;
    for (const PlannedVariable& variable : group.variables) {
      of_group.push_back(
          {variable.description.source_name, variable.description.standard_name, {}});
    }
    for (const Period& period : periods_of(group.grid, stated, options)) {
      ingested.granules.push_back(
          write_granule(group, period, common, staging_folder, of_group, work));
      ingested.granules.back().granule.dataset_id = dataset_of(common, group);
    }
    outcomes.insert(outcomes.end(), of_group.begin(), of_group.end());
  }
  judge(outcomes, products.vocabulary(), options, ingested.warnings);
  drop_repeats(ingested.warnings);
  staged.keep();
  return ingested;
}

}  // namespace slackwater::ingest
