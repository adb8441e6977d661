#include "twin/scenario/write_conduct.h"

#include <cmath>

#include "twin/scenario/write_number.h"

namespace slackwater::twin {
namespace {

YamlValue range_value(const Range& range, double unit) {
  return YamlValue::numbers({multiple_for(range.low, unit), multiple_for(range.high, unit)});
}

/// Of angles that a reader multiplies by pi/180.
YamlValue sector_value(const Range& range) {
  return YamlValue::numbers({degrees_for(range.low), degrees_for(range.high)});
}

YamlValue table_value(const HeightTable& table) {
  YamlValue value;
  const std::size_t periods = table.peak_period_s.size();
  if (periods > 0) value.put("peak_period_s", YamlValue::numbers(table.peak_period_s));
  const auto bounds = [&](std::size_t row) -> YamlValue {
    if (periods == 0) return table.at_most_m[row];
    const auto first = table.at_most_m.begin() + static_cast<std::ptrdiff_t>(row * periods);
    return YamlValue::numbers({first, first + static_cast<std::ptrdiff_t>(periods)});
  };
  if (table.off_bow_rad.empty()) {
    value.put("at_most", bounds(0));
    return value;
  }
  std::vector<YamlValue> rows;
  for (std::size_t row = 0; row < table.off_bow_rad.size(); ++row) {
    rows.emplace_back();
    rows.back().put("from_bow_deg", degrees_for(table.off_bow_rad[row]));
    rows.back().put("at_most", bounds(row));
  }
  value.put("rows", std::move(rows));
  return value;
}

YamlValue limit_value(const Limit& limit) {
  YamlValue value;
  value.put((limit.is_least ? "least_" : "") + std::string(word_of(limit.variable).key),
            limit.table ? table_value(*limit.table) : YamlValue(limit.bound));
  if (limit.table && limit.table->heading_rad)
    value.put("heading_deg", degrees_for(*limit.table->heading_rad));
  if (limit.down_m && *limit.down_m < 0) value.put("at_height_m", -*limit.down_m);
  if (limit.down_m && *limit.down_m >= 0) value.put("at_depth_m", *limit.down_m);
  if (limit.waves) {
    const WaveSector& waves = *limit.waves;
    if (waves.off_bow_rad) value.put("from_bow_deg", sector_value(*waves.off_bow_rad));
    if (waves.heading_rad) value.put("heading_deg", degrees_for(*waves.heading_rad));
    if (waves.peak_period_s)
      value.put("peak_period_between_s", range_value(*waves.peak_period_s, 1));
  }
  if (limit.phases != PhaseSet{}) {
    std::vector<std::string> phases;
    for (std::size_t i = 0; i < phase_count; ++i)
      if (const auto phase = static_cast<Phase>(i); limit.phases.has(phase))
        phases.emplace_back(name_of(phase));
    value.put("phases", YamlValue::words(phases));
  }
  if (limit.may_be_missing) value.put("if_missing", "not_checked");
  if (!limit.source.empty()) value.put("source", limit.source);
  if (!limit.status.empty()) value.put("status", limit.status);
  return value;
}

YamlValue fault_value(const Fault& fault) {
  YamlValue value;
  value.put("fault", name_of(fault.kind)).put("at_s", fault.from_s);
  if (std::isfinite(fault.to_s))
    value.put("for_s", number_for(fault.to_s, fault.to_s - fault.from_s,
                                  [&](double for_s) { return fault.from_s + for_s; }));
  if (fault.kind == FaultKind::lost_thruster)
    value.put("thruster", static_cast<double>(fault.thruster));
  return value;
}

YamlValue search_value(const PersonSearch& search) {
  YamlValue value;
  value.put("person", search.person)
      .put("object", search.object)
      .put("lookout", search.lookout)
      .put("radius_m", search.radius_m)
      .put("elapsed_s", search.elapsed_s)
      .put("diffusivity_m2_s", search.diffusivity_m2_s)
      .put("visibility_m", search.visibility_m);
  if (search.last_known_m) value.put("last_known", plan_value(*search.last_known_m));
  return value;
}

YamlValue mammals_value(const MammalDuty& duty) {
  YamlValue value;
  value.put("animals", duty.animals)
      .put("animal", duty.animal)
      .put("watch", duty.watch)
      .put("count", static_cast<double>(duty.count))
      .put("half_side_m", duty.half_side_m)
      .put("radius_m", duty.noise.radius_m)
      .put("clear_for_s", duty.noise.watch_s)
      .put("noise_for_s", duty.noise.wanted_s);
  if (duty.noise_m) value.put("noise", plan_value(*duty.noise_m));
  if (duty.again_after_s) value.put("again_after_s", *duty.again_after_s);
  return value;
}

/// As they are where nothing was said, they are left out: beside some autonomies they are refused.
void put_pilot(const Conduct& conduct, YamlValue& value) {
  const PilotHand& hand = conduct.pilot;
  if (hand != PilotHand{}) {
    YamlValue pilot;
    pilot.put("wander_m", hand.wander_m).put("memory_s", hand.memory_s).put("haste", hand.haste);
    value.put("pilot", pilot);
  }
  const Envelope& limits = conduct.envelope;
  if (limits != Envelope{}) {
    YamlValue envelope;
    if (limits.most_speed_m_s > 0) envelope.put("most_speed_m_s", limits.most_speed_m_s);
    envelope.put("stand_off_m", limits.stand_off_m);
    if (limits.fence_m) envelope.put("fence_m", *limits.fence_m);
    value.put("envelope", envelope);
  }
}

void put_list(const char* key, std::vector<YamlValue> list, YamlValue& value) {
  if (!list.empty()) value.put(key, std::move(list));
}

}  // namespace

YamlValue conduct_value(const Conduct& conduct) {
  const Conduct usual;
  YamlValue value;
  if (conduct.autonomy != usual.autonomy) value.put("autonomy", name_of(conduct.autonomy));
  if (conduct.tick_s != usual.tick_s) value.put("tick_s", conduct.tick_s);
  if (conduct.home_m) value.put("home", place_value(*conduct.home_m));
  value.put("clear_m", conduct.clear_m);
  YamlValue reserve;
  reserve.put("share", conduct.reserve.share).put("margin", conduct.reserve.margin);
  value.put("reserve", reserve);
  YamlValue holding;
  holding.put("resume_after_s", conduct.holding.resume_after_s)
      .put("overlap_m", conduct.holding.overlap_m);
  value.put("holding", holding);
  put_pilot(conduct, value);
  if (conduct.deck_point_m) value.put("deck_point", on_board_value(*conduct.deck_point_m));
  std::vector<YamlValue> limits, faults;
  for (const Limit& limit : conduct.limits) limits.push_back(limit_value(limit));
  for (const Fault& fault : conduct.faults) faults.push_back(fault_value(fault));
  put_list("limits", std::move(limits), value);
  put_list("faults", std::move(faults), value);
  if (!conduct.assumed.empty()) {
    YamlValue assume;
    for (const Assumption& one : conduct.assumed) assume.put(word_of(one.variable).key, one.value);
    value.put("assume", assume);
  }
  if (conduct.search) value.put("search", search_value(*conduct.search));
  if (conduct.mammals) {
    value.put("mammals", mammals_value(*conduct.mammals));
    if (!conduct.mammals->noise_by.empty()) value.put("noise_by", conduct.mammals->noise_by);
  }
  if (conduct.cleaning) value.put("cleaning", cleaning_value(*conduct.cleaning));
  if (conduct.inspection) value.put("inspection", inspection_value(*conduct.inspection));
  if (conduct.behaviour != standard_behaviour())
    value.put("behaviour", behaviour_value(conduct.behaviour));
  return value;
}

}  // namespace slackwater::twin
