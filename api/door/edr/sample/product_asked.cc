#include "api/door/edr/sample/product_asked.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "api/door/edr/read/bad_parameter.h"
#include "api/door/edr/read/datetime.h"
#include "api/door/edr/read/parameter_names.h"
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

}  // namespace

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

std::string levels_text(const StoredProduct& product, const std::vector<double>& levels_m) {
  const char* kind = vertical_of(product) == Vertical::height_up ? "height" : "depth";
  if (levels_m.size() == 1) return formatted("{} {:g} m alone", kind, levels_m.front());
  return formatted("{} {:g} to {:g} m", kind, levels_m.front(), levels_m.back());
}

bool is_held(double level_m, const std::vector<double>& levels_m) {
  return level_m >= levels_m.front() - same_level_m && level_m <= levels_m.back() + same_level_m;
}

std::vector<double> levels_of(const Asked& asked, const ProductView& view, const Path& own) {
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

GeoPoint point_of(double longitude_deg, double latitude_deg) {
  return GeoPoint::from_degrees(latitude_deg, std::remainder(longitude_deg, 360.0));
}

ProductWindow window_of(const Asked& asked, const Box& box) {
  return {box.west_deg, box.south_deg, box.east_deg, box.north_deg, asked.from, asked.to};
}

Box box_of(const StoredProduct& product) {
  const slackwater::BoundingBox& held = product.bounds;
  const double east_deg = held.east_deg < held.west_deg ? held.east_deg + 360 : held.east_deg;
  return {held.west_deg, held.south_deg, east_deg, held.north_deg};
}

}  // namespace slackwater::api::edr
