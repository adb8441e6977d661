#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "api/ask/plan/day_chances.h"

namespace slackwater::api {

/// Reads the chances of a day's starts from a file that a user gives, as `slackwater windows
/// --json` writes it. Keys that are not named here may stand beside:
///
///     {"site": "example_farm", "day": "2025-06-02", "tasks": [
///       {"task": "cp_anode", "turbine": "A01", "duration_h": 3.0, "contingency_h": 1.0,
///        "starts": [{"start": "2025-06-02T06:00:00Z", "probability": 0.93,
///                    "duration_h": {"p50": 3.0, "p90": 3.4}, "energy_wh": {"p90": 180}}]}]}
///
/// `worth`, where a start has it, goes before its `probability`. `turbine` may be absent: then it
/// is of all. `duration_h` and `energy_wh` are a number, or an object whose `p90` is planned with;
/// those of a start go before those of the task.
/// @param file  "-" is standard input
/// @throws Error(not_found); Error(invalid_input) that names the place in the document
[[nodiscard]] DayChances load_windows(const std::filesystem::path& file);
/// The same of its text. @param name  where it was read, for messages
[[nodiscard]] DayChances parse_windows(std::string_view json, std::string name);

}  // namespace slackwater::api
