#include "api/door/dds/held_back.h"

#include <algorithm>

namespace slackwater::dds {

double HeldBack::look(double sent_s, double came_s) noexcept {
  if (came_s >= begun_s_ + half_s) {
    before_s_ = came_s < begun_s_ + 2 * half_s ? least_s_ : none;
    least_s_ = none;
    begun_s_ = came_s;
  }
  const double delay_s = came_s - sent_s;
  least_s_ = std::min(least_s_, delay_s);
  return delay_s - std::min(least_s_, before_s_);
}

}  // namespace slackwater::dds
