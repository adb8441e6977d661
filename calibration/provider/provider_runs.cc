#include "calibration/provider/provider_runs.h"

#include <algorithm>

#include "fields/record/product_run.h"

namespace slackwater::calibration {
namespace {

/// Over this time a run that takes over from another is moved onto it, as winds are.
constexpr Duration join_ramp = std::chrono::hours(6);

/// Of the runs, those of one dataset on one set of levels; the dataset asked for, else the first by
/// precedence.
std::vector<const ProductRun<Horizontal>*> of_one_product(
    const std::vector<ProductRun<Horizontal>>& runs, const std::string& dataset) {
  std::vector<const ProductRun<Horizontal>*> found;
  for (const ProductRun<Horizontal>& run : runs) {
    if (run.origin().reference_time && run.members == 0) found.push_back(&run);
  }
  std::stable_sort(found.begin(), found.end(), [&](const auto* a, const auto* b) {
    const bool is_asked_for = a->origin().dataset == dataset;
    if (is_asked_for != (b->origin().dataset == dataset)) return is_asked_for;
    return counts_before(standing_of(*a), standing_of(*b));
  });
  std::erase_if(found, [&, first = found.empty() ? nullptr : found.front()](const auto* run) {
    return run->origin().dataset != first->origin().dataset ||
           run->first->column.levels_m != first->first->column.levels_m;
  });
  return found;
}

}  // namespace

bool ProviderRuns::reaches_beyond(UtcTime time) const noexcept {
  return std::any_of(runs.begin(), runs.end(),
                     [&](const ProviderRun& run) { return run.column.time.back().end > time; });
}

ProviderRuns provider_runs(const VectorRecord& current, const std::string& dataset,
                           const Knowledge& knowledge, UtcTime from) {
  ProviderRuns result;
  Choice choice;
  choice.only_forecasts = true;
  choice.only_grids = true;
  const std::vector<ProductRun<Horizontal>> runs = runs_of(current, knowledge, choice);
  for (const ProductRun<Horizontal>* run : of_one_product(runs, dataset)) {
    if (run->values.back().cell.end <= from) continue;
    result.runs.push_back({column_of(*run), &run->origin()});
  }
  if (result.empty()) return result;
  std::stable_sort(result.runs.begin(), result.runs.end(), [](const auto& a, const auto& b) {
    return *a.origin->reference_time > *b.origin->reference_time;
  });
  choice.dataset = result.runs.front().origin->dataset;
  choice.ramp = join_ramp;
  Chosen<Horizontal> chosen = choose(current, knowledge, choice);
  result.series = std::move(chosen.column);
  result.origins = std::move(chosen.origin);
  result.stretches = std::move(chosen.stretches);
  return result;
}

}  // namespace slackwater::calibration
