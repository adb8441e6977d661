#include "fields/record/run_steps.h"

namespace slackwater {

Duration usual_step(std::span<const UtcTime> times) {
  if (times.size() < 2) return Duration(0);
  std::vector<Duration> pauses;
  pauses.reserve(times.size() - 1);
  for (std::size_t i = 1; i < times.size(); ++i) pauses.push_back(times[i] - times[i - 1]);
  const auto middle = pauses.begin() + static_cast<std::ptrdiff_t>(pauses.size() / 2);
  std::nth_element(pauses.begin(), middle, pauses.end());
  return *middle;
}

}  // namespace slackwater
