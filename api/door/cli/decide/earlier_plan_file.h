#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "api/ask/plan/plan_change.h"

namespace slackwater::api {

/// Reads what `slackwater plan --json` printed.
/// @throws Error(invalid_input) that names the place in the document; Error(not_found)
[[nodiscard]] EarlierPlan load_earlier_plan(const std::filesystem::path& file);
[[nodiscard]] EarlierPlan parse_earlier_plan(std::string_view json, std::string name);

}  // namespace slackwater::api
