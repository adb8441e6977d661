#include "api/ask/plan/day_chances.h"

namespace slackwater::api {

const DayChances::Task* DayChances::find(const std::string& wanted,
                                         const std::string& turbine) const {
  const Task* of_all = nullptr;
  for (const Task& one : tasks) {
    if (one.task != wanted) continue;
    if (one.turbine == turbine) return &one;
    if (!one.turbine) of_all = &one;
  }
  return of_all;
}

Duration duration_of_hours(double hours) {
  return std::chrono::duration_cast<Duration>(
      std::chrono::duration<double, std::ratio<3600>>(hours));
}

}  // namespace slackwater::api
