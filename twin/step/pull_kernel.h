#pragma once
#include "twin/step/step_kernel.h"
#include "twin/tether/tether.h"

namespace slackwater::twin {

/// Eight tethers of one make and all that a step of theirs needs; filled in before it is read.
struct TetherBlock {
  Room<TetherState<Eight>> state;
  Room<TetherEnds<Eight>> ends;
  Room<WaterAtNodes<Eight>> before;  ///< the step
  Room<WaterAtNodes<Eight>> after;
  Room<TetherPull<Eight>> felt;  ///< what comes of it
};

/// Moves eight tethers on by one long step: `pull_long` of twin/tether/long_step.h on vectors,
/// compiled once per instruction set; the same bits as one by one.
using PullBlock = void (*)(const Tether&, TetherBlock&, double dt_s) noexcept;

namespace kernel_baseline {
[[nodiscard]] PullBlock pull_block() noexcept;
}
namespace kernel_avx2 {
[[nodiscard]] PullBlock pull_block() noexcept;
}
namespace kernel_avx512 {
[[nodiscard]] PullBlock pull_block() noexcept;
}

}  // namespace slackwater::twin
