// Compiled once per instruction set, see cmake/SlackwaterKernels.cmake; SLACKWATER_KERNEL names the
// namespace.
#include "twin/simulate/step_kernel.h"

#include "fields/base/lanes.h"
#include "twin/simulate/vehicle_step.h"

namespace slackwater::twin::SLACKWATER_KERNEL {
namespace {

using Lanes = slackwater::SLACKWATER_KERNEL::OneRegister;
static_assert(block_lanes % Lanes::count == 0);

/// Room for a value that is written before it is read, and so is not cleared.
template <typename T>
union Room {
  T value;
  char none;
  Room() {}
};

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

/// Register by register: the numbers of a step are many, and eight of each leave no room for them.
[[gnu::flatten]] void run(const Vehicle& vehicle, const StepPlan& plan, VehicleState<Eight>& state,
                          const VehicleCommand<Eight>& command,
                          const Surroundings<Eight>& around) noexcept {
  for (std::size_t first = 0; first < block_lanes; first += Lanes::count) {
    Room<VehicleState<Lanes>> s;
    Room<VehicleCommand<Lanes>> c;
    Room<Surroundings<Lanes>> a;
    load(s.value, state, first);
    load(c.value, command, first);
    load(a.value.water, around.water, first);
    load(a.value.wind_m_s, around.wind_m_s, first);
    load(a.value.pull_n, around.pull_n, first);
    load(a.value.height_above_m, around.height_above_m, first);
    if (vehicle.body.hull.strips > 0) load(a.value.at_strips, around.at_strips, first);
    step(vehicle, plan, s.value, c.value, a.value);
    store(state, s.value, first);
  }
}

}  // namespace

StepBlock step_block() noexcept { return run; }

}  // namespace slackwater::twin::SLACKWATER_KERNEL
