#pragma once
#include <string>

#include "api/ask/windows/windows.h"
#include "fields/service/snapshot.h"

namespace slackwater::api {

/// What the limits of a task rest on, from one time to another, that nobody forecast: "the waves
/// are the last known sea, kept". Waves that are computed from a forecast wind are forecast. Empty
/// where all of it is.
[[nodiscard]] std::string unforecast(const Snapshot& forecast, const TaskWindows& task,
                                     UtcTime from, UtcTime to);

/// The most that a start is worth which rests on such a thing: less than a go, whatever its
/// probability.
[[nodiscard]] double most_worth_unforecast(const twin::VerdictRule& rule) noexcept;

}  // namespace slackwater::api
