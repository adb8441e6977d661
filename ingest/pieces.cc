#include "ingest/pieces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <sstream>

#include "fields/base/error.h"
#include "fields/base/numbers/averaging.h"
#include "fields/base/text.h"
#include "fields/geo/coverage.h"
#include "fields/record/mooring.h"
#include "ingest/cf/granule_file.h"

namespace slackwater::ingest {
namespace {

/// Cells up to this far from a column take part in its interpolation: more than the coarsest wind
/// grid's step.
constexpr double margin_deg = 0.3;

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

/// Whether a grid goes round the Earth: its first column is the next of its last.
bool is_cyclic(const std::vector<double>& longitude_deg) {
  if (longitude_deg.size() < 3) return false;
  const double wide = longitude_deg.back() - longitude_deg.front();
  const double step = wide / static_cast<double>(longitude_deg.size() - 1);
  return std::abs(wide + step - 360) < 0.5 * step;
}

/// Of a grid that goes round, with one more on either side. The columns are counted on past the
/// seam: all of them are its own and the first once more.
IndexRange columns_around_cyclic(const std::vector<double>& axis, double west, double east) {
  const std::size_t n = axis.size();
  const auto columns = static_cast<std::int64_t>(n);
  // How many columns lie west of a longitude, counted from the first of turn 0.
  const auto columns_before = [&](double longitude, bool with_its_own) {
    const double turns = std::floor((longitude - axis.front()) / 360);
    const double x = longitude - 360 * turns;
    const auto end = with_its_own ? std::upper_bound(axis.begin(), axis.end(), x)
                                  : std::lower_bound(axis.begin(), axis.end(), x);
    return static_cast<std::int64_t>(turns) * columns + (end - axis.begin());
  };
  const std::int64_t first = columns_before(west, false) - 1;
  const auto count = static_cast<std::size_t>(columns_before(east, true) + 1 - first);
  if (count > n) return {0, n + 1};
  return {static_cast<std::size_t>((first % columns + columns) % columns), count};
}

IndexRange columns_around(const Grid& grid, const BoundingBox& box) {
  const std::vector<double>& axis = grid.longitude_deg;
  const double east = box.east_deg < box.west_deg ? box.east_deg + 360 : box.east_deg;
  if (is_cyclic(axis)) return columns_around_cyclic(axis, box.west_deg, east);
  const double middle = 0.5 * (axis.front() + axis.back());
  const double turn = 360.0 * std::round((middle - 0.5 * (box.west_deg + east)) / 360.0);
  IndexRange all = around(axis, box.west_deg + turn, east + turn);
  // A wide box may hold both ends of a wide grid, and not what is missing between them.
  for (const double other : {turn - 360, turn + 360}) {
    if (east + other < axis.front() || box.west_deg + other > axis.back()) continue;
    const IndexRange more = around(axis, box.west_deg + other, east + other);
    const std::size_t end = std::max(all.first + all.count, more.first + more.count);
    all.first = std::min(all.first, more.first);
    all.count = end - all.first;
  }
  return all;
}

/// Two cuts of one grid as one, the second behind the first, once round the Earth.
GriddedField joined_at_seam(const GriddedField& west, const GriddedField& east) {
  GriddedField both = west;
  for (const double x : east.grid.longitude_deg) both.grid.longitude_deg.push_back(x + 360);
  const auto join = [&](const auto& a, const auto& b, auto& out) {
    out.clear();
    const auto a_columns = static_cast<std::ptrdiff_t>(west.grid.columns());
    const auto b_columns = static_cast<std::ptrdiff_t>(east.grid.columns());
    for (auto i = a.begin(), j = b.begin(); i != a.end(); i += a_columns, j += b_columns) {
      out.insert(out.end(), i, i + a_columns);
      out.insert(out.end(), j, j + b_columns);
    }
  };
  join(west.values, east.values, both.values);
  join(west.status, east.status, both.status);
  return both;
}

IndexRange times_within(const Grid& grid, const CutOut& window) {
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

/// Hourly and daily means of one product are two datasets, whatever else they share.
std::string kind_of_times(const std::vector<TimeCell>& time) {
  if (!time.front().is_mean()) return "/instant";
  const Duration averaging = averaging_of(time);
  if (!hides_the_tide(averaging)) return "/mean";
  return "/mean-" + std::to_string((averaging + std::chrono::minutes(1)) / std::chrono::hours(1)) +
         "h";
}

/// Spacing and offset of a grid, the same for cuts of it: "/0.0833x0.125+0.04,0.02".
std::string grid_name(const Grid& grid) {
  if (grid.latitude_deg.size() < 2 || grid.longitude_deg.size() < 2) return "/one cell";
  const auto step = [](const std::vector<double>& axis) {
    return (axis.back() - axis.front()) / static_cast<double>(axis.size() - 1);
  };
  const double north = step(grid.latitude_deg);
  const double east = step(grid.longitude_deg);
  // Where the axis would cross 0, in steps; rounded so that single precision does not show.
  const auto offset = [](double first, double spacing) {
    const double steps = first / spacing;
    return std::round(20 * (steps - std::floor(steps))) / 20;
  };
  const auto part = [](double share) { return share >= 1 ? 0 : share; };
  return formatted("/{:.3g}x{:.3g}+{:.2f},{:.2f}", north, east,
                   part(offset(grid.latitude_deg.front(), north)),
                   part(offset(grid.longitude_deg.front(), east)));
}

std::string dataset_of(const Granule& granule) {
  std::ostringstream text;
  if (granule.is_point_series) {  // its levels may differ from file to file, and are joined
    text << granule.product_id << "/in-situ/" << granule.station
         << (granule.grid.time.empty() ? "/instant" : kind_of_times(granule.grid.time));
    return text.str();
  }
  text << granule.product_id << '/' << granule.dataset_id << '/' << granule.station << '/'
       << granule.grid.levels_m.size();
  if (!granule.grid.levels_m.empty())
    text << '@' << granule.grid.levels_m.front() << '-' << granule.grid.levels_m.back();
  if (!granule.grid.time.empty()) text << kind_of_times(granule.grid.time);
  if (is_nobodys(granule.product_id)) text << grid_name(granule.grid);
  return text.str();
}

struct Loaded {
  GranuleEntry entry;
  Granule granule;
  GriddedField field;
};

/// Of a grid in latitude, else in longitude; 0 for one cell.
double spacing_of(const Grid& grid) {
  for (const std::vector<double>* axis : {&grid.latitude_deg, &grid.longitude_deg}) {
    if (axis->size() > 1)
      return std::abs(axis->back() - axis->front()) / static_cast<double>(axis->size() - 1);
  }
  return 0;
}

Origin origin_of(const Loaded& loaded) {
  const Granule& granule = loaded.granule;
  Origin origin;
  origin.granules = {loaded.entry.number};
  origin.status = granule.status;
  origin.reference_time = granule.reference_time;
  origin.published_after = granule.published_after;
  origin.dataset = dataset_of(granule);
  origin.ensemble_member = granule.ensemble_member.value_or(0);
  origin.product_id = granule.product_id;
  origin.is_of_named_product = !is_nobodys(granule.product_id);
  origin.attribution = granule.attribution;
  origin.sources = {loaded.entry.source_sha256};
  origin.received = loaded.entry.received;
  origin.published = loaded.entry.published;
  origin.station = granule.station;
  origin.is_point_series = granule.is_point_series;
  origin.rank.is_regional = granule.is_regional;
  origin.rank.spacing_deg = spacing_of(granule.grid);
  origin.water_depth_m = granule.water_depth_m;
  origin.stated_error_m_s = granule.stated_error_m_s;
  for (const GranuleVariable& variable : granule.variables) {
    if (variable.standard_name == loaded.field.standard_name) {
      origin.contains_stokes = variable.contains_stokes;
      origin.rank.has_tide = variable.has_tide;
    }
  }
  return origin;
}

std::string reading(const std::string& name, const GranuleEntry& entry) {
  return "reading " + name + " of " + entry.product_id;
}

/// One granule, opened once for all that is read from it.
class OpenGranule {
 public:
  explicit OpenGranule(const GranuleEntry& entry)
      : entry_(entry), file_(GranuleFile::open(entry.content_file)) {}

  /// The window's part of one variable; nothing where the window holds no cell of it.
  [[nodiscard]] std::optional<Loaded> read(const std::string& name, const CutOut& window) const {
    const Grid& grid = file_.granule().grid;
    const IndexRange rows = around(grid.latitude_deg, window.box.south_deg, window.box.north_deg);
    const IndexRange columns = columns_around(grid, window.box);
    const IndexRange times = times_within(grid, window);
    if (rows.count == 0 || columns.count == 0 || times.count == 0) return std::nullopt;
    Loaded loaded{entry_, file_.granule(), {}};
    const auto read_columns = [&](std::size_t first, std::size_t count) {
      return file_.read(name, times.first, times.count, rows.first, rows.count, first, count);
    };
    const std::size_t before_seam = std::min(columns.count, grid.columns() - columns.first);
    loaded.field = read_columns(columns.first, before_seam);
    if (before_seam < columns.count) {
      loaded.field = joined_at_seam(loaded.field, read_columns(0, columns.count - before_seam));
    }
    return loaded;
  }

 private:
  GranuleEntry entry_;
  GranuleFile file_;
};

bool names(const GranuleEntry& entry, const std::string& name) {
  return std::find(entry.standard_names.begin(), entry.standard_names.end(), name) !=
         entry.standard_names.end();
}

/// Whether two granules, one with U and one with V, belong together.
bool pair_up(const Loaded& u, const Loaded& v) {
  return u.granule.product_id == v.granule.product_id && u.granule.status == v.granule.status &&
         u.granule.reference_time == v.granule.reference_time &&
         u.granule.ensemble_member == v.granule.ensemble_member &&
         u.granule.station == v.granule.station && u.field.grid == v.field.grid;
}

std::vector<VectorPiece> vector_pieces(const FindGranules& find, const std::string& east_name,
                                       const std::string& north_name, const CutOut& window) {
  std::vector<VectorPiece> pieces;
  std::vector<Loaded> lone_north;
  for (const GranuleEntry& entry : find({north_name}, window)) {
    if (names(entry, east_name)) continue;
    with_context(reading(north_name, entry), [&] {
      if (auto loaded = OpenGranule(entry).read(north_name, window))
        lone_north.push_back(std::move(*loaded));
    });
  }
  for (const GranuleEntry& entry : find({east_name}, window)) {
    with_context(reading(east_name, entry), [&] {
      const OpenGranule granule(entry);
      auto east = granule.read(east_name, window);
      if (!east) return;
      Origin origin = origin_of(*east);
      if (names(entry, north_name)) {
        auto north = granule.read(north_name, window);
        pieces.push_back({std::move(origin), std::move(east->field), std::move(north->field)});
        return;
      }
      // The newest V that fits.
      const auto match = std::find_if(lone_north.rbegin(), lone_north.rend(),
                                      [&](const Loaded& north) { return pair_up(*east, north); });
      if (match == lone_north.rend()) return;
      origin.granules.push_back(match->entry.number);
      origin.sources.push_back(match->entry.source_sha256);
      origin.received = later_of(origin.received, match->entry.received);
      origin.published = later_of(origin.published, match->entry.published);
      pieces.push_back({std::move(origin), std::move(east->field), match->field});
    });
  }
  return pieces;
}

/// Whether a dataset of `wanted` is none of those found.
bool lacks_any_of(const std::vector<ScalarPiece>& found, const std::vector<ScalarPiece>& wanted) {
  return std::any_of(wanted.begin(), wanted.end(), [&](const ScalarPiece& one) {
    return std::none_of(found.begin(), found.end(), [&](const ScalarPiece& piece) {
      return piece.origin.dataset == one.origin.dataset;
    });
  });
}

}  // namespace

bool is_nobodys(const std::string& product_id) {
  return product_id == "cf" || product_id == "unnamed_weather";
}

bool comes_near(bool is_point_series, const BoundingBox& bounds,
                const std::vector<std::string>& standard_names, const CutOut& window) {
  if (!is_point_series) return overlaps(bounds, widened(window.box, granule_margin_km));
  double reach_km = 0;
  for (const std::string& name : standard_names)
    reach_km = std::max(reach_km, series_reach_m(name) / 1000);
  return overlaps(bounds, widened(window.site, reach_km));
}

CutOut cut_around(const BoundingBox& box, UtcTime from, UtcTime to) {
  const double east = box.east_deg < box.west_deg ? box.east_deg + 360 : box.east_deg;
  return {from,
          to,
          {box.west_deg - margin_deg, std::max(-90.0, box.south_deg - margin_deg),
           east + margin_deg, std::min(90.0, box.north_deg + margin_deg)},
          box};
}

std::size_t cells_read(const Grid& grid, const CutOut& window) {
  return grid.levels() *
         around(grid.latitude_deg, window.box.south_deg, window.box.north_deg).count *
         columns_around(grid, window.box).count;
}

std::vector<std::vector<ScalarPiece>> scalar_pieces_of(const CutOut& window,
                                                       const std::vector<std::string>& wanted,
                                                       const FindGranules& find) {
  std::vector<std::vector<ScalarPiece>> pieces(wanted.size());
  for (const GranuleEntry& entry : find(wanted, window)) {
    std::optional<OpenGranule> granule;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (!names(entry, wanted[i])) continue;
      with_context(reading(wanted[i], entry), [&] {
        if (!granule) granule.emplace(entry);
        if (auto loaded = granule->read(wanted[i], window)) {
          Origin origin = origin_of(*loaded);
          pieces[i].push_back({std::move(origin), std::move(loaded->field)});
        }
      });
    }
  }
  return pieces;
}

SitePieces pieces_of(const Site& site, UtcTime from, UtcTime to, const FindGranules& find) {
  return pieces_of(CutOut{from, to, site.box(margin_deg), site.box(0)}, find);
}

SitePieces pieces_of(const CutOut& window, const FindGranules& find) {
  SitePieces pieces;
  pieces.current =
      vector_pieces(find, "eastward_sea_water_velocity", "northward_sea_water_velocity", window);
  join_moorings(pieces.current);
  pieces.wind = vector_pieces(find, "eastward_wind", "northward_wind", window);
  const auto scalar = [&](const char* name) {
    return std::move(scalar_pieces_of(window, {name}, find).front());
  };
  pieces.mixed_layer_depth = scalar("ocean_mixed_layer_thickness_defined_by_sigma_theta");
  if (pieces.mixed_layer_depth.empty())
    pieces.temperature = scalar("sea_water_potential_temperature");
  auto waves = scalar_pieces_of(window,
                                {"sea_surface_wave_significant_height",
                                 "sea_surface_wave_period_at_variance_spectral_density_maximum",
                                 "sea_surface_wave_from_direction"},
                                find);
  pieces.significant_height = std::move(waves[0]);
  pieces.peak_period = std::move(waves[1]);
  pieces.wave_direction = std::move(waves[2]);
  if (lacks_any_of(pieces.peak_period, pieces.significant_height)) {
    auto means = scalar_pieces_of(
        window,
        {"sea_surface_wave_mean_period_from_variance_spectral_density_inverse_frequency_moment",
         "sea_surface_wave_mean_period_from_variance_spectral_density_second_frequency_moment",
         "sea_surface_wave_zero_upcrossing_period"},
        find);
    pieces.energy_period = std::move(means[0]);
    pieces.zero_crossing_period = std::move(means[1]);
    std::move(means[2].begin(), means[2].end(), std::back_inserter(pieces.zero_crossing_period));
  }
  pieces.sea_level = scalar("sea_surface_height_above_geoid");
  pieces.water_depth =
      std::move(scalar_pieces_of({std::nullopt, std::nullopt, window.box, window.site},
                                 {"sea_floor_depth_below_geoid"}, find)[0]);
  return pieces;
}

}  // namespace slackwater::ingest
