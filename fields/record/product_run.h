#pragma once
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "fields/record/choose.h"

namespace slackwater {

/// What tells one run of one product from another.
struct RunName {
  std::string dataset;
  bool is_forecast = false;
  std::optional<UtcTime> reference_time;  ///< of a forecast
  bool operator==(const RunName&) const = default;
};

[[nodiscard]] RunName run_name_of(const Origin& origin);

/// One value of a run: where it stands.
template <typename T>
struct RunValue {
  TimeCell cell;
  const PieceColumn<T>* piece = nullptr;
  std::size_t t = 0;
};

/// What speaks with one voice: the analysis of a dataset, one run of its forecast, or the mean of
/// an ensemble.
template <typename T>
struct ProductRun {
  const PieceColumn<T>* first = nullptr;  ///< of its pieces, the one that names it
  std::vector<RunValue<T>> values;        ///< those known, ascending by centre
  std::size_t members = 0;                ///< of which it is the mean; 0: none
  bool may_be_revised = false;
  std::vector<UtcTime> revised;                ///< centres of values that came more than once
  std::unique_ptr<const PieceColumn<T>> mean;  ///< owned; where the values of a mean stand

  [[nodiscard]] const Origin& origin() const { return *first->origin; }
  [[nodiscard]] std::vector<UtcTime> centres() const {
    std::vector<UtcTime> times;
    times.reserve(values.size());
    for (const RunValue<T>& value : values) times.push_back(value.cell.centre());
    return times;
  }
};

/// The runs of the pieces that the choice lets in, as known; each has a value.
[[nodiscard]] std::vector<ProductRun<Horizontal>> runs_of(const VectorRecord& record,
                                                          const Knowledge& knowledge,
                                                          const Choice& choice);
[[nodiscard]] std::vector<ProductRun<double>> runs_of(const ScalarRecord& record,
                                                      const Knowledge& knowledge,
                                                      const Choice& choice);

/// The values of a run as a series, on the levels of the piece that names it.
[[nodiscard]] VectorColumn column_of(const ProductRun<Horizontal>& run);

/// What a run is weighed by against others.
struct RunStanding {
  const Origin* origin = nullptr;
  bool is_mean_of_members = false;
  std::optional<double> from_height_m;
  std::size_t levels = 1;
};
template <typename T>
[[nodiscard]] RunStanding standing_of(const ProductRun<T>& run) {
  return {&run.origin(), run.members > 0, run.first->from_height_m, run.first->column.levels()};
}

/// What a product stands before others for, whatever the run: not known to lack the tide, of a
/// region, of finer grid. Smaller counts first.
[[nodiscard]] std::tuple<bool, bool, int> product_precedence(const Origin& origin);

/// Whether the first run counts before the second.
[[nodiscard]] bool counts_before(const RunStanding& one, const RunStanding& other);
/// What puts the first before the second: "analysed", "of finer grid".
[[nodiscard]] std::string reason_before(const RunStanding& one, const RunStanding& other);

}  // namespace slackwater
