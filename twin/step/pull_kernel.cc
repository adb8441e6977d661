// Compiled once per instruction set, see cmake/SlackwaterKernels.cmake; SLACKWATER_KERNEL names the
// namespace.
#include "twin/step/pull_kernel.h"

#include "twin/step/kernel_registers.h"
#include "twin/tether/long_step.h"

namespace slackwater::twin::SLACKWATER_KERNEL {
namespace {

/// Register by register, as in step_kernel.cc.
[[gnu::flatten]] void run(const Tether& tether, TetherBlock& block, double dt_s) noexcept {
  for (std::size_t first = 0; first < block_lanes; first += Lanes::count) {
    Room<TetherState<Lanes>> state;
    Room<TetherEnds<Lanes>> ends;
    Room<WaterAtNodes<Lanes>> before, after;
    load(state.value, block.state.value, first);
    load(ends.value, block.ends.value, first);
    load(before.value, block.before.value, first);
    load(after.value, block.after.value, first);
    const TetherPull<Lanes> felt =
        pull_long(tether, state.value, ends.value, before.value, after.value, dt_s);
    store(block.state.value, state.value, first);
    store(block.felt.value, felt, first);
  }
}

}  // namespace

PullBlock pull_block() noexcept { return run; }

}  // namespace slackwater::twin::SLACKWATER_KERNEL
