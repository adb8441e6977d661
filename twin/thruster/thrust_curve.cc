#include "twin/thruster/thrust_curve.h"

#include <algorithm>
#include <cmath>

namespace slackwater::twin {
namespace {

/// Thrust goes with the square of the command, so that slots are even in its root; rows of near voltages have one shape
/// between their ends.
constexpr double middle_slot = 0.5 * (thrust_guesses - 1);
double thrust_at_slot(std::size_t slot, double first_n, double last_n) {
  const double share = static_cast<double>(slot) / middle_slot - 1;
  return share * share * (share < 0 ? first_n : last_n);
}

double share_between(double value, double a, double b) {
  return std::clamp((value - a) / (b - a), 0.0, 1.0);
}

}  // namespace

void index_thrusts(ThrustTable& table) {
  const std::size_t columns = table.command.count;
  table.guess.clear();
  for (std::size_t row = 0; row < table.voltage_v.count; ++row) {
    const double* thrust_n = table.thrust_n.data() + row * columns;
    std::size_t below = 0;
    for (std::size_t i = 0; i < thrust_guesses; ++i) {
      const double at_n = thrust_at_slot(i, thrust_n[0], thrust_n[columns - 1]);
      while (below + 2 < columns && thrust_n[below + 1] < at_n) ++below;
      table.guess.push_back(static_cast<std::uint16_t>(below));
    }
  }
}

ThrustCurve::ThrustCurve(const ThrustTable& table, double voltage_v) : axis_(&table.command) {
  const std::size_t columns = table.command.count;
  const PlaceOnAxis<double> place = place_on(table.voltage_v, voltage_v);
  const auto row = static_cast<std::size_t>(place.below);
  low_ = table.thrust_n.data() + row * columns;
  high_ = low_ + columns;
  guess_ = table.guess.data() + row * thrust_guesses;
  share_ = place.share;
  sag_ = speed_share(table.voltage_v.first, voltage_v);
  none_ = (columns - 1) / 2;
  first_n_ = thrust_n(0);
  last_n_ = thrust_n(columns - 1);
}

double ThrustCurve::command_for(double rest_thrust_n) const {
  if (!(std::abs(rest_thrust_n) > 0) || !(sag_ > 0)) return 0;
  const double wanted_n = rest_thrust_n / (sag_ * sag_);
  return wanted_n > 0 ? ahead(wanted_n) : astern(wanted_n);
}

double ThrustCurve::ahead(double wanted_n) const {
  const std::size_t last = axis_->count - 1;
  if (!(last_n_ > wanted_n)) return axis_->at(last);
  const double slot = middle_slot + middle_slot * std::sqrt(wanted_n / last_n_);
  // The last entry with less.
  std::size_t i = std::max<std::size_t>(guess_[static_cast<std::size_t>(slot)], none_);
  double less_n = thrust_n(i);
  while (i > none_ && !(less_n < wanted_n)) less_n = thrust_n(--i);
  double more_n = thrust_n(i + 1);
  while (i + 1 < last && more_n < wanted_n) {
    less_n = more_n;
    more_n = thrust_n(++i + 1);
  }
  return axis_->at(i) + axis_->step * share_between(wanted_n, less_n, more_n);
}

double ThrustCurve::astern(double wanted_n) const {
  if (!(first_n_ < wanted_n)) return axis_->at(0);
  const double slot = middle_slot - middle_slot * std::sqrt(wanted_n / first_n_);
  // The first entry with less, counted by size.
  std::size_t i = std::min<std::size_t>(guess_[static_cast<std::size_t>(slot)] + 1U, none_);
  double less_n = thrust_n(i);
  while (i < none_ && !(less_n > wanted_n)) less_n = thrust_n(++i);
  double more_n = thrust_n(i - 1);
  while (i > 1 && more_n > wanted_n) {
    less_n = more_n;
    more_n = thrust_n(--i - 1);
  }
  return axis_->at(i) - axis_->step * share_between(wanted_n, less_n, more_n);
}

}  // namespace slackwater::twin
