#pragma once
#include <filesystem>

#include "fields/base/time.h"
#include "ingest/ais/report.h"
#include "twin/traffic/alarms.h"

namespace slackwater::api {

/// How vessels are judged by what AIS tells: `data/traffic/rule.yaml`, where each number has its
/// source.
struct TrafficRule {
  double reach_m = 0;                ///< vessels further from the site are left out
  twin::AlarmLimits alarm{};         ///< a vessel that passes nearer and sooner is marked
  double class_a_under_way_m_s = 0;  ///< faster ones report often
  double class_b_under_way_m_s = 0;
  Duration fresh_under_way{};  ///< a last report so old is carried on
  Duration fresh_at_rest{};
  Duration shown{};      ///< an older one is not
  double still_m_s = 0;  ///< slower ones lie still
  Duration way{};        ///< how far ahead its way is told
  Duration silent{};     ///< without any report the receiver is called silent
};

/// @throws Error(not_found), Error(invalid_input) that names the line
[[nodiscard]] TrafficRule read_traffic_rule(const std::filesystem::path& file);

/// How long a report of such a vessel is fresh; a speed that is not known is that of one under way.
[[nodiscard]] Duration fresh_for(const TrafficRule& rule, ingest::AisClass speaker,
                                 const std::optional<double>& speed_m_s) noexcept;

}  // namespace slackwater::api
