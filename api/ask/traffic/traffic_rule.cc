#include "api/ask/traffic/traffic_rule.h"

#include "fields/base/config.h"

namespace slackwater::api {
namespace {

constexpr double knot_m_s = ingest::metres_per_second_of_knot;

Duration seconds_in(const Config& config, std::string_view key, double unit_s) {
  return Duration(static_cast<Duration::rep>(1000 * unit_s *
                                             config.number(key, {1 / unit_s, 86'400 / unit_s})));
}

}  // namespace

TrafficRule read_traffic_rule(const std::filesystem::path& file) {
  const Config config = Config::load(file);
  TrafficRule rule;
  rule.reach_m = 1000 * config.number("reach_km", {0.1, 200});
  const Config alarm = config.child("alarm");
  rule.alarm.distance_m = alarm.number("cpa_m", {1, 100'000});
  rule.alarm.time_s = 60 * alarm.number("tcpa_min", {0.1, 1440});
  const Config under_way = config.child("under_way");
  rule.class_a_under_way_m_s = knot_m_s * under_way.number("class_a_above_kn", {0, 50});
  rule.class_b_under_way_m_s = knot_m_s * under_way.number("class_b_above_kn", {0, 50});
  rule.fresh_under_way = seconds_in(under_way, "fresh_s", 1);
  rule.fresh_at_rest = seconds_in(config.child("at_rest"), "fresh_s", 1);
  rule.shown = seconds_in(config, "shown_min", 60);
  rule.still_m_s = knot_m_s * config.number("still_below_kn", {0, 5});
  rule.way = seconds_in(config, "way_min", 60);
  rule.silent = seconds_in(config, "silent_s", 1);
  config.expect_all_read();
  if (rule.fresh_at_rest > rule.shown || rule.fresh_under_way > rule.shown)
    config.refuse("shown_min", "found less than fresh_s, expected more");
  return rule;
}

Duration fresh_for(const TrafficRule& rule, ingest::AisClass speaker,
                   const std::optional<double>& speed_m_s) noexcept {
  const double under_way =
      speaker == ingest::AisClass::b ? rule.class_b_under_way_m_s : rule.class_a_under_way_m_s;
  return speed_m_s && *speed_m_s <= under_way ? rule.fresh_at_rest : rule.fresh_under_way;
}

}  // namespace slackwater::api
