#include "api/pipeline/record.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "fields/interpolate/column_of_field.h"

namespace slackwater::api {
namespace {

constexpr double current_reach_m = 10000.0;
constexpr double wind_reach_m = 50000.0;
constexpr double other_reach_m = 5000.0;

constexpr Duration longest_leading_step = std::chrono::hours(3);
constexpr Duration shortest_leading_span = std::chrono::hours(20);  // of a day

GeoPoint place_of(const Grid& grid) {
  return GeoPoint::from_degrees(grid.latitude_deg.front(), grid.longitude_deg.front());
}

struct Place {
  GeoPoint point;
  double distance_m = 0;
};

/// A series answers at its own place wherever within reach it is asked; a grid answers where it is
/// asked.
std::optional<Place> where_to_ask(const Origin& origin, const GriddedField& field,
                                  const GeoPoint& point) {
  if (!origin.is_point_series) return Place{point, 0};
  const GeoPoint mooring = place_of(field.grid);
  const double distance = distance_m(mooring, point);
  if (distance > series_reach_m(field.standard_name)) return std::nullopt;
  return Place{mooring, distance};
}

template <typename T>
bool anything(const Column<T>& column) {
  return std::any_of(column.status.begin(), column.status.end(),
                     [](SampleStatus s) { return has_value(s); });
}

template <typename T, typename Piece, typename FieldOf, typename ColumnOf>
Record<T> record_of(const std::vector<Piece>& pieces, const GeoPoint& point, FieldOf field_of,
                    ColumnOf column_of_piece) {
  Record<T> record;
  for (const Piece& piece : pieces) {
    const auto place = where_to_ask(piece.origin, field_of(piece), point);
    if (!place) continue;
    Column<T> column = column_of_piece(piece, place->point);
    if (anything(column)) {
      record.pieces.push_back({&piece.origin, std::move(column), place->distance_m});
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

VectorRecord record_at(const std::vector<VectorPiece>& pieces, const GeoPoint& point) {
  return record_of<Horizontal>(
      pieces, point, [](const VectorPiece& piece) -> const GriddedField& { return piece.east; },
      [](const VectorPiece& piece, const GeoPoint& place) {
        return column_of(piece.east, piece.north, place, piece.origin.status);
      });
}

ScalarRecord record_at(const std::vector<ScalarPiece>& pieces, const GeoPoint& point) {
  return record_of<double>(
      pieces, point, [](const ScalarPiece& piece) -> const GriddedField& { return piece.field; },
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

double series_reach_m(const std::string& standard_name) noexcept {
  if (standard_name.ends_with("ward_sea_water_velocity")) return current_reach_m;
  if (standard_name.ends_with("ward_wind")) return wind_reach_m;
  return other_reach_m;
}

namespace {

/// What a dataset has in a span of time.
struct Presence {
  std::size_t values = 0;
  std::size_t levels = 0;
  bool in_situ = false;
  double distance_m = 0;
  std::vector<TimeCell> cells;

  [[nodiscard]] Duration span() const {
    return cells.empty() ? Duration(0) : cells.back().end - cells.front().start;
  }
  [[nodiscard]] Duration step() const {
    if (cells.size() < 2) return Duration::max();
    return (cells.back().centre() - cells.front().centre()) /
           static_cast<Duration::rep>(cells.size() - 1);
  }
};

std::map<std::string, Presence> presence_in(const VectorRecord& record, UtcTime from, UtcTime to) {
  std::map<std::string, Presence> found;
  for (const auto& piece : record.pieces) {
    Presence& presence = found[piece.origin->dataset];
    presence.levels = std::max(presence.levels, piece.column.levels());
    presence.in_situ = is_in_situ(*piece.origin);
    presence.distance_m = piece.distance_m;
    for (std::size_t t = 0; t < piece.column.times(); ++t) {
      const TimeCell& cell = piece.column.time[t];
      if (cell.end < from || cell.start > to) continue;
      const std::size_t before = presence.values;
      for (std::size_t k = 0; k < piece.column.levels(); ++k)
        presence.values += piece.column.has(t, k) ? 1 : 0;
      if (presence.values > before) presence.cells.push_back(cell);
    }
  }
  for (auto& [name, presence] : found) {
    std::vector<TimeCell>& cells = presence.cells;
    std::sort(cells.begin(), cells.end(),
              [](const TimeCell& a, const TimeCell& b) { return a.centre() < b.centre(); });
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  }
  return found;
}

using Candidate = std::pair<const std::string, Presence>;

/// Larger leads. Of instruments that span the day the nearest.
auto rank_of(const Presence& presence) {
  const bool spans = presence.in_situ && presence.span() >= shortest_leading_span;
  return std::tuple(spans, spans ? -presence.distance_m : 0.0, presence.values, presence.levels);
}

const Candidate* leading_of(const std::map<std::string, Presence>& found, bool in_situ) {
  const Candidate* best = nullptr;
  for (const Candidate& candidate : found) {
    if (candidate.second.values == 0 || candidate.second.in_situ != in_situ) continue;
    if (best == nullptr || rank_of(candidate.second) > rank_of(best->second)) best = &candidate;
  }
  return best;
}

}  // namespace

std::optional<std::string> fullest_dataset(const VectorRecord& record, UtcTime from, UtcTime to) {
  const std::map<std::string, Presence> found = presence_in(record, from, to);
  const Candidate* product = leading_of(found, false);
  const Candidate* series = leading_of(found, true);
  if (product == nullptr && series == nullptr) return std::nullopt;
  if (series == nullptr) return product->first;
  if (product == nullptr) return series->first;
  const bool product_leads = product->second.step() <= longest_leading_step &&
                             product->second.span() >= shortest_leading_span;
  const bool series_leads = series->second.span() >= shortest_leading_span;
  if (product_leads) return product->first;
  if (series_leads) return series->first;
  return product->second.values >= series->second.values ? product->first : series->first;
}

}  // namespace slackwater::api
