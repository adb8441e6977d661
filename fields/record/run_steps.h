#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "fields/record/product_run.h"

namespace slackwater {

/// The middle one of the pauses between times; 0 for fewer than two.
[[nodiscard]] Duration usual_step(std::span<const UtcTime> times);

/// Which time between analysed values a dataset's own forecasts fill. Where each run is a file that
/// begins with its analysis, analysed values stand a run apart and the forecasts from each are
/// finer: such values say nothing of the time between them.
///
/// Only where the analysis is at least twice as coarse as the forecasts: a value that is missing in
/// an analysis of the same step stays missing.
class FilledPauses {
 public:
  template <typename T>
  FilledPauses(const ProductRun<T>& run, const std::vector<const ProductRun<T>*>& runs) {
    const RunName name = run_name_of(run.origin());
    if (name.is_forecast || run.values.size() < 2) return;
    const Duration fine = usual_step(run.centres()) / 2;
    bool is_finer = false;
    for (const ProductRun<T>* other : runs) {
      const RunName its = run_name_of(other->origin());
      if (!its.is_forecast || its.dataset != name.dataset) continue;
      const std::vector<UtcTime> centres = other->centres();
      const Duration step = usual_step(centres);
      is_finer = is_finer || (step > Duration(0) && step <= fine);
      filling_.insert(filling_.end(), centres.begin(), centres.end());
    }
    if (!is_finer) filling_.clear();
    std::sort(filling_.begin(), filling_.end());
  }

  /// Whether a forecast has a value after the one time and before the other.
  [[nodiscard]] bool holds(UtcTime after, UtcTime before) const {
    const auto next = std::upper_bound(filling_.begin(), filling_.end(), after);
    return next != filling_.end() && *next < before;
  }

 private:
  std::vector<UtcTime> filling_;
};

}  // namespace slackwater
