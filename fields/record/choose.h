#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fields/record/record.h"

namespace slackwater {

/// What was known when: the glass through which a forecast, a hindcast or a verification looks at
/// the store.
struct Knowledge {
  UtcTime values_until =
      UtcTime::max();  ///< analysed and observed values that end later are unknown
  UtcTime forecasts_issued_by =
      UtcTime::max();  ///< provider forecasts with a later reference time are unknown
  /// What a file that had been received by then holds is known, whenever it is valid: products that
  /// run on into the future without saying where their forecast begins.
  UtcTime received_by = UtcTime::min();
};

/// Whether a value of this origin and time is seen through the glass.
[[nodiscard]] bool is_known(const Origin& origin, const TimeCell& cell, const Knowledge& knowledge);

/// A series chosen from a record: at each valid time the best piece known.
template <typename T>
struct Chosen {
  Column<T> column;
  std::vector<const Origin*> origin;  ///< per time; after them those that were fused into it
  [[nodiscard]] bool empty() const noexcept { return column.time.empty(); }
};

/// Which pieces may be joined, and which win.
struct Choice {
  bool only_forecasts = false;         ///< the provider's own forecast, nothing analysed
  bool only_grids = false;             ///< products, no moored instruments
  bool only_series = false;            ///< moored instruments, no products
  std::optional<std::string> dataset;  ///< only this dataset
};

/// Joins pieces into one series. At each valid time an analysis or observation beats a forecast, a
/// forecast with the later reference time (the shorter lead) beats the earlier, an ensemble's
/// control (its lowest member) beats the others, and the later ingested beats the earlier. Pieces
/// on other levels than the first chosen dataset are left out. Where no dataset is asked for, point
/// series at several places are not mixed: the nearest that has a known value speaks.
[[nodiscard]] Chosen<Horizontal> choose(const VectorRecord& record, const Knowledge& knowledge,
                                        const Choice& choice);
[[nodiscard]] Chosen<double> choose(const ScalarRecord& record, const Knowledge& knowledge,
                                    const Choice& choice);

}  // namespace slackwater
