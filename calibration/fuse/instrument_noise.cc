#include "calibration/fuse/instrument_noise.h"

#include <cmath>
#include <numbers>

#include "fields/base/numbers/statistics.h"

namespace slackwater::calibration {
namespace {

constexpr std::size_t fewest_differences = 20;
constexpr double gain_of_fourth_difference = 1 + 16 + 36 + 16 + 1;

double noise_of(const std::vector<UtcTime>& time, const std::vector<Horizontal>& x) {
  if (x.size() < fewest_differences + 4) return 0;
  std::vector<Duration> steps;
  for (std::size_t i = 1; i < time.size(); ++i) steps.push_back(time[i] - time[i - 1]);
  const Duration step = upper_median(std::move(steps));
  if (step > rarest_sampling) return 0;
  std::vector<double> squares;
  for (std::size_t i = 2; i + 2 < x.size(); ++i) {
    const bool is_even = std::chrono::abs(time[i] - time[i - 2] - 2 * step) <= step / 10 &&
                         std::chrono::abs(time[i + 2] - time[i] - 2 * step) <= step / 10;
    if (!is_even) continue;
    squares.push_back(
        std::norm(x[i - 2] - 4.0 * x[i - 1] + 6.0 * x[i] - 4.0 * x[i + 1] + x[i + 2]));
  }
  if (squares.size() < fewest_differences) return 0;
  // |d|^2 of two equal normals is exponential: its median is 2 ln 2 of the variance of one.
  return std::sqrt(median(std::move(squares)) / (2 * std::numbers::ln2) /
                   gain_of_fourth_difference);
}

}  // namespace

std::vector<double> instrument_noise(const VectorColumn& observed) {
  std::vector<double> noise;
  for (std::size_t k = 0; k < observed.levels(); ++k) {
    std::vector<UtcTime> time;
    std::vector<Horizontal> value;
    for (std::size_t t = 0; t < observed.times(); ++t) {
      if (!observed.has(t, k)) continue;
      time.push_back(observed.time[t].centre());
      value.push_back(observed.value[observed.offset(t, k)]);
    }
    noise.push_back(noise_of(time, value));
  }
  return noise;
}

}  // namespace slackwater::calibration
