#pragma once
#include <optional>
#include <string>
#include <vector>

#include "api/pipeline/pieces.h"
#include "fields/interpolate/column.h"

namespace slackwater::api {

/// What was known when: the glass through which a forecast, a hindcast or a verification looks at
/// the store.
struct Knowledge {
  UtcTime values_until =
      UtcTime::max();  ///< analysed and observed values that end later are unknown
  UtcTime forecasts_issued_by =
      UtcTime::max();  ///< provider forecasts with a later reference time are unknown
};

/// One stored piece seen at one place.
template <typename T>
struct PieceColumn {
  const Origin* origin = nullptr;  ///< owned by the pieces, which outlive the record
  Column<T> column;
};

/// Everything the store holds of one quantity at one place, not yet chosen from.
template <typename T>
struct Record {
  std::vector<PieceColumn<T>> pieces;
  bool on_land = false;  ///< a product covers the place and says that it is dry there
};

using VectorRecord = Record<Horizontal>;
using ScalarRecord = Record<double>;

[[nodiscard]] VectorRecord record_at(const std::vector<VectorPiece>& pieces, const GeoPoint& point);
[[nodiscard]] ScalarRecord record_at(const std::vector<ScalarPiece>& pieces, const GeoPoint& point);

/// A series chosen from a record: at each valid time the best piece known.
template <typename T>
struct Chosen {
  Column<T> column;
  std::vector<const Origin*> origin;  ///< per time
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
/// on other levels than the first chosen dataset are left out.
[[nodiscard]] Chosen<Horizontal> choose(const VectorRecord& record, const Knowledge& knowledge,
                                        const Choice& choice);
[[nodiscard]] Chosen<double> choose(const ScalarRecord& record, const Knowledge& knowledge,
                                    const Choice& choice);

/// The dataset with most values in the cells of a time span: ties go to more levels, then to the
/// name.
[[nodiscard]] std::optional<std::string> fullest_dataset(const VectorRecord& record, UtcTime from,
                                                         UtcTime to);

/// The part of a series whose cells lie wholly inside [from, to].
template <typename T>
[[nodiscard]] Column<T> slice(const Column<T>& column, UtcTime from, UtcTime to) {
  Column<T> part;
  part.point = column.point;
  part.vertical = column.vertical;
  part.levels_m = column.levels_m;
  for (std::size_t t = 0; t < column.times(); ++t) {
    if (column.time[t].start < from || column.time[t].end > to) continue;
    part.time.push_back(column.time[t]);
    part.source.push_back(column.source[t]);
    for (std::size_t k = 0; k < column.levels(); ++k) {
      part.value.push_back(column.value[column.offset(t, k)]);
      part.status.push_back(column.status[column.offset(t, k)]);
    }
  }
  return part;
}

}  // namespace slackwater::api
