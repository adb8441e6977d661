#include "calibration/fuse/broken_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "fields/base/numbers/statistics.h"

namespace slackwater::calibration {
namespace {

constexpr double least_spike_m_s = 0.3;
constexpr double spike_in_usual_departures = 8.0;
/// How long what stays the same has to stay.
struct Stay {
  Duration shortest;
  std::size_t fewest;
};
constexpr Stay of_both{std::chrono::hours(3), 5};
constexpr Stay of_one{std::chrono::hours(6), 9};
constexpr double live_step_in_resolutions = 2.0;
constexpr double moving_product_m_s = 0.1;

/// One level's samples.
struct Samples {
  std::vector<std::size_t> row;  ///< in the column
  std::vector<UtcTime> time;
  std::vector<Horizontal> value;
  std::vector<bool> broken;
};

Samples samples_of(const VectorColumn& column, std::size_t k) {
  Samples samples;
  for (std::size_t t = 0; t < column.times(); ++t) {
    if (!column.has(t, k)) continue;
    samples.row.push_back(t);
    samples.time.push_back(column.time[t].centre());
    samples.value.push_back(column.value[column.offset(t, k)]);
  }
  samples.broken.assign(samples.row.size(), false);
  return samples;
}

Duration usual_step(const std::vector<UtcTime>& time) {
  std::vector<Duration> steps;
  for (std::size_t i = 1; i < time.size(); ++i) steps.push_back(time[i] - time[i - 1]);
  return upper_median(std::move(steps));
}

/// How far samples lie from what their neighbours make of them.
class Departures {
 public:
  explicit Departures(const Samples& samples)
      : samples_(samples), widest_(usual_step(samples.time) * 3) {}

  /// Nothing where too few neighbours stand near.
  [[nodiscard]] std::optional<Horizontal> at(std::size_t i) const {
    std::array<double, 4> east{};
    std::array<double, 4> north{};
    std::size_t count = 0;
    const auto add = [&](std::ptrdiff_t from, std::ptrdiff_t to) {
      const auto a = neighbour(i, from);
      const auto b = neighbour(i, to);
      if (!a || !b) return;
      const double share = seconds_between(samples_.time[*a], samples_.time[i]) /
                           seconds_between(samples_.time[*a], samples_.time[*b]);
      const Horizontal line = (1 - share) * samples_.value[*a] + share * samples_.value[*b];
      east[count] = line.real();
      north[count] = line.imag();
      ++count;
    };
    add(-1, 1);
    add(-2, 2);
    add(-2, -1);
    add(1, 2);
    if (count == 0) return std::nullopt;
    return samples_.value[i] - Horizontal{middle(east, count), middle(north, count)};
  }

 private:
  [[nodiscard]] std::optional<std::size_t> neighbour(std::size_t i, std::ptrdiff_t step) const {
    const std::ptrdiff_t j = static_cast<std::ptrdiff_t>(i) + step;
    if (j < 0 || j >= static_cast<std::ptrdiff_t>(samples_.value.size())) return std::nullopt;
    const auto found = static_cast<std::size_t>(j);
    if (samples_.broken[found]) return std::nullopt;
    if (std::chrono::abs(samples_.time[found] - samples_.time[i]) > widest_) return std::nullopt;
    return found;
  }
  static double middle(std::array<double, 4>& values, std::size_t count) {
    const auto end = values.begin() + static_cast<std::ptrdiff_t>(count);
    std::sort(values.begin(), end);
    return 0.5 * (values[(count - 1) / 2] + values[count / 2]);
  }

  const Samples& samples_;
  Duration widest_;
};

/// The largest departure is a spike; without it its neighbours look better; and so on.
std::size_t mark_spikes(Samples& samples) {
  const std::size_t n = samples.value.size();
  if (n < 5) return 0;
  const Departures departures(samples);
  std::vector<double> departure(n, 0);
  std::vector<double> squares;
  for (std::size_t i = 0; i < n; ++i) {
    const auto found = departures.at(i);
    if (!found) continue;
    departure[i] = std::abs(*found);
    squares.push_back(std::norm(*found));
  }
  if (squares.empty()) return 0;
  const double usual = std::sqrt(median(std::move(squares)) / (2 * std::numbers::ln2));
  const double limit = std::max(least_spike_m_s, spike_in_usual_departures * usual);
  std::vector<std::size_t> suspects;
  for (std::size_t i = 0; i < n; ++i)
    if (departure[i] > limit) suspects.push_back(i);
  std::size_t spikes = 0;
  while (!suspects.empty()) {
    const auto worst =
        std::max_element(suspects.begin(), suspects.end(),
                         [&](std::size_t a, std::size_t b) { return departure[a] < departure[b]; });
    const std::size_t spike = *worst;
    samples.broken[spike] = true;
    ++spikes;
    suspects.erase(worst);
    const std::size_t first = spike < 2 ? 0 : spike - 2;
    for (std::size_t i = first; i < std::min(n, spike + 3); ++i) {
      const auto again = departures.at(i);
      departure[i] = again ? std::abs(*again) : 0;
    }
    std::erase_if(suspects, [&](std::size_t i) { return departure[i] <= limit; });
  }
  return spikes;
}

double range_of_product(const VectorColumn& product, UtcTime from, UtcTime to, bool is_north) {
  double widest = 0;
  for (std::size_t k = 0; k < product.levels(); ++k) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (std::size_t t = 0; t < product.times(); ++t) {
      const UtcTime time = product.time[t].centre();
      if (time < from || time > to || !product.has(t, k)) continue;
      const Horizontal value = product.value[product.offset(t, k)];
      const double component = is_north ? value.imag() : value.real();
      low = std::min(low, component);
      high = std::max(high, component);
    }
    if (high > low) widest = std::max(widest, high - low);
  }
  return widest;
}

/// Whether the steps of a component are wider than its resolution can explain; for one that never
/// changes, whether the product does.
bool is_live(const std::vector<double>& x, const Samples& samples, const VectorColumn& product,
             bool is_north) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < x.size(); ++i)
    if (x[i] != x[i - 1]) steps.push_back(std::abs(x[i] - x[i - 1]));
  if (steps.empty()) {
    return range_of_product(product, samples.time.front(), samples.time.back(), is_north) >
           moving_product_m_s;
  }
  const double resolution = *std::min_element(steps.begin(), steps.end());
  return median(std::move(steps)) > live_step_in_resolutions * resolution;
}

/// @param same  whether two samples are the same
template <typename Same>
void mark_runs(Samples& samples, const Stay& stay, Same same) {
  const std::size_t n = samples.value.size();
  for (std::size_t first = 0; first < n;) {
    std::size_t last = first;
    while (last + 1 < n && same(samples.value[first], samples.value[last + 1])) ++last;
    const bool is_long = last - first + 1 >= stay.fewest &&
                         samples.time[last] - samples.time[first] >= stay.shortest;
    if (is_long)
      std::fill(samples.broken.begin() + static_cast<std::ptrdiff_t>(first),
                samples.broken.begin() + static_cast<std::ptrdiff_t>(last) + 1, true);
    first = last + 1;
  }
}

void mark_stuck(Samples& samples, const VectorColumn& product) {
  if (samples.value.size() < of_both.fewest) return;
  std::vector<double> east;
  std::vector<double> north;
  for (const Horizontal& value : samples.value) {
    east.push_back(value.real());
    north.push_back(value.imag());
  }
  const bool east_lives = is_live(east, samples, product, false);
  const bool north_lives = is_live(north, samples, product, true);
  if (east_lives || north_lives)
    mark_runs(samples, of_both, [](Horizontal a, Horizontal b) { return a == b; });
  if (east_lives)
    mark_runs(samples, of_one, [](Horizontal a, Horizontal b) { return a.real() == b.real(); });
  if (north_lives)
    mark_runs(samples, of_one, [](Horizontal a, Horizontal b) { return a.imag() == b.imag(); });
}

/// Hours that the stuck samples stand for.
double stuck_hours(const Samples& samples) {
  double hours = 0;
  for (std::size_t i = 1; i < samples.broken.size(); ++i) {
    if (samples.broken[i] && samples.broken[i - 1])
      hours += hours_between(samples.time[i - 1], samples.time[i]);
  }
  return hours;
}

}  // namespace

UnbrokenSeries without_broken_samples(const VectorColumn& observed, const VectorColumn& product) {
  UnbrokenSeries result;
  result.column = observed;
  for (std::size_t k = 0; k < observed.levels(); ++k) {
    Samples samples = samples_of(observed, k);
    mark_stuck(samples, product);
    result.stuck_h = std::max(result.stuck_h, stuck_hours(samples));
    for (std::size_t i = 0; i < samples.broken.size(); ++i)
      if (samples.broken[i]) result.stuck_until = std::max(result.stuck_until, samples.time[i]);
    result.spikes += mark_spikes(samples);
    for (std::size_t i = 0; i < samples.broken.size(); ++i)
      if (samples.broken[i])
        result.column.status[observed.offset(samples.row[i], k)] = SampleStatus::suspect;
  }
  return result;
}

}  // namespace slackwater::calibration
