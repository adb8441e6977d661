#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "api/ask/windows/windows.h"

// How chances came true on past mornings.

namespace slackwater::api {

/// "38 past mornings: starts were given 26 % on average, and 33 % held; these chances are corrected
/// by that. 9 of 9 goes held; on 4 other mornings the best start held."; empty where nothing is
/// known of any.
[[nodiscard]] std::string past_text(const TaskWindows& task);
/// Of all tasks of an answer: "of 40 goes 38 held; 6 times the best start of a task that was not a
/// go held, over 38 past mornings"; what there is to say where nothing is known.
[[nodiscard]] std::string past_text(const WindowsAnswer& answer);
/// `past` of a task; null where nothing is known.
[[nodiscard]] nlohmann::json past_json(const TaskWindows& task);

}  // namespace slackwater::api
