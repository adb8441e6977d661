#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "api/door/desk/site_answers.h"

namespace slackwater::api::desk {

/// The windows and the plan of a site as they would be with other texts, or other words. Nothing of
/// it is saved.
///
///     {"texts": {"site": YAML, "tasks": {"blade_scan": YAML}, "plan": YAML}, "query": "shift=..."}
///
/// Each text stands for the one of `texts_of_site`; those that are not there stay as they are.
/// @return {"windows": as `windows_answer`, "plan": as `plan_answer` or null, "no_plan": why}
/// @throws Error(usage), Error(invalid_input) for what cannot be read, as the commands say it
[[nodiscard]] nlohmann::json what_if(const Answers& from, const std::string& site,
                                     const std::string& body);

}  // namespace slackwater::api::desk
