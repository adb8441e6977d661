#include "twin/chance/rank_rule.h"

#include <cmath>

#include "fields/base/check.h"

namespace slackwater::twin {

std::size_t rank_needed(std::size_t members, double share) {
  expects(share > 0 && share < 1, "rank_needed: share in (0, 1)");
  // 0.9 * 10 is to be 9, whatever its last bit.
  return static_cast<std::size_t>(std::ceil(share * static_cast<double>(members + 1) - 1e-9));
}

std::size_t members_needed(double share) {
  std::size_t members = 1;
  while (rank_needed(members, share) > members) ++members;
  return members;
}

}  // namespace slackwater::twin
