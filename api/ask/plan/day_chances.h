#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fields/base/time.h"

namespace slackwater::api {

/// The chances of a day's starts, which a plan is made from.
struct DayChances {
  struct Start {
    UtcTime time{};
    double probability = 0;
    Duration duration{};  ///< that is planned with; more than 0
    double energy_wh = 0;
    friend bool operator==(const Start&, const Start&) = default;
  };
  struct Task {
    std::string task;
    std::optional<std::string> turbine;  ///< absent: all of them
    Duration contingency{0};
    std::vector<Start> starts;  ///< by time, each once
    std::string impossible;     ///< why it could not be worked out; then there are no starts
    friend bool operator==(const Task&, const Task&) = default;
  };
  std::string name;  ///< where they come from, for messages
  std::string site;
  UtcDay day{};
  std::vector<Task> tasks;

  /// What there is of a task at a turbine, else of the task at all of them; nothing where neither.
  [[nodiscard]] const Task* find(const std::string& task, const std::string& turbine) const;
};

/// A number of hours as a duration, to the millisecond.
[[nodiscard]] Duration duration_of_hours(double hours);

}  // namespace slackwater::api
