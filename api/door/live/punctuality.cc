#include "api/door/live/punctuality.h"

#include <algorithm>

#include "fields/base/text.h"

namespace slackwater::live {

void Punctuality::begin(std::optional<WallClock::time_point> due, WallClock::time_point now) {
  if (!due) return;
  const double behind_s = std::chrono::duration<double>(now - *due).count();
  ++steps_;
  late_steps_ += behind_s > late_s ? 1U : 0U;
  worst_s_ = std::max(worst_s_, behind_s);
}

std::string Punctuality::text() const {
  if (factor_ <= 0) return "as fast as the machine can";
  if (steps_ == 0) return "no step was timed by the clock";
  const double share = 100 * static_cast<double>(late_steps_) / static_cast<double>(steps_);
  return formatted(
      "{} steps, {} of them ({:.3g} %) began more than {:g} ms late, the worst by "
      "{:.1f} ms",
      steps_, late_steps_, share, 1000 * late_s, 1000 * worst_s_);
}

}  // namespace slackwater::live
