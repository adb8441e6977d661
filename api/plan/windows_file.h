#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fields/base/time.h"

namespace slackwater::api {

/// The chances of a day's starts, as `slackwater windows --json` has them. Keys that are not named
/// here may stand beside:
///
///     {"site": "example_farm", "day": "2025-06-02", "tasks": [
///       {"task": "cp_anode", "turbine": "A01", "duration_h": 3.0, "contingency_h": 1.0,
///        "starts": [{"start": "2025-06-02T06:00:00Z", "probability": 0.93,
///                    "duration_h": {"p50": 3.0, "p90": 3.4}, "energy_wh": {"p90": 180}}]}]}
///
/// `worth`, where a start has it, goes before its `probability`. `turbine` may be absent: then it
/// is of all. `duration_h` and `energy_wh` are a number, or an object whose `p90` is planned with;
/// those of a start go before those of the task.
struct WindowsFile {
  struct Start {
    UtcTime time{};
    double probability = 0;
    Duration duration{};  ///< that is planned with; more than 0
    double energy_wh = 0;
  };
  struct Task {
    std::string task;
    std::optional<std::string> turbine;
    Duration contingency{0};
    std::vector<Start> starts;  ///< by time, each once
  };
  std::string name;  ///< where it was read, for messages
  std::string site;
  UtcDay day{};
  std::vector<Task> tasks;

  /// What there is of a task at a turbine, else of the task at all of them; nothing where neither.
  [[nodiscard]] const Task* find(const std::string& task, const std::string& turbine) const;
};

/// @throws Error(invalid_input) that names the place in the document
[[nodiscard]] WindowsFile parse_windows(std::string_view json, std::string name);
/// "-" is standard input. @throws Error(not_found) too
[[nodiscard]] WindowsFile load_windows(const std::filesystem::path& file);

}  // namespace slackwater::api
