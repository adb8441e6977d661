// Compiled once per instruction set, see kernels.cmake; SLACKWATER_KERNEL names the namespace.
#include "twin/simulate/step_kernel.h"

#include <cstring>

#include "fields/base/lanes.h"
#include "twin/simulate/vehicle_step.h"

namespace slackwater::twin::SLACKWATER_KERNEL {
namespace {

using Lanes = slackwater::SLACKWATER_KERNEL::Lanes;
static_assert(sizeof(Lanes) == sizeof(Eight));

/// Room for a value that is written before it is read, and so is not cleared.
template <typename T>
union Room {
  T value;
  char none;
  Room() {}
};

/// The same numbers in registers' form: both are arrays of eight doubles per number.
template <typename To, typename From>
SLACKWATER_INLINE void load(To& to, const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  std::memcpy(static_cast<void*>(&to), static_cast<const void*>(&from), sizeof to);
}

void run(const Vehicle& vehicle, const StepPlan& plan, VehicleState<Eight>& state,
                          const VehicleCommand<Eight>& command,
                          const Surroundings<Eight>& around) noexcept {
  Room<VehicleState<Lanes>> s;
  Room<VehicleCommand<Lanes>> c;
  Room<Surroundings<Lanes>> a;
  load(s.value, state);
  load(c.value, command);
  load(a.value.water, around.water);
  load(a.value.wind_m_s, around.wind_m_s);
  load(a.value.pull_n, around.pull_n);
  load(a.value.height_above_m, around.height_above_m);
  if (vehicle.body.hull.strips > 0) load(a.value.at_strips, around.at_strips);
  step(vehicle, plan, s.value, c.value, a.value);
  load(state, s.value);
}

}  // namespace

StepBlock step_block() noexcept { return run; }

}  // namespace slackwater::twin::SLACKWATER_KERNEL
