#pragma once
// For sources that are compiled once per instruction set, see fields/base/numbers/lanes.h.
#include "fields/base/numbers/lanes.h"
#include "twin/step/step_kernel.h"

namespace slackwater::twin::SLACKWATER_KERNEL {

/// As many vehicles of a block as a register holds.
using Lanes = slackwater::SLACKWATER_KERNEL::OneRegister;
static_assert(block_lanes % Lanes::count == 0);

/// From `first` on, as many lanes of a block as a register holds. Both are arrays of numbers, of
/// eight doubles each or of one register.
template <template <typename> typename Of>
SLACKWATER_INLINE void load(Of<Lanes>& to, const Of<Eight>& from, std::size_t first) {
  constexpr std::size_t numbers = sizeof to / sizeof(Lanes);
  static_assert(sizeof from == numbers * sizeof(Eight));
  auto* number = reinterpret_cast<Lanes*>(&to);
  const auto* eight = reinterpret_cast<const Eight*>(&from);
  for (std::size_t i = 0; i < numbers; ++i) number[i] = Lanes::load(eight[i].lane + first);
}
SLACKWATER_INLINE void load(Lanes& to, const Eight& from, std::size_t first) {
  to = Lanes::load(from.lane + first);
}
template <template <typename> typename Of>
SLACKWATER_INLINE void store(Of<Eight>& to, const Of<Lanes>& from, std::size_t first) {
  constexpr std::size_t numbers = sizeof from / sizeof(Lanes);
  const auto* number = reinterpret_cast<const Lanes*>(&from);
  auto* eight = reinterpret_cast<Eight*>(&to);
  for (std::size_t i = 0; i < numbers; ++i) number[i].store(eight[i].lane + first);
}

}  // namespace slackwater::twin::SLACKWATER_KERNEL
