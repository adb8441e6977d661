#include "api/live/punctuality.h"

#include <algorithm>

#include "fields/base/text.h"

namespace slackwater::live {

void Punctuality::begin(std::uint64_t step, WallClock::time_point now) {
  if (factor_ <= 0) return;
  const double due_s = static_cast<double>(step - first_step_) * step_s_ / factor_;
  const double behind_s = std::chrono::duration<double>(now - first_).count() - due_s;
  const bool is_first = steps_++ == 0;
  if (is_first || behind_s >= pause_s) {
    pauses_ += is_first ? 0U : 1U;
    first_step_ = step;
    first_ = now;
    return;
  }
  late_steps_ += behind_s > late_s ? 1U : 0U;
  worst_s_ = std::max(worst_s_, behind_s);
}

std::string Punctuality::text() const {
  if (factor_ <= 0 || steps_ == 0) return "as fast as the machine can";
  const double share = 100 * static_cast<double>(late_steps_) / static_cast<double>(steps_);
  return formatted(
      "{} steps, {} of them ({:.3g} %) began more than {:g} ms late, the worst by "
      "{:.1f} ms",
      steps_, late_steps_, share, 1000 * late_s, 1000 * worst_s_);
}

}  // namespace slackwater::live
