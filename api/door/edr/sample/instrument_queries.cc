#include "api/door/edr/sample/instrument_queries.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "api/door/edr/sample/product_filled.h"
#include "api/door/edr/sample/work.h"
#include "fields/base/text.h"

namespace slackwater::api::edr {
namespace {

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
  const ProductView view(store, product, window_of(asked, box_of(product)));
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

}  // namespace

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

}  // namespace slackwater::api::edr
