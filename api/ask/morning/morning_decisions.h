#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "api/ask/decisions/decisions.h"

namespace slackwater::api {

/// What was decided at a site, as the morning of a day tells it.
struct MorningDecisions {
  /// Those that count and whose starts are on the days of the morning, in order of start: by the
  /// name that the windows have for their task, else by their own.
  std::map<std::string, std::vector<DecisionAnswer>> by_task;
  DecisionsRecord record;  ///< of the last 90 days
};
/// How far back the record of a morning goes: a season, and few enough to be worked out at once.
inline constexpr std::chrono::days record_goes_back{90};

/// Nothing where the store holds no decision of these days, or there is no store.
/// @param windows  of the morning, its question beside it, whose shift counts in what came too
/// @param from     of the first day that the morning speaks of
/// @throws as `decisions_of`
[[nodiscard]] std::optional<MorningDecisions> morning_decisions(
    const WindowsQuestion& question, const WindowsAnswer& windows, UtcTime from, UtcTime known_by,
    const std::filesystem::path& store_folder);

}  // namespace slackwater::api
