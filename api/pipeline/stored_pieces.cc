#include "api/pipeline/stored_pieces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "fields/base/error.h"
#include "fields/record/mooring.h"
#include "ingest/cf/granule_file.h"

namespace slackwater::api {
namespace {

struct IndexRange {
  std::size_t first = 0;
  std::size_t count = 0;
};

/// The indices of an axis inside [low, high] with one more on either side, so that a point at the
/// edge of the box still has its neighbours.
IndexRange around(const std::vector<double>& axis, double low, double high) {
  const auto begin = std::lower_bound(axis.begin(), axis.end(), low);
  const auto end = std::upper_bound(axis.begin(), axis.end(), high);
  auto first = static_cast<std::size_t>(begin - axis.begin());
  auto last = static_cast<std::size_t>(end - axis.begin());
  first = first > 0 ? first - 1 : 0;
  last = std::min(axis.size(), last + 1);
  return {first, last > first ? last - first : 0};
}

IndexRange columns_around(const Grid& grid, const BoundingBox& box) {
  const double east = box.east_deg < box.west_deg ? box.east_deg + 360 : box.east_deg;
  const double middle = 0.5 * (grid.longitude_deg.front() + grid.longitude_deg.back());
  const double turn = 360.0 * std::round((middle - 0.5 * (box.west_deg + east)) / 360.0);
  return around(grid.longitude_deg, box.west_deg + turn, east + turn);
}

IndexRange times_within(const Grid& grid, const Window& window) {
  if (grid.time.empty()) return {0, 1};
  std::size_t first = 0;
  std::size_t last = grid.time.size();
  if (window.from) {
    while (first < last && grid.time[first].end < *window.from) ++first;
  }
  if (window.to) {
    while (last > first && grid.time[last - 1].start > *window.to) --last;
  }
  return {first, last - first};
}

std::string dataset_of(const store::GranuleRow& row, const Granule& granule) {
  std::ostringstream text;
  if (row.is_point_series) {  // its levels may differ from file to file, and are joined
    text << row.product_id << "/in-situ/" << row.station
         << (!granule.grid.time.empty() && granule.grid.time.front().is_mean() ? "/mean"
                                                                               : "/instant");
    return text.str();
  }
  text << row.product_id << '/' << row.dataset_id << '/' << row.station << '/'
       << granule.grid.levels_m.size();
  if (!granule.grid.levels_m.empty())
    text << '@' << granule.grid.levels_m.front() << '-' << granule.grid.levels_m.back();
  if (!granule.grid.time.empty())
    text << (granule.grid.time.front().is_mean() ? "/mean" : "/instant");
  return text.str();
}

struct Loaded {
  store::GranuleRow row;
  Granule granule;
  GriddedField field;
};

Origin origin_of(const Loaded& loaded) {
  Origin origin;
  origin.granules = {loaded.row.id};
  origin.status = loaded.row.status;
  origin.reference_time = loaded.row.reference_time;
  origin.dataset = dataset_of(loaded.row, loaded.granule);
  origin.ensemble_member = loaded.row.ensemble_member.value_or(0);
  origin.product_id = loaded.row.product_id;
  origin.attribution = loaded.row.attribution;
  origin.sources = {loaded.row.source_sha256};
  origin.station = loaded.row.station;
  origin.is_point_series = loaded.row.is_point_series;
  origin.water_depth_m = loaded.granule.water_depth_m;
  for (const GranuleVariable& variable : loaded.granule.variables) {
    if (variable.standard_name == loaded.field.standard_name)
      origin.contains_stokes = variable.contains_stokes;
  }
  return origin;
}

std::string reading(const std::string& name, const store::GranuleRow& row) {
  return "reading stored " + name + " of " + row.product_id;
}

store::GranuleQuery query_for(const std::vector<std::string>& any_of, const Window& window) {
  store::GranuleQuery query;
  query.any_of = any_of;
  query.from = window.from;
  query.to = window.to;
  query.box = window.box;
  query.margin_km = 10;
  return query;
}

/// One stored granule, opened once for all that is read from it.
class OpenGranule {
 public:
  OpenGranule(const store::Store& store, const store::GranuleRow& row)
      : row_(row), file_(ingest::GranuleFile::open(store.content_path(row.content_sha256))) {}

  /// The window's part of one variable; nothing where the window holds no cell of it.
  [[nodiscard]] std::optional<Loaded> read(const std::string& name, const Window& window) const {
    const Grid& grid = file_.granule().grid;
    const IndexRange rows = around(grid.latitude_deg, window.box.south_deg, window.box.north_deg);
    const IndexRange columns = columns_around(grid, window.box);
    const IndexRange times = times_within(grid, window);
    if (rows.count == 0 || columns.count == 0 || times.count == 0) return std::nullopt;
    Loaded loaded{row_, file_.granule(), {}};
    loaded.field = file_.read(name, times.first, times.count, rows.first, rows.count, columns.first,
                              columns.count);
    return loaded;
  }

 private:
  store::GranuleRow row_;
  ingest::GranuleFile file_;
};

bool names(const store::GranuleRow& row, const std::string& name) {
  return std::find(row.standard_names.begin(), row.standard_names.end(), name) !=
         row.standard_names.end();
}

/// Whether two granules, one with U and one with V, belong together.
bool pair_up(const Loaded& u, const Loaded& v) {
  return u.row.product_id == v.row.product_id && u.row.status == v.row.status &&
         u.row.reference_time == v.row.reference_time &&
         u.row.ensemble_member == v.row.ensemble_member && u.row.station == v.row.station &&
         u.field.grid == v.field.grid;
}

}  // namespace

std::vector<VectorPiece> read_vector_pieces(store::Store& store, const std::string& east_name,
                                            const std::string& north_name, const Window& window) {
  std::vector<VectorPiece> pieces;
  std::vector<Loaded> lone_north;
  for (const store::GranuleRow& row : store.find_granules(query_for({north_name}, window))) {
    if (names(row, east_name)) continue;
    with_context(reading(north_name, row), [&] {
      if (auto loaded = OpenGranule(store, row).read(north_name, window))
        lone_north.push_back(std::move(*loaded));
    });
  }
  for (const store::GranuleRow& row : store.find_granules(query_for({east_name}, window))) {
    with_context(reading(east_name, row), [&] {
      const OpenGranule granule(store, row);
      auto east = granule.read(east_name, window);
      if (!east) return;
      Origin origin = origin_of(*east);
      if (names(row, north_name)) {
        auto north = granule.read(north_name, window);
        pieces.push_back({std::move(origin), std::move(east->field), std::move(north->field)});
        return;
      }
      // The newest V that fits.
      const auto match = std::find_if(lone_north.rbegin(), lone_north.rend(),
                                      [&](const Loaded& north) { return pair_up(*east, north); });
      if (match == lone_north.rend()) return;
      origin.granules.push_back(match->row.id);
      origin.sources.push_back(match->row.source_sha256);
      pieces.push_back({std::move(origin), std::move(east->field), match->field});
    });
  }
  if (east_name == "eastward_sea_water_velocity") join_moorings(pieces);
  return pieces;
}

std::vector<std::vector<ScalarPiece>> read_scalar_pieces(store::Store& store,
                                                         const std::vector<std::string>& wanted,
                                                         const Window& window) {
  std::vector<std::vector<ScalarPiece>> pieces(wanted.size());
  for (const store::GranuleRow& row : store.find_granules(query_for(wanted, window))) {
    std::optional<OpenGranule> granule;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (!names(row, wanted[i])) continue;
      with_context(reading(wanted[i], row), [&] {
        if (!granule) granule.emplace(store, row);
        if (auto loaded = granule->read(wanted[i], window)) {
          Origin origin = origin_of(*loaded);
          pieces[i].push_back({std::move(origin), std::move(loaded->field)});
        }
      });
    }
  }
  return pieces;
}

}  // namespace slackwater::api
