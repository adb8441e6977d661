#include "calibration/day/column/tide_of_record.h"

#include <algorithm>

#include "calibration/fuse/fusion_settings.h"
#include "fields/record/slice.h"

namespace slackwater::calibration {
namespace {

bool is_detided(const Origin* origin) { return origin->rank.has_tide == false; }

/// Whether what speaks at a time lacks the tide.
bool lacks_tide(const std::vector<Stretch>& stretches, UtcTime time) {
  const Duration reach = FusionSettings{}.widest_gap;
  bool lacks = false;
  for (const Stretch& stretch : stretches) {
    if (time < stretch.from - reach || time > stretch.to + reach) continue;
    if (!is_detided(stretch.origin)) return false;
    lacks = true;
  }
  return lacks;
}

}  // namespace

std::optional<UtcTime> tide_since(const Chosen<Horizontal>& known, UtcDay day) {
  const auto is_any = [&](const auto& list, const auto& origin_of) {
    return std::any_of(list.begin(), list.end(),
                       [&](const auto& one) { return is_detided(origin_of(one)); });
  };
  if (known.stretches.empty()) {
    const bool lacks = is_any(known.origin, [](const Origin* origin) { return origin; });
    return lacks ? std::nullopt : std::optional(UtcTime::min());
  }
  if (!is_any(known.stretches, [](const Stretch& stretch) { return stretch.origin; }))
    return UtcTime::min();
  const UtcTime end = UtcTime(day) + std::chrono::days(1);
  UtcTime since = UtcTime::min();
  for (const TimeCell& cell : known.column.time) {
    const UtcTime centre = cell.centre();
    if (centre > end || !lacks_tide(known.stretches, centre)) continue;
    if (cell.end > UtcTime(day)) return std::nullopt;
    since = centre + Duration(1);
  }
  return since;
}

FittedTide tide_of_record(const Chosen<Horizontal>& known, UtcDay day, Angle latitude) {
  const auto since = tide_since(known, day);
  if (!since) {
    const auto detided = std::find_if(known.origin.begin(), known.origin.end(), is_detided);
    FittedTide none;
    std::string note = "no tide is fitted or carried on: the currents";
    if (detided != known.origin.end()) note.append(" of ").append((*detided)->product_id);
    none.notes.push_back(note.append(" are detided"));
    return none;
  }
  if (*since == UtcTime::min()) return fit_column_tide(known.column, latitude);
  FittedTide tide = fit_column_tide(slice(known.column, *since, UtcTime::max()), latitude);
  tide.since = *since;
  std::string note = "tide of the record since ";
  note.append(format_utc(*since)).append(": the currents before that have no tide in them");
  tide.notes.insert(tide.notes.begin(), std::move(note));
  return tide;
}

}  // namespace slackwater::calibration
