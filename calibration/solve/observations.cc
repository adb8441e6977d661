#include "calibration/solve/observations.h"

#include <algorithm>
#include <cmath>

#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::calibration {
namespace {

bool is_usable(const VectorColumn& column, std::size_t t, std::size_t k) {
  const Horizontal value = column.value[column.offset(t, k)];
  return column.has(t, k) && std::isfinite(value.real()) && std::isfinite(value.imag());
}

void check(const CalibrationInput& input) {
  const VectorColumn& current = input.current;
  expects(current.value.size() == current.times() * current.levels() &&
              current.status.size() == current.value.size(),
          "a column holds times x levels values and statuses");
  if (!(input.water_depth_m > 0) || !std::isfinite(input.water_depth_m)) {
    throw Error(ErrorKind::invalid_input,
                "the water depth is " + formatted("{:.1f}", input.water_depth_m) +
                    " m; a positive depth was expected; give water_depth_m of the site");
  }
  expects(input.noise_m_s.empty() || input.noise_m_s.size() == current.value.size(),
          "a stated noise for each value of the day, or none");
  if (!(input.observation_sigma_m_s > 0)) {
    throw Error(ErrorKind::invalid_input, "the standard deviation of the currents is " +
                                              std::to_string(input.observation_sigma_m_s) +
                                              " m/s; a positive number was expected");
  }
}

/// The stress that goes with each time; none where the wind is needed and missing.
std::vector<std::optional<Horizontal>> stress_of_times(const CalibrationInput& input,
                                                       Observations& found) {
  std::vector<std::optional<Horizontal>> stress(input.current.times(), Horizontal{});
  if (is_equatorial(input.latitude)) {
    found.warnings.emplace_back(
        "the place lies within 3 degrees of the equator: no Ekman balance, only the interior is "
        "fitted");
    return stress;
  }
  StressSeries series = input.wind ? StressSeries(*input.wind, input.drag_law) : StressSeries();
  if (series.empty()) {
    found.warnings.emplace_back("no wind for this day: the wind-driven current is left out");
    return stress;
  }
  std::size_t missing = 0;
  for (std::size_t t = 0; t < stress.size(); ++t) {
    stress[t] = series.over(input.current.time[t]);
    if (!stress[t]) ++missing;
  }
  if (missing == stress.size()) {
    found.warnings.emplace_back(
        "the wind has no value at any time of this day: the wind-driven current is left out");
    std::fill(stress.begin(), stress.end(), Horizontal{});
    return stress;
  }
  if (missing > 0) {
    found.warnings.push_back("no wind at " + std::to_string(missing) + " of " +
                             std::to_string(stress.size()) + " times: their currents are not used");
  }
  found.wind_used = true;
  found.stress = std::move(series);
  return stress;
}

/// Values count by their stated noise.
void weigh_by_noise(const CalibrationInput& input, Observations& found) {
  if (input.noise_m_s.empty()) return;
  const auto square_of = [&](const Pair& pair) {
    const double noise = input.noise_m_s[input.current.offset(pair.time, pair.level)];
    return noise * noise;
  };
  double mean = 0;
  for (const Pair& pair : found.pairs)
    mean += square_of(pair) / static_cast<double>(found.pairs.size());
  found.noise_m_s = std::sqrt(mean);
  const double best = input.observation_sigma_m_s * input.observation_sigma_m_s;
  for (Pair& pair : found.pairs)
    pair.relative_sigma = std::sqrt((best + square_of(pair)) / (best + mean));
}

}  // namespace

Observations pair_observations(const CalibrationInput& input) {
  check(input);
  const VectorColumn& current = input.current;
  Observations found;
  found.depth_m = current.levels_m.empty() ? std::vector<double>{0.0} : current.levels_m;
  found.water_depth_m = input.water_depth_m;
  const std::vector<std::optional<Horizontal>> stress = stress_of_times(input, found);

  found.pairs.reserve(current.value.size());
  for (const auto& s : stress) found.stress_pa.push_back(s.value_or(Horizontal{}));
  double deepest_m = 0;
  for (std::size_t t = 0; t < current.times(); ++t) {
    if (!stress[t]) continue;
    for (std::size_t k = 0; k < current.levels(); ++k) {
      if (!is_usable(current, t, k)) continue;
      found.pairs.push_back({current.value[current.offset(t, k)], t, k});
      deepest_m = std::max(deepest_m, found.depth_m[k]);
    }
  }
  if (found.pairs.empty()) {
    throw Error(ErrorKind::invalid_input, "none of the " + std::to_string(current.value.size()) +
                                              " currents of the day has a value; at least one was "
                                              "expected; check that the site lies in "
                                              "water and that the day is in the store");
  }
  weigh_by_noise(input, found);
  if (deepest_m > found.water_depth_m) {
    found.warnings.push_back("currents reach down to " + formatted("{:.1f}", deepest_m) +
                             " m, below the given water depth of " +
                             formatted("{:.1f}", found.water_depth_m) +
                             " m: the deeper figure is used");
    found.water_depth_m = deepest_m;
  }
  return found;
}

}  // namespace slackwater::calibration
