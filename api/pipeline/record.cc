#include "api/pipeline/record.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "fields/interpolate/column_of_field.h"

namespace slackwater::api {
namespace {

/// A point series speaks for the water within this distance of its mooring.
constexpr double series_reach_m = 5000.0;

GeoPoint place_of(const Grid& grid) {
  return GeoPoint::from_degrees(grid.latitude_deg.front(), grid.longitude_deg.front());
}

/// A series answers at its own place wherever within reach it is asked; a grid answers where it is
/// asked.
std::optional<GeoPoint> where_to_ask(const Origin& origin, const Grid& grid,
                                     const GeoPoint& point) {
  if (!origin.is_point_series) return point;
  const GeoPoint mooring = place_of(grid);
  if (distance_m(mooring, point) > series_reach_m) return std::nullopt;
  return mooring;
}

template <typename T>
bool anything(const Column<T>& column) {
  return std::any_of(column.status.begin(), column.status.end(),
                     [](SampleStatus s) { return has_value(s); });
}

template <typename T, typename Piece, typename GridOf, typename ColumnOf>
Record<T> record_of(const std::vector<Piece>& pieces, const GeoPoint& point, GridOf grid_of,
                    ColumnOf column_of_piece) {
  Record<T> record;
  for (const Piece& piece : pieces) {
    const auto place = where_to_ask(piece.origin, grid_of(piece), point);
    if (!place) continue;
    Column<T> column = column_of_piece(piece, *place);
    if (anything(column)) {
      record.pieces.push_back({&piece.origin, std::move(column)});
    } else if (column.status.front() == SampleStatus::land) {
      record.on_land = true;
    }
  }
  return record;
}

bool is_known(const Origin& origin, const TimeCell& cell, const Knowledge& knowledge) {
  if (origin.status == DataStatus::forecast && origin.reference_time) {
    return *origin.reference_time <= knowledge.forecasts_issued_by;
  }
  return cell.end <= knowledge.values_until;
}

/// Larger is better.
auto rank_of(const Origin& origin) {
  const bool known_for_sure = origin.status != DataStatus::forecast;
  return std::tuple(known_for_sure, origin.reference_time.value_or(UtcTime{}),
                    -origin.ensemble_member, origin.granules.front());
}

template <typename T>
Chosen<T> choose_from(const Record<T>& record, const Knowledge& knowledge, const Choice& choice) {
  struct Candidate {
    const PieceColumn<T>* piece;
    std::size_t t;
  };
  std::map<UtcTime, Candidate> best;
  const PieceColumn<T>* pattern = nullptr;
  for (const PieceColumn<T>& piece : record.pieces) {
    if (choice.dataset && piece.origin->dataset != *choice.dataset) continue;
    if (choice.only_grids && piece.origin->is_point_series) continue;
    if (choice.only_series && !piece.origin->is_point_series) continue;
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

VectorRecord record_at(const std::vector<VectorPiece>& pieces, const GeoPoint& point) {
  return record_of<Horizontal>(
      pieces, point, [](const VectorPiece& piece) -> const Grid& { return piece.east.grid; },
      [](const VectorPiece& piece, const GeoPoint& place) {
        return column_of(piece.east, piece.north, place, piece.origin.status);
      });
}

ScalarRecord record_at(const std::vector<ScalarPiece>& pieces, const GeoPoint& point) {
  return record_of<double>(
      pieces, point, [](const ScalarPiece& piece) -> const Grid& { return piece.field.grid; },
      [](const ScalarPiece& piece, const GeoPoint& place) {
        return column_of(piece.field, place, piece.origin.status);
      });
}

Chosen<Horizontal> choose(const VectorRecord& record, const Knowledge& knowledge,
                          const Choice& choice) {
  return choose_from(record, knowledge, choice);
}

Chosen<double> choose(const ScalarRecord& record, const Knowledge& knowledge,
                      const Choice& choice) {
  return choose_from(record, knowledge, choice);
}

std::optional<std::string> fullest_dataset(const VectorRecord& record, UtcTime from, UtcTime to) {
  std::map<std::string, std::pair<std::size_t, std::size_t>> score;  // values, levels
  for (const auto& piece : record.pieces) {
    auto& [values, levels] = score[piece.origin->dataset];
    levels = std::max(levels, piece.column.levels());
    for (std::size_t t = 0; t < piece.column.times(); ++t) {
      if (piece.column.time[t].end < from || piece.column.time[t].start > to) continue;
      for (std::size_t k = 0; k < piece.column.levels(); ++k)
        values += piece.column.has(t, k) ? 1 : 0;
    }
  }
  std::optional<std::string> best;
  std::pair<std::size_t, std::size_t> best_score{0, 0};
  for (const auto& [name, found] : score) {
    if (found.first > 0 && (!best || found > best_score)) {
      best = name;
      best_score = found;
    }
  }
  return best;
}

}  // namespace slackwater::api
