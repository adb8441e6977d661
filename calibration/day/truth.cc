#include "calibration/day/truth.h"

#include <algorithm>

#include "calibration/day/given/known_currents.h"
#include "fields/interpolate/column_levels.h"
#include "fields/record/slice.h"

namespace slackwater::calibration {
namespace {

/// A station speaks for the water this far around it as the truth.
constexpr double farthest_truth_m = 5000.0;

using Piece = PieceColumn<Horizontal>;

/// The in-situ piece nearest to the column, of those that `fits`.
template <typename Fits>
const Piece* nearest_in_situ(const ColumnData& column, Fits fits) {
  const Piece* nearest = nullptr;
  for (const Piece& piece : column.current.pieces) {
    if (!is_in_situ(*piece.origin) || piece.column.vertical != VerticalKind::depth_m) continue;
    if (nearest != nullptr && nearest->distance_m <= piece.distance_m) continue;
    if (fits(piece)) nearest = &piece;
  }
  return nearest;
}

const Piece* piece_of(const ColumnData& column, const std::string& dataset) {
  for (const Piece& piece : column.current.pieces)
    if (piece.origin->dataset == dataset) return &piece;
  return nullptr;
}

bool has_values_in(const VectorColumn& column, UtcTime from, UtcTime to) {
  for (std::size_t t = 0; t < column.times(); ++t) {
    if (column.time[t].end <= from || column.time[t].start > to) continue;
    for (std::size_t k = 0; k < column.levels(); ++k)
      if (column.has(t, k)) return true;
  }
  return false;
}

/// A series that speaks at the depths of the dataset and has values in the span.
bool can_be_truth(const Piece& series, const ColumnData& column, const Piece* dataset, UtcTime from,
                  UtcTime to) {
  if (!has_values_in(series.column, from, to)) return false;
  if (dataset == nullptr) return true;
  const bool product_here =
      std::any_of(column.current.pieces.begin(), column.current.pieces.end(),
                  [](const Piece& piece) { return !is_in_situ(*piece.origin); });
  if (product_here && series.distance_m > farthest_truth_m) return false;
  const std::vector<double>& levels = dataset->column.levels_m;
  if (levels.empty()) return false;
  return std::any_of(series.column.levels_m.begin(), series.column.levels_m.end(),
                     [&](double depth) {
                       return depth >= levels.front() - 1e-3 && depth <= levels.back() + 1e-3;
                     });
}

}  // namespace

Chosen<Horizontal> truth_of(const ColumnData& column, const std::string& dataset,
                            UtcTime end_of_day, UtcTime until) {
  VectorRecord known;
  for (const auto& piece : column.current.pieces) {
    if (piece.origin->status != DataStatus::forecast) known.pieces.push_back(piece);
  }
  const Piece* forecast_from = piece_of(column, dataset);
  const Piece* station = nearest_in_situ(column, [&](const Piece& piece) {
    return can_be_truth(piece, column, forecast_from, end_of_day, until);
  });
  Choice choice;
  choice.dataset = station != nullptr ? station->origin->dataset : dataset;
  Chosen<Horizontal> chosen = choose(known, {}, choice);
  Chosen<Horizontal> truth;
  truth.column = slice(chosen.column, end_of_day, until);
  // The instant at 24:00 of D belongs to D.
  VectorColumn& c = truth.column;
  while (!c.time.empty() && c.time.front().end <= end_of_day) {
    c.value.erase(c.value.begin(), c.value.begin() + static_cast<std::ptrdiff_t>(c.levels()));
    c.status.erase(c.status.begin(), c.status.begin() + static_cast<std::ptrdiff_t>(c.levels()));
    c.time.erase(c.time.begin());
    c.source.erase(c.source.begin());
  }
  if (c.levels_m.empty()) c.levels_m = {0.0};
  if (!chosen.origin.empty()) truth.origin.assign(c.times(), chosen.origin.back());
  return truth;
}

Chosen<Horizontal> known_beside(const Chosen<Horizontal>& truth, const ColumnData& column,
                                const ForecastPlan& plan) {
  if (!truth.origin.empty()) {
    Chosen<Horizontal> own = known_of(column, plan, truth.origin.front()->dataset);
    if (own.column.levels_m == truth.column.levels_m &&
        has_values_in(own.column, UtcTime(plan.day), plan.end_of_day())) {
      return own;
    }
  }
  Chosen<Horizontal> known = known_currents(column, plan).record;
  if (!known.empty() && known.column.levels_m != truth.column.levels_m)
    known.column = at_depths(known.column, truth.column.levels_m);
  return known;
}

}  // namespace slackwater::calibration
