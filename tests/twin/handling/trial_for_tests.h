#pragma once
#include <cmath>
#include <utility>
#include <vector>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"
#include "twin/handling/trial_error.h"

namespace slackwater::tests {

/// A trial of nothing but commands, a row every 0.2 s: thrusters, the rudder where there is one.
struct Told {
  std::size_t channel = 0;
  double (*at)(double t_s) = nullptr;
};
inline twin::Trial commanded(const std::vector<Told>& told, double lasts_s) {
  twin::Trial trial;
  trial.name = "trial";
  for (std::size_t row = 0; 0.2 * static_cast<double>(row) <= lasts_s + 1e-9; ++row)
    trial.time_s.push_back(0.2 * static_cast<double>(row));
  for (const Told& one : told) {
    twin::TrialCommand command{one.channel, false, {}};
    for (const double t_s : trial.time_s) command.value.push_back(one.at(t_s));
    trial.commands.push_back(command);
  }
  return trial;
}

/// The same with what a vehicle of ours did as what was measured.
inline twin::Trial made_by(const twin::Vehicle& vehicle, twin::Trial trial,
                           const std::vector<twin::TrialQuantity>& quantities) {
  trial.measured.clear();
  for (const twin::TrialQuantity quantity : quantities)
    trial.measured.push_back({quantity, std::vector<double>(trial.rows(), constants::nan)});
  const twin::TrialRun run = twin::replayed(vehicle, trial);
  for (std::size_t i = 0; i < quantities.size(); ++i) trial.measured[i].value = run.ours[i];
  return trial;
}

/// With noise on all rows but the first: first-order autoregressive, of a standard deviation that
/// is a share of each column's range, with a correlation from row to row.
inline twin::Trial with_noise(twin::Trial trial, double share, double correlation,
                              std::uint64_t seed) {
  for (twin::TrialColumn& column : trial.measured) {
    const double range = twin::range_of(column);
    Rng rng(seed, twin::name_of(column.quantity));
    double off = rng.normal();
    for (std::size_t row = 1; row < column.value.size(); ++row) {
      off = correlation * off + std::sqrt(1 - correlation * correlation) * rng.normal();
      column.value[row] += share * range * off;
    }
  }
  return trial;
}

}  // namespace slackwater::tests
