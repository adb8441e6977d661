#include "api/door/dds/message/frames.h"

#include <cmath>

namespace slackwater::dds {

twin::Attitude<double> enu_flu_ned_frd(const twin::Attitude<double>& q) noexcept {
  const double s = std::sqrt(0.5) * (q.w + q.z < 0 ? -1 : 1);
  return {s * (q.w + q.z), s * (q.x + q.y), s * (q.x - q.y), s * (q.w - q.z)};
}

}  // namespace slackwater::dds
