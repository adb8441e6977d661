#pragma once
#include "twin/step/vehicle_state.h"

namespace slackwater::twin {

inline constexpr std::size_t block_lanes = 8;

/// One number of each of eight vehicles, as it lies in memory.
struct alignas(64) Eight {
  double lane[block_lanes];
};

/// Room for a value that is written before it is read, and so is not cleared.
template <typename T>
union Room {
  T value;
  char none;
  Room() {}
};

/// Steps eight vehicles of one kind by one step: `step` of vehicle_step.h on vectors, compiled once
/// per instruction set.
using StepBlock = void (*)(const Vehicle&, const StepPlan&, VehicleState<Eight>&,
                           const VehicleCommand<Eight>&, const Surroundings<Eight>&) noexcept;

/// A value made of numbers only, as one vehicle in a block of eight has it. `Of` is VehicleState,
/// VehicleCommand or Surroundings.
template <template <typename> typename Of>
void put(Of<Eight>& block, std::size_t lane, const Of<double>& value) {
  static_assert(sizeof(Of<Eight>) == block_lanes * sizeof(Of<double>));
  constexpr std::size_t numbers = sizeof(Of<double>) / sizeof(double);
  const auto* from = reinterpret_cast<const double*>(&value);
  auto* to = reinterpret_cast<double*>(&block);
  for (std::size_t i = 0; i < numbers; ++i) to[i * block_lanes + lane] = from[i];
}
template <template <typename> typename Of>
[[nodiscard]] Of<double> taken(const Of<Eight>& block, std::size_t lane) {
  constexpr std::size_t numbers = sizeof(Of<double>) / sizeof(double);
  Of<double> value;
  const auto* from = reinterpret_cast<const double*>(&block);
  auto* to = reinterpret_cast<double*>(&value);
  for (std::size_t i = 0; i < numbers; ++i) to[i] = from[i * block_lanes + lane];
  return value;
}

namespace kernel_baseline {
[[nodiscard]] StepBlock step_block() noexcept;
}
namespace kernel_avx2 {
[[nodiscard]] StepBlock step_block() noexcept;
}
namespace kernel_avx512 {
[[nodiscard]] StepBlock step_block() noexcept;
}

}  // namespace slackwater::twin
