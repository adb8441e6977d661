#pragma once
#include "fields/current/kernel_dispatch.h"
#include "twin/step/pull_kernel.h"
#include "twin/step/step_kernel.h"

namespace slackwater::twin {

/// The widest that this machine can run; the same bits as on any other, and as `step` of one
/// vehicle.
[[nodiscard]] StepBlock step_block() noexcept;
/// The one of a path, which this machine must support.
[[nodiscard]] StepBlock step_block_on(KernelPath path) noexcept;
/// The same for eight tethers.
[[nodiscard]] PullBlock pull_block() noexcept;
[[nodiscard]] PullBlock pull_block_on(KernelPath path) noexcept;

}  // namespace slackwater::twin
