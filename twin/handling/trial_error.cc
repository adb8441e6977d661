#include "twin/handling/trial_error.h"

#include <algorithm>
#include <cmath>

#include "fields/base/turn.h"

namespace slackwater::twin {
namespace {

TrialError error_of_column(const TrialColumn& column, const std::vector<double>& ours) {
  TrialError error;
  error.quantity = column.quantity;
  error.range = range_of(column);
  double sum = 0, squares = 0;
  for (std::size_t row = 1; row < ours.size(); ++row) {
    if (!std::isfinite(column.value[row])) continue;
    const double off = off_by(column.quantity, ours[row], column.value[row]);
    ++error.n;
    sum += off;
    squares += off * off;
    error.largest = std::max(error.largest, std::abs(off));
  }
  if (error.n == 0) return error;
  const auto n = static_cast<double>(error.n);
  error.bias = sum / n;
  error.rms = std::sqrt(squares / n);
  if (error.range > 0) error.share = error.rms / error.range;
  return error;
}

std::optional<TrialPlace> place_of(const Trial& trial, const TrialRun& run) {
  const TrialColumn* const north = measured(trial, TrialQuantity::north);
  const TrialColumn* const east = measured(trial, TrialQuantity::east);
  if (north == nullptr || east == nullptr) return std::nullopt;
  const auto& ours_north = run.ours[static_cast<std::size_t>(north - trial.measured.data())];
  const auto& ours_east = run.ours[static_cast<std::size_t>(east - trial.measured.data())];
  std::optional<std::size_t> last;
  TrialPlace place;
  for (std::size_t row = 0; row < run.rows; ++row) {
    if (!std::isfinite(north->value[row]) || !std::isfinite(east->value[row])) continue;
    if (last)
      place.way_m += std::hypot(north->value[row] - north->value[*last],
                                east->value[row] - east->value[*last]);
    last = row;
  }
  if (!last || *last == 0) return std::nullopt;
  place.at_s = trial.time_s[*last];
  place.off_m =
      std::hypot(ours_north[*last] - north->value[*last], ours_east[*last] - east->value[*last]);
  if (place.way_m > 0) place.share = place.off_m / place.way_m;
  return place;
}

}  // namespace

double off_by(TrialQuantity quantity, double ours, double theirs) noexcept {
  return is_angle(quantity) ? short_way_rad(ours - theirs) : ours - theirs;
}

double range_of(const TrialColumn& column) noexcept {
  bool is_first = true;
  double before = 0, least = 0, most = 0;
  for (const double value : column.value) {
    if (!std::isfinite(value)) continue;
    const double at = is_first ? value : before + off_by(column.quantity, value, before);
    least = is_first ? at : std::min(least, at);
    most = is_first ? at : std::max(most, at);
    before = at;
    is_first = false;
  }
  return most - least;
}

TrialErrors errors_of(const Trial& trial, const TrialRun& run) {
  TrialErrors errors;
  for (std::size_t i = 0; i < trial.measured.size(); ++i)
    errors.error.push_back(error_of_column(trial.measured[i], run.ours[i]));
  errors.place = place_of(trial, run);
  return errors;
}

}  // namespace slackwater::twin
