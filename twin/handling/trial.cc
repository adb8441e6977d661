#include "twin/handling/trial.h"

#include <algorithm>

namespace slackwater::twin {

const TrialColumn* measured(const Trial& trial, TrialQuantity quantity) noexcept {
  const auto found =
      std::find_if(trial.measured.begin(), trial.measured.end(),
                   [&](const TrialColumn& column) { return column.quantity == quantity; });
  return found == trial.measured.end() ? nullptr : &*found;
}

}  // namespace slackwater::twin
