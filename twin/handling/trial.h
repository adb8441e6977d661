#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "twin/body/attitude.h"
#include "twin/handling/trial_quantity.h"

namespace slackwater::twin {

/// What one channel of a vehicle was told, row by row; each value holds until the next row.
struct TrialCommand {
  std::size_t channel = 0;    ///< of the vehicle (actuator_channels.h)
  bool is_share = false;      ///< of the channel's range, -1 to 1; else in the channel's unit
  std::vector<double> value;  ///< one a row
};

/// What was measured of the motion, row by row.
struct TrialColumn {
  TrialQuantity quantity{};
  std::vector<double> value;  ///< one a row, SI; NaN: no value in that row
};

/// A trial of a real vehicle, or a run of somebody else's model: what it was told and what it did.
///
/// Commands are what the vehicle's model is commanded in. Where a file has the speed of a shaft, as
/// measured behind its lag, our model lags it once more: by the thruster's time constant, tenths of
/// a second to a second.
struct Trial {
  std::string name;
  std::vector<double> time_s;  ///< rising, from any moment; two rows at least
  std::vector<TrialCommand> commands;
  std::vector<TrialColumn> measured;  ///< each quantity once
  Triple<double> current_m_s;         ///< of the water over the ground, NED, throughout
  /// Where the first row was, in metres below the surface, for one whose `down` counts from
  /// somewhere else or is not there. Of what swims; what floats begins afloat.
  std::optional<double> first_depth_m;

  [[nodiscard]] std::size_t rows() const noexcept { return time_s.size(); }
  [[nodiscard]] double lasts_s() const noexcept { return time_s.back() - time_s.front(); }
};

/// Of a column; nothing: it was not measured.
[[nodiscard]] const TrialColumn* measured(const Trial& trial, TrialQuantity quantity) noexcept;

}  // namespace slackwater::twin
