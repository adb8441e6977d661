// Compiled once per instruction set, see cmake/SlackwaterKernels.cmake; SLACKWATER_KERNEL names the
// namespace.
#include "twin/step/step_kernel.h"

#include "twin/step/kernel_registers.h"
#include "twin/step/vehicle_step.h"

namespace slackwater::twin::SLACKWATER_KERNEL {
namespace {

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
    if (vehicle.body.hull.strips > 0) {
      load(a.value.at_strips, around.at_strips, first);
      load(a.value.turn_n_m, around.turn_n_m, first);
    }
    step(vehicle, plan, s.value, c.value, a.value);
    store(state, s.value, first);
  }
}

}  // namespace

StepBlock step_block() noexcept { return run; }

}  // namespace slackwater::twin::SLACKWATER_KERNEL
