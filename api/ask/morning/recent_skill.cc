#include "api/ask/morning/recent_skill.h"

#include <algorithm>
#include <array>
#include <optional>

namespace slackwater::api {
namespace {

using calibration::SkillEntry;

struct Spoken {
  const char* variable;
  const char* words;
  const char* unit;
};
constexpr std::array spoken{Spoken{calibration::current_variable, "current", "m/s"},
                            Spoken{calibration::wind_variable, "wind", "m/s"},
                            Spoken{calibration::wave_variable, "wave height", "m"}};

}  // namespace

std::vector<RecentSkill> trust_of(const std::vector<SkillEntry>& entries, WindPolicy wind) {
  std::vector<RecentSkill> out;
  for (const Spoken& say : spoken)
    if (auto verdict =
            calibration::verdict_of(entries, wind, ForecastOrigin::forecast, say.variable))
      out.push_back({say.words, say.unit, std::move(*verdict)});
  return out;
}

std::vector<SkillEntry> newest_day_of(const std::vector<SkillEntry>& entries, WindPolicy wind) {
  std::optional<UtcDay> newest;
  for (const SkillEntry& entry : entries)
    if (entry.wind == wind && entry.origin == ForecastOrigin::forecast)
      newest = std::max(newest.value_or(entry.day), entry.day);
  std::vector<SkillEntry> out;
  for (const SkillEntry& entry : entries)
    if (entry.day == newest) out.push_back(entry);
  return out;
}

}  // namespace slackwater::api
