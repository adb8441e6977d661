#pragma once
#include <string>
#include <vector>

#include "fields/record/choose.h"

namespace slackwater::calibration {

/// One run of a provider's own forecast of the currents of a column.
struct ProviderRun {
  VectorColumn column;             ///< its values, ascending, on its own levels
  const Origin* origin = nullptr;  ///< owned by the data; has a reference time
};

/// A provider's own forecast of a column as far as it is known.
struct ProviderRuns {
  std::vector<ProviderRun> runs;  ///< newest first, one product
  /// One series of them: the newest run as long as it lasts, then the next, moved onto it.
  VectorColumn series;
  std::vector<const Origin*> origins;  ///< whose values are in it
  std::vector<Stretch> stretches;      ///< which run speaks when
  [[nodiscard]] bool empty() const noexcept { return runs.empty(); }
  /// Whether any run ends after that.
  [[nodiscard]] bool reaches_beyond(UtcTime time) const noexcept;
};

/// The runs of a dataset, or, where it forecasts nothing, of the product that counts first among
/// those that do (fields/record/choose.h).
///
/// @param knowledge  runs count that were published by its `forecasts_issued_by`
/// @param from       runs that end by then are left out
[[nodiscard]] ProviderRuns provider_runs(const VectorRecord& current, const std::string& dataset,
                                         const Knowledge& knowledge, UtcTime from);

}  // namespace slackwater::calibration
