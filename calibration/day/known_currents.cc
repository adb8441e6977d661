#include "calibration/day/known_currents.h"

#include <algorithm>
#include <cmath>

#include "calibration/fuse/fusion.h"
#include "fields/base/text.h"
#include "fields/interpolate/column_levels.h"
#include "fields/record/leading_dataset.h"
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

/// One dataset as known at the end of D; a forecast in it may reach beyond, what is known of the
/// sea ends with D.
Chosen<Horizontal> known_of(const ColumnData& column, const ForecastPlan& plan,
                            const std::string& dataset) {
  Choice choice;
  choice.dataset = dataset;
  Chosen<Horizontal> chosen = choose(column.current, plan.knowledge(), choice);
  Chosen<Horizontal> known;
  known.column = slice(chosen.column, UtcTime::min(), plan.end_of_day());
  // A surface product without a depth axis speaks of the surface.
  if (known.column.levels_m.empty()) {
    known.column.levels_m = {0.0};
    known.column.vertical = VerticalKind::depth_m;
  }
  chosen.origin.resize(known.column.times());
  known.origin = std::move(chosen.origin);
  known.stretches = std::move(chosen.stretches);
  return known;
}

/// The other dataset of a fusion and which of the two was measured.
struct Partner {
  std::string dataset;
  std::string station;
  double distance_m = 0;
  bool plan_is_in_situ = false;
};

/// With what the plan's dataset is fused; nothing where it stands alone.
std::optional<Partner> partner_of(const ColumnData& column, const ForecastPlan& plan) {
  const Piece* leading = piece_of(column, plan.dataset);
  if (leading == nullptr) return std::nullopt;
  const UtcTime day(plan.day);
  if (is_in_situ(*leading->origin)) {
    VectorRecord products;
    for (const Piece& piece : column.current.pieces)
      if (!is_in_situ(*piece.origin)) products.pieces.push_back(piece);
    const auto product = leading_dataset(products, day, plan.end_of_day(), plan.knowledge());
    if (!product) return std::nullopt;
    return Partner{*product, leading->origin->station, leading->distance_m, true};
  }
  const Piece* station = nearest_in_situ(column, [&](const Piece& piece) {
    return piece.distance_m <= FusionSettings{}.farthest_m &&
           has_values_in(piece.column, UtcTime::min(), plan.end_of_day());
  });
  if (station == nullptr) return std::nullopt;
  return Partner{station->origin->dataset, station->origin->station, station->distance_m, false};
}

/// The product brought to the cells and depths of a series, fused there, and the series itself
/// where the product has nothing.
VectorColumn fused_on_series(const VectorColumn& series, const VectorColumn& product,
                             double distance_m) {
  const VectorColumn background =
      at_times(at_depths(product, series.levels_m), series.time, std::chrono::hours(30));
  VectorColumn fused = fuse(background, series, distance_m).column;
  for (std::size_t i = 0; i < fused.value.size(); ++i) {
    if (has_value(fused.status[i])) continue;
    fused.value[i] = series.value[i];
    fused.status[i] = series.status[i];
  }
  fused.point = series.point;
  fused.source = series.source;
  return fused;
}

std::string kilometres(double distance_m) { return formatted("{:.1f} km", distance_m / 1000.0); }

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

Chosen<Horizontal> known_currents(const ColumnData& column, const ForecastPlan& plan) {
  if (plan.dataset.empty()) return {};
  Chosen<Horizontal> known = known_of(column, plan, plan.dataset);
  const auto partner = partner_of(column, plan);
  if (!partner || known.empty()) return known;
  const Chosen<Horizontal> other = known_of(column, plan, partner->dataset);
  if (other.empty()) return known;
  known.column = partner->plan_is_in_situ
                     ? fused_on_series(known.column, other.column, partner->distance_m)
                     : fuse(known.column, other.column, partner->distance_m).column;
  for (Stretch stretch : other.stretches) {
    stretch.why = "fused with it";
    known.stretches.push_back(std::move(stretch));
  }
  for (const Origin* origin : other.origin) {
    if (std::find(known.origin.begin(), known.origin.end(), origin) == known.origin.end())
      known.origin.push_back(origin);
  }
  return known;
}

std::vector<std::string> notes_on_record(const ColumnData& column, const ForecastPlan& plan) {
  const Piece* leading = piece_of(column, plan.dataset);
  if (leading == nullptr) return {};
  const auto partner = partner_of(column, plan);
  if (!partner) {
    if (!is_in_situ(*leading->origin)) return {};
    return {"currents of station " + leading->origin->station + " at " +
            kilometres(leading->distance_m) + " alone, no product"};
  }
  if (partner->plan_is_in_situ) {
    return {"currents of station " + partner->station + " at " + kilometres(partner->distance_m) +
            " fused with a coarser product"};
  }
  return {"fused with station " + partner->station + " at " + kilometres(partner->distance_m)};
}

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
  Chosen<Horizontal> known = known_currents(column, plan);
  if (!known.empty() && known.column.levels_m != truth.column.levels_m)
    known.column = at_depths(known.column, truth.column.levels_m);
  return known;
}

}  // namespace slackwater::calibration
