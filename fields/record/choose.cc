#include "fields/record/choose.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace slackwater {
namespace {

/// Larger is better.
auto rank_of(const Origin& origin) {
  const bool known_for_sure = origin.status != DataStatus::forecast;
  return std::tuple(known_for_sure, origin.reference_time.value_or(UtcTime{}),
                    -origin.ensemble_member, origin.granules.front());
}

/// The dataset of the nearest point series with a known value; nothing where a dataset is asked for
/// or there is no series.
template <typename T>
std::optional<std::string> nearest_series(const Record<T>& record, const Knowledge& knowledge,
                                          const Choice& choice) {
  if (choice.dataset) return std::nullopt;
  const PieceColumn<T>* nearest = nullptr;
  for (const PieceColumn<T>& piece : record.pieces) {
    if (!piece.origin->is_point_series) continue;
    if (nearest != nullptr && nearest->distance_m <= piece.distance_m) continue;
    const bool known =
        std::any_of(piece.column.time.begin(), piece.column.time.end(),
                    [&](const TimeCell& cell) { return is_known(*piece.origin, cell, knowledge); });
    if (known) nearest = &piece;
  }
  if (nearest == nullptr) return std::nullopt;
  return nearest->origin->dataset;
}

template <typename T>
Chosen<T> choose_from(const Record<T>& record, const Knowledge& knowledge, const Choice& choice) {
  struct Candidate {
    const PieceColumn<T>* piece;
    std::size_t t;
  };
  std::map<UtcTime, Candidate> best;
  const PieceColumn<T>* pattern = nullptr;
  const auto series = nearest_series(record, knowledge, choice);
  for (const PieceColumn<T>& piece : record.pieces) {
    if (choice.dataset && piece.origin->dataset != *choice.dataset) continue;
    if (choice.only_grids && piece.origin->is_point_series) continue;
    if (choice.only_series && !piece.origin->is_point_series) continue;
    if (series && piece.origin->is_point_series && piece.origin->dataset != *series) continue;
    if (choice.only_forecasts && piece.origin->status != DataStatus::forecast) continue;
    if (pattern != nullptr && piece.column.levels_m != pattern->column.levels_m) continue;
    for (std::size_t t = 0; t < piece.column.times(); ++t) {
      const TimeCell& cell = piece.column.time[t];
      if (!is_known(*piece.origin, cell, knowledge)) continue;
      if (pattern == nullptr) pattern = &piece;
      const auto [found, is_new] = best.try_emplace(cell.centre(), Candidate{&piece, t});
      if (!is_new && rank_of(*piece.origin) > rank_of(*found->second.piece->origin)) {
        found->second = {&piece, t};
      }
    }
  }
  Chosen<T> chosen;
  if (pattern == nullptr) return chosen;
  Column<T>& out = chosen.column;
  out.point = pattern->column.point;
  out.vertical = pattern->column.vertical;
  out.levels_m = pattern->column.levels_m;
  for (const auto& [centre, candidate] : best) {
    const Column<T>& from = candidate.piece->column;
    out.time.push_back(from.time[candidate.t]);
    out.source.push_back(from.source[candidate.t]);
    chosen.origin.push_back(candidate.piece->origin);
    for (std::size_t k = 0; k < from.levels(); ++k) {
      out.value.push_back(from.value[from.offset(candidate.t, k)]);
      out.status.push_back(from.status[from.offset(candidate.t, k)]);
    }
  }
  return chosen;
}

}  // namespace

bool is_known(const Origin& origin, const TimeCell& cell, const Knowledge& knowledge) {
  if (origin.status == DataStatus::forecast && origin.reference_time) {
    return *origin.reference_time <= knowledge.forecasts_issued_by;
  }
  return cell.end <= knowledge.values_until ||
         (origin.received && *origin.received <= knowledge.received_by);
}

Chosen<Horizontal> choose(const VectorRecord& record, const Knowledge& knowledge,
                          const Choice& choice) {
  return choose_from(record, knowledge, choice);
}

Chosen<double> choose(const ScalarRecord& record, const Knowledge& knowledge,
                      const Choice& choice) {
  return choose_from(record, knowledge, choice);
}

}  // namespace slackwater
