#include "api/door/edr/sample/product_queries.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "api/door/edr/read/bad_parameter.h"
#include "api/door/edr/read/bbox.h"
#include "api/door/edr/read/datetime.h"
#include "api/door/edr/read/distance.h"
#include "api/door/edr/read/parameter_names.h"
#include "api/door/edr/read/resolution.h"
#include "api/door/edr/read/wkt.h"
#include "api/door/edr/sample/asked_area.h"
#include "api/door/edr/sample/work.h"
#include "api/issued/product_values.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "fields/record/cadence.h"

namespace slackwater::api::edr {
namespace {

/// Around an instant, which shows how far apart the times of most products are.
constexpr Duration about_an_instant = std::chrono::hours(25);

/// So much of a product's time around an instant that the ends of three files lie on either side,
/// where there are three: times a day apart, each in its own file, show that they hang together.
TimeSpan around_an_instant(const StoredProduct& product, UtcTime instant) {
  std::set<UtcTime> ends;
  for (const store::GranuleRow& row : product.granules) {
    ends.insert(*row.first_time);
    ends.insert(*row.last_time);
  }
  constexpr int wanted = 3;
  TimeSpan span{instant - about_an_instant, instant + about_an_instant};
  auto before = ends.lower_bound(instant);
  for (int i = 0; i < wanted && before != ends.begin(); ++i) --before;
  auto after = ends.upper_bound(instant);
  for (int i = 1; i < wanted && after != ends.end(); ++i) ++after;
  if (before != ends.end()) span.from = std::min(span.from, *before);
  span.to = std::max(span.to, after != ends.end() ? *after : *ends.rbegin());
  return span;
}

/// What of a product a query asks for, whatever the places.
struct Asked {
  const StoredProduct* product = nullptr;
  std::vector<Parameter> all;
  std::vector<std::size_t> parameters;
  std::optional<UtcTime> instant;
  UtcTime from{};
  UtcTime to{};
  std::optional<std::string> z;
};

Error outside(const StoredProduct& product, const std::string& found) {
  return {ErrorKind::not_found, "found " + found + "; " + held_text(product)};
}

Asked asked_of(const StoredProduct& product, const QueryString& query) {
  Asked asked;
  asked.product = &product;
  asked.all = parameters_of(product);
  if (const auto wanted = query.find("parameter-name")) {
    std::vector<std::string> names;
    names.reserve(asked.all.size());
    for (const Parameter& parameter : asked.all) names.push_back(parameter.name);
    asked.parameters = parse_parameter_names(*wanted, names);
  } else {
    asked.parameters.resize(asked.all.size());
    std::iota(asked.parameters.begin(), asked.parameters.end(), 0);
  }
  asked.from = product.from;
  asked.to = product.to;
  if (const auto text = query.find("datetime")) {
    const TimeRange range = parse_datetime(*text);
    asked.from = std::max(asked.from, range.from.value_or(asked.from));
    asked.to = std::min(asked.to, range.to.value_or(asked.to));
    if (asked.from > asked.to) throw outside(product, "datetime " + shown(*text));
    if (range.is_instant()) {
      asked.instant = asked.from;
      const TimeSpan around = around_an_instant(product, asked.from);
      asked.from = around.from;
      asked.to = around.to;
    }
  }
  asked.z = query.find("z");
  return asked;
}

/// Between which times of the product an instant lies that it says nothing of: of files that were
/// not opened the ends.
Error between_times(const Asked& asked, const ProductView& view) {
  const UtcTime instant = *asked.instant;
  std::optional<UtcTime> before;
  std::optional<UtcTime> after;
  const auto look_at = [&](UtcTime time) {
    if (time <= instant) before = std::max(time, before.value_or(time));
    if (time >= instant) after = std::min(time, after.value_or(time));
  };
  for (const TimeCell& cell : view.time()) look_at(cell.centre());
  if (!before || !after) {
    for (const store::GranuleRow& row : asked.product->granules) {
      if (*row.last_time < instant) look_at(*row.last_time);
      if (*row.first_time > instant) look_at(*row.first_time);
    }
  }
  std::string found = "datetime " + format_utc(instant) + " in a gap of the " +
                      (asked.product->is_measured() ? "instrument" : "product") + "'s times";
  if (before) found += ", after " + format_utc(*before);
  if (after) found += std::string(before ? " and" : ",") + " before " + format_utc(*after);
  if (view.damaged() > 0)
    found += " (left out: " + counted(view.damaged(), "stored file") + ", damaged)";
  return outside(*asked.product, found);
}

/// The mean that holds the instant, of two that meet there the later; else, where the times around
/// it hang together, the nearest.
UtcTime time_for_instant(const Asked& asked, const ProductView& view,
                         std::vector<std::string>& notes) {
  const UtcTime instant = *asked.instant;
  const std::vector<TimeCell>& all = view.time();
  const auto holder = std::find_if(all.rbegin(), all.rend(), [&](const TimeCell& cell) {
    return cell.start <= instant && instant <= cell.end;
  });
  if (holder != all.rend()) return holder->centre();
  std::vector<UtcTime> centres;
  centres.reserve(all.size());
  for (const TimeCell& cell : all) centres.push_back(cell.centre());
  const auto after = static_cast<std::size_t>(
      std::lower_bound(centres.begin(), centres.end(), instant) - centres.begin());
  if (after == 0 || after == centres.size() || !hangs_on(centres, after))
    throw between_times(asked, view);
  const bool is_later = centres[after] - instant < instant - centres[after - 1];
  const TimeCell& nearest = all[is_later ? after : after - 1];
  if (nearest.is_mean()) throw between_times(asked, view);
  notes.push_back(format_utc(instant) + " is between " +
                  (asked.product->is_measured() ? "the instrument" : "the product") +
                  "'s times: its values of " + format_utc(nearest.start) +
                  ", the nearest, are given");
  return nearest.start;
}

std::vector<UtcTime> times_of(const Asked& asked, const ProductView& view,
                              std::vector<std::string>& notes) {
  if (asked.instant) return {time_for_instant(asked, view, notes)};
  std::vector<UtcTime> times;
  for (const TimeCell& cell : view.time()) times.push_back(cell.centre());
  if (!times.empty()) return times;
  throw outside(*asked.product,
                "no time of the " +
                    std::string(asked.product->is_measured() ? "instrument" : "product") +
                    " there in " + format_utc(asked.from) + "/" + format_utc(asked.to));
}

/// Levels this near are one.
constexpr double same_level_m = 1e-3;

/// "depth 0 to 30 m", "height 10 m alone".
std::string levels_text(const StoredProduct& product, const std::vector<double>& levels_m) {
  const char* kind = vertical_of(product) == Vertical::height_up ? "height" : "depth";
  if (levels_m.size() == 1) return formatted("{} {:g} m alone", kind, levels_m.front());
  return formatted("{} {:g} to {:g} m", kind, levels_m.front(), levels_m.back());
}

/// Whether a level lies between the first and the last of a product.
bool is_held(double level_m, const std::vector<double>& levels_m) {
  return level_m >= levels_m.front() - same_level_m && level_m <= levels_m.back() + same_level_m;
}

/// Empty without a vertical.
/// @param own  points that have their levels themselves
std::vector<double> levels_of(const Asked& asked, const ProductView& view, const Path& own = {}) {
  const StoredProduct& product = *asked.product;
  const std::vector<double>& all = view.levels_m();
  if (vertical_of(product) == Vertical::none || all.empty()) {
    if (asked.z && !asked.z->empty()) {
      throw Error(ErrorKind::usage, "z: found " + shown(*asked.z) + "; the collection " +
                                        product.id + " has no vertical; leave z out");
    }
    return {};
  }
  if (!asked.z && own.empty()) return all;
  std::vector<double> levels;
  levels.reserve(own.size());
  for (const Vertex& point : own) levels.push_back(point.vertical);
  if (std::any_of(levels.begin(), levels.end(), [&](double z) { return is_held(z, all); }))
    return levels;
  return levels_asked(asked.z ? *asked.z : formatted("{}", levels.front()),
                      all.front() - same_level_m, all.back() + same_level_m, all, "the product",
                      levels_text(product, all));
}

/// Places of the answer, and how they become coverages.
struct Places {
  std::vector<GeoPoint> point;
  std::vector<double> longitude_deg;  ///< axes of a grid; of points one each
  std::vector<double> latitude_deg;
  std::vector<std::size_t> cell;  ///< of a grid: which cell each point is
  bool is_grid = false;
  bool has_own_levels = false;  ///< as many levels as points, one each
};

GeoPoint point_of(double longitude_deg, double latitude_deg) {
  return GeoPoint::from_degrees(latitude_deg, std::remainder(longitude_deg, 360.0));
}

ProductWindow window_of(const Asked& asked, const Box& box) {
  return {box.west_deg, box.south_deg, box.east_deg, box.north_deg, asked.from, asked.to};
}

/// How many times, levels and places values are of.
struct Block {
  std::size_t times = 0;
  std::size_t levels = 0;
  std::size_t places = 0;
};

/// One place out of a block of many.
std::vector<double> of_place(const std::vector<double>& values, const Block& block,
                             std::size_t place) {
  std::vector<double> out;
  out.reserve(block.times * block.levels);
  for (std::size_t i = 0; i < block.times * block.levels; ++i)
    out.push_back(values[i * block.places + place]);
  return out;
}

/// Its places spread over the cells of a grid.
std::vector<double> on_cells(const std::vector<double>& values, const Block& block,
                             const Places& places) {
  const std::size_t cells = places.longitude_deg.size() * places.latitude_deg.size();
  std::vector<double> out(block.times * block.levels * cells, std::nan(""));
  for (std::size_t i = 0; i < block.times * block.levels; ++i)
    for (std::size_t p = 0; p < block.places; ++p)
      out[i * cells + places.cell[p]] = values[i * block.places + p];
  return out;
}

/// How many levels from the first on have a value anywhere; one at least.
std::size_t levels_with_values(const ProductValues& values, const Block& block) {
  std::size_t count = 1;
  const std::vector<double>& first = values.value.front();
  for (std::size_t i = 0; i < first.size(); ++i) {
    const std::size_t level = i / block.places % block.levels;
    if (level >= count && !std::isnan(first[i])) count = level + 1;
  }
  return count;
}

/// Without the levels behind the first `count`.
void cut_levels(ProductValues& values, Block& block, std::size_t count) {
  for (std::vector<double>& all : values.value) {
    std::vector<double> kept;
    kept.reserve(block.times * count * block.places);
    for (std::size_t t = 0; t < block.times; ++t) {
      const auto begin = all.begin() + static_cast<std::ptrdiff_t>(t * block.levels * block.places);
      kept.insert(kept.end(), begin, begin + static_cast<std::ptrdiff_t>(count * block.places));
    }
    all = std::move(kept);
  }
  values.absent.resize(count);
  block.levels = count;
}

std::size_t absent(const ProductValues& values, SampleStatus status) {
  std::size_t count = 0;
  for (const auto& level : values.absent) count += level[static_cast<std::size_t>(status)];
  return count;
}

/// What is not given of an instrument, and why.
void add_quality_note(const ProductValues& values, std::vector<std::string>& notes) {
  std::string left_out;
  const auto add = [&](SampleStatus status, const char* words) {
    if (const std::size_t count = absent(values, status); count > 0)
      left_out += (left_out.empty() ? "" : ", ") + std::to_string(count) + words;
  };
  add(SampleStatus::not_checked, " that nobody checked");
  add(SampleStatus::suspect, " that were rejected");
  add(SampleStatus::missing, " missing");
  notes.push_back("values of good quality alone; not given: " +
                  (left_out.empty() ? std::string("none") : left_out));
}

void add_notes(const StoredProduct& product, const ProductValues& values, std::size_t damaged,
               std::vector<std::string>& notes) {
  if (product.is_measured()) add_quality_note(values, notes);
  for (std::size_t i = 0; i < sample_status_count; ++i) {
    const auto status = static_cast<SampleStatus>(i);
    const std::size_t count = absent(values, status);
    if (count == 0 || product.is_measured()) continue;
    notes.push_back(std::to_string(count) + " places and times without a value: " +
                    std::string(name_of(status)) + "; " + held_text(product));
  }
  if (values.averaged > Duration(0)) {
    notes.push_back(
        formatted("values are means over {:g} h about their times", hours_of(values.averaged)));
  }
  if (values.most_members > 0)
    notes.push_back("means of " + std::to_string(values.most_members) + " members of an ensemble");
  if (values.contains_stokes) notes.emplace_back("the currents hold Stokes drift");
  if (damaged > 0)
    notes.push_back("left out: " + counted(damaged, "stored file") + " of the product, damaged");
}

Answer filled(const Asked& asked, const ProductView& view, const Places& places,
              std::vector<UtcTime> times, std::vector<double> levels,
              std::vector<std::string> notes) {
  const StoredProduct& product = *asked.product;
  const bool has_own = places.has_own_levels;
  ProductValues values =
      view.values(places.point, times, levels,
                  has_own ? ProductView::Levels::one_for_each : ProductView::Levels::all_at_each);
  Block block{times.size(), has_own ? 1 : std::max<std::size_t>(1, levels.size()),
              places.point.size()};
  if (!places.is_grid &&
      absent(values, SampleStatus::land) == block.times * block.levels * block.places) {
    throw outside(product, formatted("coords at {:.5f} {:.5f} on land, as the product has it: ask "
                                     "at a place in the water, or an area that reaches it",
                                     places.longitude_deg.front(), places.latitude_deg.front()));
  }
  if (!asked.z && block.levels > 1) {
    const std::size_t count = levels_with_values(values, block);
    cut_levels(values, block, count);
    levels.resize(count);
  }
  Answer answer;
  answer.collection = product.id;
  answer.title = title_of(product);
  answer.vertical = vertical_of(product);
  for (const std::size_t i : asked.parameters) answer.parameters.push_back(asked.all[i]);
  answer.notes = std::move(notes);
  add_notes(product, values, view.damaged(), answer.notes);
  if (!std::all_of(levels.begin(), levels.end(),
                   [&](double level) { return is_held(level, view.levels_m()); })) {
    answer.notes.push_back("levels that the product does not reach have no value: it holds " +
                           levels_text(product, view.levels_m()));
  }
  answer.provenance.attributions = product.attributions;
  answer.provenance.product = ProductSource{product.product_id,
                                            product.dataset_id,
                                            {values.runs.begin(), values.runs.end()},
                                            {values.sources.begin(), values.sources.end()}};
  const std::vector<std::vector<double>> all =
      values_of(product, asked.parameters, std::move(values.value));
  const auto coverage_at = [&](DomainType domain, std::vector<double> x, std::vector<double> y) {
    Coverage coverage;
    coverage.domain = domain;
    coverage.longitude_deg = std::move(x);
    coverage.latitude_deg = std::move(y);
    coverage.vertical_m = levels;
    coverage.time = times;
    return coverage;
  };
  if (places.is_grid) {
    Coverage coverage = coverage_at(DomainType::grid, places.longitude_deg, places.latitude_deg);
    for (const auto& each : all) coverage.values.push_back(on_cells(each, block, places));
    answer.coverages.push_back(std::move(coverage));
    return answer;
  }
  for (std::size_t p = 0; p < places.point.size(); ++p) {
    Coverage coverage = coverage_at(domain_at_point(times.size(), has_own ? 1 : levels.size()),
                                    {places.longitude_deg[p]}, {places.latitude_deg[p]});
    if (has_own) coverage.vertical_m = {levels[p]};
    for (const auto& each : all) coverage.values.push_back(of_place(each, block, p));
    answer.coverages.push_back(std::move(coverage));
  }
  return answer;
}

Answer measured_near(const std::filesystem::path& store, const Asked& asked, const Path& points);

Answer at_points(const std::filesystem::path& store, const Asked& asked, const Path& points,
                 bool have_own_levels) {
  const StoredProduct& product = *asked.product;
  if (product.is_measured()) return measured_near(store, asked, points);
  Places places;
  Box box{1e9, 1e9, -1e9, -1e9};
  for (const Vertex& point : points) {
    const GeoPoint at = point_of(point.longitude_deg, point.latitude_deg);
    if (!product.bounds.contains(at)) {
      throw outside(product, formatted("coords at {:.5f} {:.5f}, outside the product",
                                       point.longitude_deg, point.latitude_deg));
    }
    places.point.push_back(at);
    places.longitude_deg.push_back(point.longitude_deg);
    places.latitude_deg.push_back(point.latitude_deg);
    box = {std::min(box.west_deg, point.longitude_deg), std::min(box.south_deg, point.latitude_deg),
           std::max(box.east_deg, point.longitude_deg),
           std::max(box.north_deg, point.latitude_deg)};
  }
  const ProductView view(store, product, window_of(asked, box));
  std::vector<std::string> notes;
  std::vector<UtcTime> times = times_of(asked, view, notes);
  std::vector<double> levels = levels_of(asked, view, have_own_levels ? points : Path());
  places.has_own_levels = have_own_levels && !levels.empty();
  const std::size_t levels_each =
      places.has_own_levels ? 1 : std::max<std::size_t>(1, levels.size());
  static_cast<void>(moderate_work(asked.parameters.size(),
                                  points.size() * times.size() * levels_each, points.size()));
  return filled(asked, view, places, std::move(times), std::move(levels), std::move(notes));
}

/// Levels that are meant by the one of an instrument that is nearest, up to this far.
constexpr double same_instrument_m = 2;

/// The instrument's own levels, nearest to those that are asked for, each once.
std::vector<double> own_levels(const Asked& asked, const ProductView& view,
                               std::vector<std::string>& notes) {
  const std::vector<double>& all = view.levels_m();
  const bool has_levels = vertical_of(*asked.product) != Vertical::none && !all.empty();
  if (!has_levels || !asked.z) return levels_of(asked, view);
  const std::vector<double> wanted =
      levels_asked(*asked.z, all.front() - same_instrument_m, all.back() + same_instrument_m, all,
                   asked.product->station, levels_text(*asked.product, all));
  std::set<double> own;
  bool is_moved = false;
  for (const double level : wanted) {
    const double nearest = *std::min_element(all.begin(), all.end(), [&](double a, double b) {
      return std::abs(a - level) < std::abs(b - level);
    });
    own.insert(nearest);
    is_moved = is_moved || std::abs(nearest - level) > same_level_m;
  }
  if (is_moved)
    notes.emplace_back(
        "given at the levels of the instrument that are nearest to z: each has its "
        "own");
  return {own.begin(), own.end()};
}

/// What was measured, at its own place.
/// @param from  the place that was asked about, where it is one
Answer measured(const std::filesystem::path& store, const Asked& asked,
                const std::optional<GeoPoint>& from) {
  const StoredProduct& product = *asked.product;
  const slackwater::BoundingBox& held = product.bounds;
  const double east = held.east_deg < held.west_deg ? held.east_deg + 360 : held.east_deg;
  const ProductView view(store, product,
                         window_of(asked, {held.west_deg, held.south_deg, east, held.north_deg}));
  std::vector<std::string> notes;
  std::vector<UtcTime> times = times_of(asked, view, notes);
  std::vector<double> levels = own_levels(asked, view, notes);
  const GeoPoint place = point_of(view.longitude_deg().front(), view.latitude_deg().front());
  if (view.longitude_deg().size() * view.latitude_deg().size() > 1)
    notes.emplace_back("the platform was laid anew within 500 m; one of its places is given");
  const std::optional<double> far_m = from ? std::optional(distance_m(*from, place)) : std::nullopt;
  if (far_m && *far_m >= 0.5) {
    notes.push_back(formatted("measured at {}, {:.0f} m from the place that was asked about",
                              position_text(place), *far_m));
  }
  static_cast<void>(moderate_work(asked.parameters.size(),
                                  times.size() * std::max<std::size_t>(1, levels.size()), 1));
  Places places;
  places.point = {place};
  places.longitude_deg = {place.longitude_deg()};
  places.latitude_deg = {place.latitude_deg()};
  Answer answer =
      filled(asked, view, places, std::move(times), std::move(levels), std::move(notes));
  answer.provenance.product->distance_m = far_m;
  return answer;
}

Answer measured_near(const std::filesystem::path& store, const Asked& asked, const Path& points) {
  const StoredProduct& product = *asked.product;
  for (const Vertex& point : points) {
    if (!product.bounds.contains(point_of(point.longitude_deg, point.latitude_deg)))
      throw outside(product, formatted("coords at {:.5f} {:.5f}, too far from the instrument",
                                       point.longitude_deg, point.latitude_deg));
  }
  return measured(store, asked,
                  point_of(points.front().longitude_deg, points.front().latitude_deg));
}

Answer measured_in(const std::filesystem::path& store, const Asked& asked, const AskedArea& shape) {
  const GeoPoint place = place_of(*asked.product);
  const double x = in_box(place.longitude_deg(), shape.box);
  const double y = place.latitude_deg();
  const bool is_in_box = x >= shape.box.west_deg && x <= shape.box.east_deg &&
                         y >= shape.box.south_deg && y <= shape.box.north_deg;
  if (!is_in_box || !shape.is_inside(x, y))
    throw outside(*asked.product, "an area without the instrument");
  return measured(store, asked, std::nullopt);
}

/// The product's own cells in the shape, or an even grid over it.
Axes axes_of(const ProductView& view, const AskedArea& shape, const Box& box,
             const QueryString& query) {
  static_cast<void>(moderate_comparisons(view.longitude_deg().size() * view.latitude_deg().size(),
                                         shape.vertices));
  Axes axes;
  for (const double x : view.longitude_deg()) {
    if (std::any_of(view.latitude_deg().begin(), view.latitude_deg().end(),
                    [&](double y) { return shape.is_inside(x, y); }))
      axes.longitude_deg.push_back(x);
  }
  for (const double y : view.latitude_deg()) {
    if (std::any_of(view.longitude_deg().begin(), view.longitude_deg().end(),
                    [&](double x) { return shape.is_inside(x, y); }))
      axes.latitude_deg.push_back(y);
  }
  if (axes.longitude_deg.empty()) axes = some_place_in(box, shape.is_inside);
  if (const auto count = resolution_in(query, "resolution-x"))
    axes.longitude_deg = even_axis(box.west_deg, box.east_deg, *count);
  if (const auto count = resolution_in(query, "resolution-y"))
    axes.latitude_deg = even_axis(box.south_deg, box.north_deg, *count);
  return axes;
}

Answer over(const std::filesystem::path& store, const Asked& asked, const AskedArea& shape,
            const QueryString& query) {
  const StoredProduct& product = *asked.product;
  if (product.is_measured()) return measured_in(store, asked, shape);
  const slackwater::BoundingBox& held = product.bounds;
  const double east = held.east_deg < held.west_deg ? held.east_deg + 360 : held.east_deg;
  const Box box = shared(shape.box, {held.west_deg, held.south_deg, east, held.north_deg});
  if (box.west_deg > box.east_deg || box.south_deg > box.north_deg)
    throw outside(product, "an area that the product does not reach");
  const auto count_x = resolution_in(query, "resolution-x");
  const auto count_y = resolution_in(query, "resolution-y");
  if (count_x && count_y)
    static_cast<void>(moderate_work(asked.parameters.size(), *count_x * *count_y, 1));
  const ProductView view(store, product, window_of(asked, box));
  std::vector<std::string> notes;
  std::vector<UtcTime> times = times_of(asked, view, notes);
  std::vector<double> levels = levels_of(asked, view);
  if (const auto count = resolution_in(query, "resolution-z"); count && levels.size() > 1)
    levels = even_axis(levels.front(), levels.back(), *count);
  const Axes axes = axes_of(view, shape, box, query);
  const std::size_t cells = axes.longitude_deg.size() * axes.latitude_deg.size();
  static_cast<void>(moderate_work(
      asked.parameters.size(), cells * times.size() * std::max<std::size_t>(1, levels.size()), 1));
  static_cast<void>(moderate_comparisons(cells, shape.vertices));
  Places places;
  places.is_grid = true;
  places.longitude_deg = axes.longitude_deg;
  places.latitude_deg = axes.latitude_deg;
  for (std::size_t j = 0; j < axes.latitude_deg.size(); ++j) {
    for (std::size_t i = 0; i < axes.longitude_deg.size(); ++i) {
      const double x = axes.longitude_deg[i];
      const double y = axes.latitude_deg[j];
      if (!shape.is_inside(x, y)) continue;
      places.point.push_back(point_of(x, y));
      places.cell.push_back(j * axes.longitude_deg.size() + i);
    }
  }
  return filled(asked, view, places, std::move(times), std::move(levels), std::move(notes));
}

std::string needed(const QueryString& query, std::string_view name, std::string_view example) {
  const auto text = query.find(name);
  if (!text) throw bad_parameter(name, "nothing", example);
  return std::string(*text);
}

}  // namespace

Answer product_answer(const std::filesystem::path& store, const StoredProduct& product,
                      const QueryType& type, const QueryString& query) {
  Asked asked = asked_of(product, query);
  if (type.name == "cube") {
    const BoundingBox cube =
        parse_bbox(needed(query, "bbox", "west,south,east,north, e.g. 2.0,53.0,2.5,53.4"));
    if (vertical_of(product) == Vertical::none) {
      asked.z.reset();  // EDR 1.1 asks for z with every cube: here there is nothing to cut by it
    } else if (!asked.z && cube.levels) {
      asked.z = formatted("{}/{}", cube.levels->low, cube.levels->high);
    } else if (!asked.z) {
      throw bad_parameter("z", "nothing", "levels of the cube, e.g. 0/50 or 0,10,20");
    }
    return over(store, asked, shape_of(cube.box), query);
  }
  const std::string coords = needed(query, "coords", "Well Known Text, e.g. POINT(-2.55 48.85)");
  if (type.name == "area") {
    return over(
        store, asked,
        shape_of(parse_wkt("coords", coords, {GeometryType::polygon, GeometryType::multi_polygon})),
        query);
  }
  if (type.name == "radius") {
    const Geometry centre = parse_wkt("coords", coords, {GeometryType::point});
    const Vertex& middle = centre.parts.front().front().front();
    const double radius_m =
        parse_distance_m("within", needed(query, "within", "a distance, e.g. 5"), "within-units",
                         needed(query, "within-units", "a unit, e.g. km"));
    return over(store, asked, circle(middle.longitude_deg, middle.latitude_deg, radius_m), query);
  }
  const Geometry geometry =
      parse_wkt("coords", coords, {GeometryType::point, GeometryType::multi_point});
  const Path& points = geometry.parts.front().front();
  return at_points(store, asked, points,
                   geometry.has_vertical && !asked.z && vertical_of(product) != Vertical::none);
}

Answer product_answer_at(const std::filesystem::path& store, const StoredProduct& product,
                         const GeoPoint& place, const QueryString& query) {
  Vertex at;
  at.longitude_deg = place.longitude_deg();
  at.latitude_deg = place.latitude_deg();
  return at_points(store, asked_of(product, query), {at}, false);
}

}  // namespace slackwater::api::edr
