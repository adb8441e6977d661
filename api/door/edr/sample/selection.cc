#include "api/door/edr/sample/selection.h"

#include <algorithm>
#include <cmath>

#include "api/door/edr/read/bad_parameter.h"
#include "api/door/edr/read/datetime.h"
#include "api/door/edr/read/parameter_names.h"
#include "api/door/edr/read/vertical.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api::edr {
namespace {

std::string vertical_text(const Selection& s) {
  const auto [low, high] = vertical_range(*s.collection, *s.field);
  return formatted("{} {:g} to {:g} m",
                   s.collection->vertical == Vertical::height_up ? "height" : "depth", low, high);
}

}  // namespace

Selection select(const Collection& collection, const IssuedForecast& forecast,
                 std::shared_ptr<const Field> field, const QueryString& query) {
  Selection s;
  s.collection = &collection;
  const Snapshot& snapshot = field->snapshot();
  if (!is_offered_by(collection, snapshot)) {
    throw Error(ErrorKind::not_found,
                "found no sea level in the forecast " + forecast.instance +
                    ": the products it was made from held none, or too "
                    "little of one for a tide; other collections have values");
  }
  const std::vector<Parameter> all = parameters_of(collection, snapshot.members);
  if (const auto wanted = query.find("parameter-name")) {
    std::vector<std::string> names;
    names.reserve(all.size());
    for (const Parameter& parameter : all) names.push_back(parameter.name);
    s.parameters = parse_parameter_names(*wanted, names);
  } else {
    for (std::size_t i = 0; i < all.size(); ++i) s.parameters.push_back(i);
  }
  for (const std::size_t i : s.parameters) s.answer.parameters.push_back(all[i]);
  s.answer.collection = collection.id;
  s.answer.title = collection.title + " at " + snapshot.site_name;
  s.answer.vertical = collection.vertical;
  s.answer.provenance = {snapshot.site_id,      forecast.instance,        snapshot.issued,
                         snapshot.day,          snapshot.headline,        snapshot.degraded,
                         snapshot.attributions, forecast.row.code_version};
  s.field = std::move(field);
  return s;
}

std::vector<UtcTime> times_of(const Selection& s, const QueryString& query) {
  const std::vector<UtcTime>& stamps = s.field->snapshot().time;
  const auto text = query.find("datetime");
  if (!text) return stamps;
  const TimeRange asked = parse_datetime(*text);
  const UtcTime from = std::max(asked.from.value_or(stamps.front()), stamps.front());
  const UtcTime to = std::min(asked.to.value_or(stamps.back()), stamps.back());
  if (from > to) {
    throw Error(ErrorKind::not_found, "datetime: found " + shown(*text) + "; this forecast holds " +
                                          format_utc(stamps.front()) + "/" +
                                          format_utc(stamps.back()));
  }
  if (asked.is_instant()) return {from};
  std::vector<UtcTime> times;
  for (const UtcTime stamp : stamps) {
    if (from <= stamp && stamp <= to) times.push_back(stamp);
  }
  if (times.empty()) times = {from, to};
  return times;
}

std::vector<double> verticals_of(const Selection& s, const QueryString& query, double bed_m) {
  const auto text = query.find("z");
  if (s.collection->vertical == Vertical::none) {
    if (text && !text->empty()) {
      throw Error(ErrorKind::usage, "z: found " + shown(*text) + "; the collection " +
                                        s.collection->id + " has no vertical; leave z out");
    }
    return {constants::nan};
  }
  if (!text) {
    std::vector<double> levels = native_levels(*s.collection, *s.field);
    if (s.collection->vertical == Vertical::depth_down) {
      std::erase_if(levels, [&](double depth) { return depth > bed_m; });
      if (levels.empty()) levels = {0.0};
    }
    return levels;
  }
  const auto [low, high] = vertical_range(*s.collection, *s.field);
  return levels_asked(*text, low, high, all_levels(*s.collection, *s.field), "this forecast",
                      vertical_text(s));
}

std::vector<double> levels_asked(std::string_view z, double low, double high,
                                 std::vector<double> all, std::string_view holder,
                                 const std::string& held) {
  const auto outside = [&] {
    return Error(ErrorKind::not_found,
                 "z: found " + shown(z) + "; " + std::string(holder) + " holds " + held);
  };
  const VerticalQuery asked = parse_vertical(z);
  if (const auto* levels = std::get_if<Levels>(&asked)) {
    const bool any = std::any_of(levels->begin(), levels->end(),
                                 [&](double level) { return level >= low && level <= high; });
    if (!any) throw outside();
    return *levels;
  }
  const auto& range = std::get<LevelRange>(asked);
  const double from = std::max(range.low, low);
  const double to = std::min(range.high, high);
  if (from > to) throw outside();
  std::erase_if(all, [&](double level) { return level < from || level > to; });
  if (all.empty()) {
    all = {from};
    if (to > from) all.push_back(to);
  }
  return all;
}

std::vector<std::string> notes_of(const Absences& absences, const Field& field) {
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < absences.count.size(); ++i) {
    if (absences.count[i] == 0) continue;
    const auto status = static_cast<SampleStatus>(i);
    notes.push_back(std::to_string(absences.count[i]) + " places and times without a value: " +
                    std::string(name_of(status)) + "; valid: " + field.range().text());
  }
  if (absences.carried > 0) {
    notes.push_back(std::to_string(absences.carried) +
                    " currents lie between the deepest level that the product knows there and the "
                    "bed: they carry the current of that level");
  }
  if (absences.too_steep > 0) {
    notes.push_back(
        std::to_string(absences.too_steep) +
        " sea states are steeper than real waves (2 pi Hs/(g Tp^2) above 1/15 for 8 s, 1/25 for 15 "
        "s and longer; DNV-RP-C205): given as in the product, use them with care");
  }
  return notes;
}

void expect_known(const QueryString& query, std::span<const std::string_view> known) {
  for (const auto& [key, value] : query.all()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    throw Error(ErrorKind::usage, "found the query parameter '" + shown(key) +
                                      "'; this query takes " + joined(known, ", "));
  }
}

}  // namespace slackwater::api::edr
