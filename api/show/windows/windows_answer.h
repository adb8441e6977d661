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
/// What stops a start, or comes nearest to it: "surveyor: current at most 0.5 m/s, exceeded at
/// 09:10 in 20 of 25 futures (forecast up to 118 % of it)".
/// @param clock  how people read a time
[[nodiscard]] std::string binding_text(const TaskWindows& task, const TaskStart& start,
                                       std::size_t members,
                                       const std::function<std::string(UtcTime)>& clock);
/// What keeps a start from being worth more: what stopped its flights where they say less than its
/// limits, else `binding_text`.
[[nodiscard]] std::string stopping_text(const TaskWindows& task, const TaskStart& start,
                                        std::size_t members,
                                        const std::function<std::string(UtcTime)>& clock);
/// For people: the answer of each task first, then what it rests on.
[[nodiscard]] std::string windows_text(const WindowsQuestion& question,
                                       const WindowsAnswer& answer);

}  // namespace slackwater::api
