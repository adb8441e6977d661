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
  double distance_m = 0;  ///< of a point series from the place asked about; 0 for grids
};

/// Everything the store holds of one quantity at one place, not yet chosen from.
template <typename T>
struct Record {
  std::vector<PieceColumn<T>> pieces;
  bool on_land = false;  ///< a product covers the place and says that it is dry there
};

using VectorRecord = Record<Horizontal>;
using ScalarRecord = Record<double>;

/// How far a point series speaks for the water, or the air, around it: currents 10 km (within which
/// `calibration/fuse` knows what distance costs), winds 50 km (over open sea they change over the
/// scale of weather), everything else 5 km.
[[nodiscard]] double series_reach_m(const std::string& standard_name) noexcept;

/// What the pieces hold at a point: grids interpolated, point series within reach as they are.
[[nodiscard]] VectorRecord record_at(const std::vector<VectorPiece>& pieces, const GeoPoint& point);
[[nodiscard]] ScalarRecord record_at(const std::vector<ScalarPiece>& pieces, const GeoPoint& point);

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

/// Whether a piece was measured at a place: a point series of observations. Model output written as
/// a point series (`ingest --as analysis`) is a product.
[[nodiscard]] inline bool is_in_situ(const Origin& origin) noexcept {
  return origin.is_point_series && origin.status == DataStatus::observation;
}

/// The dataset that leads in a time span. Of products, and of in-situ series, the one with most
/// values in the span leads (ties go to more levels, then to the name). Between the two the product
/// leads where it steps by three hours or less, which resolves tide and inertia, and spans most of
/// the time, because it knows the whole depth; else the series; else whatever there is.
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
