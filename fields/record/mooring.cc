#include "fields/record/mooring.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "fields/base/numbers/averaging.h"

namespace slackwater {
namespace {

constexpr double same_mooring_m = 500.0;
constexpr double widest_same_level_m = 0.25;

GeoPoint place_of(const VectorPiece& piece) {
  return GeoPoint::from_degrees(piece.east.grid.latitude_deg.front(),
                                piece.east.grid.longitude_deg.front());
}

bool is_mean(const VectorPiece& piece) {
  return !piece.east.grid.time.empty() && piece.east.grid.time.front().is_mean();
}

/// A daily mean is no instant of an hourly series.
bool holds_long_means(const VectorPiece& piece) {
  return hides_the_tide(averaging_of(piece.east.grid.time));
}

bool can_join(const VectorPiece& piece) {
  return piece.origin.is_point_series && piece.east.grid.vertical == VerticalKind::depth_m &&
         !piece.east.grid.levels_m.empty();
}

bool same_mooring(const VectorPiece& a, const VectorPiece& b) {
  return a.origin.status == b.origin.status && a.origin.reference_time == b.origin.reference_time &&
         is_mean(a) == is_mean(b) && holds_long_means(a) == holds_long_means(b) &&
         distance_m(place_of(a), place_of(b)) <= same_mooring_m;
}

/// How near two levels are the same: a quarter of the finest spacing of any part.
double same_level_m(const std::vector<const VectorPiece*>& parts) {
  double nearest_m = widest_same_level_m;
  for (const VectorPiece* part : parts) {
    const std::vector<double>& levels = part->east.grid.levels_m;
    for (std::size_t k = 1; k < levels.size(); ++k)
      nearest_m = std::min(nearest_m, 0.25 * (levels[k] - levels[k - 1]));
  }
  return nearest_m;
}

std::vector<double> union_of_levels(const std::vector<const VectorPiece*>& parts) {
  const double same_m = same_level_m(parts);
  std::vector<double> levels;
  for (const VectorPiece* part : parts) {
    for (const double level : part->east.grid.levels_m) {
      const bool known = std::any_of(levels.begin(), levels.end(), [&](double other) {
        return std::abs(other - level) <= same_m;
      });
      if (!known) levels.push_back(level);
    }
  }
  std::sort(levels.begin(), levels.end());
  return levels;
}

std::size_t nearest_level(const std::vector<double>& levels, double wanted_m) {
  const auto nearest = std::min_element(levels.begin(), levels.end(), [&](double a, double b) {
    return std::abs(a - wanted_m) < std::abs(b - wanted_m);
  });
  return static_cast<std::size_t>(nearest - levels.begin());
}

SampleStatus status_at(const GriddedField& field, std::size_t i) {
  if (!field.status.empty()) return field.status[i];
  return std::isnan(field.values[i]) ? SampleStatus::missing : SampleStatus::ok;
}

/// Where the time of each part lies in the joined axis.
std::vector<TimeCell> union_of_times(const std::vector<const VectorPiece*>& parts) {
  std::map<UtcTime, TimeCell> times;
  for (const VectorPiece* part : parts)
    for (const TimeCell& cell : part->east.grid.time) times.try_emplace(cell.centre(), cell);
  std::vector<TimeCell> cells;
  cells.reserve(times.size());
  for (const auto& [centre, cell] : times) cells.push_back(cell);
  return cells;
}

std::size_t index_of(const std::vector<TimeCell>& cells, const TimeCell& wanted) {
  const auto found =
      std::lower_bound(cells.begin(), cells.end(), wanted.centre(),
                       [](const TimeCell& cell, UtcTime time) { return cell.centre() < time; });
  return static_cast<std::size_t>(found - cells.begin());
}

GriddedField empty_on(const Grid& grid, const GriddedField& pattern) {
  GriddedField field;
  field.standard_name = pattern.standard_name;
  field.unit = pattern.unit;
  field.grid = grid;
  field.values.assign(grid.size(), std::numeric_limits<float>::quiet_NaN());
  field.status.assign(grid.size(), SampleStatus::missing);
  return field;
}

void put(const VectorPiece& part, VectorPiece& joined) {
  const Grid& from = part.east.grid;
  const Grid& to = joined.east.grid;
  for (std::size_t t = 0; t < from.time.size(); ++t) {
    const std::size_t row = index_of(to.time, from.time[t]);
    for (std::size_t k = 0; k < from.levels_m.size(); ++k) {
      const std::size_t i = from.offset(t, k, 0, 0);
      const std::size_t o = to.offset(row, nearest_level(to.levels_m, from.levels_m[k]), 0, 0);
      const bool has = has_value(status_at(part.east, i)) && has_value(status_at(part.north, i));
      const bool had = has_value(joined.east.status[o]) && has_value(joined.north.status[o]);
      if (had && !has) continue;
      joined.east.values[o] = part.east.values[i];
      joined.north.values[o] = part.north.values[i];
      joined.east.status[o] = status_at(part.east, i);
      joined.north.status[o] = status_at(part.north, i);
    }
  }
}

Origin origin_of(const std::vector<const VectorPiece*>& parts) {
  Origin origin = parts.front()->origin;
  std::size_t others = 0;
  for (std::size_t p = 1; p < parts.size(); ++p) {
    const Origin& other = parts[p]->origin;
    origin.granules.insert(origin.granules.end(), other.granules.begin(), other.granules.end());
    for (const std::string& sha256 : other.sources) {
      if (std::find(origin.sources.begin(), origin.sources.end(), sha256) == origin.sources.end())
        origin.sources.push_back(sha256);
    }
    others += other.station != origin.station ? 1 : 0;
    origin.published = later_of(origin.published, other.published);
    origin.received = later_of(origin.received, other.received);
    // The worst of them: which value came from which part is no longer known.
    if (other.stated_error_m_s)
      origin.stated_error_m_s =
          std::max(origin.stated_error_m_s.value_or(0), *other.stated_error_m_s);
  }
  if (others > 0) origin.station += " and " + std::to_string(others) + " more";
  return origin;
}

VectorPiece joined_of(std::vector<const VectorPiece*> parts) {
  // In the order of ingest, so that the later one overwrites.
  std::stable_sort(parts.begin(), parts.end(), [](const VectorPiece* a, const VectorPiece* b) {
    return a->origin.granules.front() < b->origin.granules.front();
  });
  Grid grid = parts.front()->east.grid;
  grid.levels_m = union_of_levels(parts);
  grid.time = union_of_times(parts);
  VectorPiece joined{origin_of(parts), empty_on(grid, parts.front()->east),
                     empty_on(grid, parts.front()->north)};
  for (const VectorPiece* part : parts) put(*part, joined);
  return joined;
}

}  // namespace

void join_moorings(std::vector<VectorPiece>& pieces) {
  std::vector<VectorPiece> result;
  std::vector<bool> taken(pieces.size(), false);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (taken[i]) continue;
    std::vector<const VectorPiece*> parts{&pieces[i]};
    for (std::size_t j = i + 1; j < pieces.size() && can_join(pieces[i]); ++j) {
      if (taken[j] || !can_join(pieces[j]) || !same_mooring(pieces[i], pieces[j])) continue;
      parts.push_back(&pieces[j]);
      taken[j] = true;
    }
    if (parts.size() == 1) {
      result.push_back(std::move(pieces[i]));
    } else {
      result.push_back(joined_of(std::move(parts)));
    }
  }
  pieces = std::move(result);
}

}  // namespace slackwater
