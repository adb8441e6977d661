#pragma once
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "api/ask/windows/windows.h"

namespace slackwater::api {

/// For programs: api/docs/json.md has the schema.
[[nodiscard]] nlohmann::json windows_json(const WindowsQuestion& question,
                                          const WindowsAnswer& answer);
/// `left_out` in JSON.
[[nodiscard]] nlohmann::json left_out_json(const std::vector<TaskLeftOut>& left_out);
/// "go", or "go, 3 unchecked" where so many of its limits nobody checked: those that only a run
/// shows count until its best start was flown.
[[nodiscard]] std::string verdict_and_unchecked(const TaskWindows& task);
/// The same at the beginning of a line: as wide as the widest verdict, or with a colon behind it.
[[nodiscard]] std::string verdict_first(const TaskWindows& task);
/// The bound of the limit that binds a start, of one with a table: "1.2 m at a peak period of 9 s,
/// waves 40 degrees off the bow"; empty of others.
[[nodiscard]] std::string bound_then_text(const TaskWindows& task, const TaskStart& start);
/// What stops a start, or comes nearest to it: "current at most 0.5 m/s (surveyor), exceeded
/// at 09:10 in 20 of 25 futures (forecast up to 118 % of it)".
/// @param clock  how people read a time
[[nodiscard]] std::string binding_text(const TaskWindows& task, const TaskStart& start,
                                       const std::function<std::string(UtcTime)>& clock);
/// What keeps a start from being worth more: what stopped its flights where they say less than its
/// limits, else `binding_text`.
[[nodiscard]] std::string stopping_text(const TaskWindows& task, const TaskStart& start,
                                        const std::function<std::string(UtcTime)>& clock);
/// "the ways of the crew transfer vessel (1.2 h each) and the transfers (15 min each) are in the
/// chances"; empty where a site says nothing of a vessel.
[[nodiscard]] std::string access_text(const WindowsAnswer& answer);
/// For people: the answer of each task first, then what it rests on.
[[nodiscard]] std::string windows_text(const WindowsQuestion& question,
                                       const WindowsAnswer& answer);

}  // namespace slackwater::api
