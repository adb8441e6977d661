#include "calibration/fuse/tide_agreement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "calibration/fuse/comparison.h"
#include "calibration/fuse/observed_at.h"
#include "fields/base/numbers/averaging.h"

namespace slackwater::calibration {
namespace {

using std::chrono::hours;
using std::chrono::minutes;

constexpr Duration looked_at = hours(24 * 15 + 25);
constexpr Duration half_mean = minutes(25 * 30);
constexpr double least_share_of_mean = 0.75;
constexpr double least_hours = 48;
constexpr double least_hours_of_circles = 240;
constexpr double most_circular = 0.3;
constexpr double least_motion_m_s = 0.05;
constexpr double most_unexplained = 0.2;
constexpr double honest_turn_rad = 20 * std::numbers::pi / 180;
constexpr double honest_lag_h = 1.5;
constexpr double farthest_lag_h = 6.5;  ///< half of M2, and a little
constexpr double lag_step_h = 0.25;
constexpr double evidence = 9.0;          ///< twice the logarithm of e^4.5
constexpr double never_explained = 0.01;  ///< of the variance, of whatever model
constexpr double halves_apart_rad = 20 * std::numbers::pi / 180;

/// Both at the product's times: depth means.
struct Pair {
  UtcTime time{};
  TimeCell cell;
  Horizontal product;
  Horizontal observed;
};

/// The depth mean of the levels that the comparison uses, as one level.
VectorColumn depth_mean(const VectorColumn& observed, const std::vector<double>& product_levels) {
  VectorColumn mean;
  mean.vertical = VerticalKind::depth_m;
  mean.levels_m = {0};
  for (std::size_t t = 0; t < observed.times(); ++t) {
    Horizontal sum{};
    double count = 0;
    for (std::size_t k = 0; k < observed.levels(); ++k) {
      if (observed.levels_m[k] > product_levels.back() + 3 || !observed.has(t, k)) continue;
      sum += observed.value[observed.offset(t, k)];
      ++count;
    }
    if (count == 0) continue;
    mean.time.push_back(observed.time[t]);
    mean.source.push_back(observed.source[t]);
    mean.value.push_back(sum / count);
    mean.status.push_back(SampleStatus::ok);
  }
  return mean;
}

std::vector<Pair> pairs_of(const VectorColumn& product, const VectorColumn& observed,
                           const FusionSettings& settings) {
  std::vector<Pair> pairs;
  const Comparison comparison(product, observed, settings);
  UtcTime newest{};
  for (std::size_t t = product.times(); t-- > 0;) {
    const UtcTime time = product.time[t].centre();
    if (!pairs.empty() && (newest - time > looked_at)) break;
    if (!pairs.empty() && pairs.back().time - time < minutes(59)) continue;
    const Differences found = comparison.at(t);
    if (found.value.empty()) continue;
    Horizontal difference{};
    Horizontal seen{};
    for (std::size_t i = 0; i < found.value.size(); ++i) {
      difference += found.value[i];
      seen += found.observed[i];
    }
    const auto count = static_cast<double>(found.value.size());
    pairs.push_back({time, product.time[t], (seen - difference) / count, seen / count});
    if (pairs.size() == 1) newest = time;
  }
  std::reverse(pairs.begin(), pairs.end());
  return pairs;
}

/// Pairs less their running means, and the instrument's at every lag.
struct Tides {
  std::vector<UtcTime> time;
  std::vector<Horizontal> product;
  std::vector<Horizontal> observed_mean;
  std::vector<TimeCell> cell;
};

Tides tides_of(const std::vector<Pair>& pairs, Duration step) {
  Tides tides;
  const double expected = static_cast<double>((2 * half_mean) / step);
  std::size_t first = 0;
  std::size_t end = 0;
  Horizontal product{};
  Horizontal observed{};
  for (const Pair& pair : pairs) {
    for (; end < pairs.size() && pairs[end].time <= pair.time + half_mean; ++end) {
      product += pairs[end].product;
      observed += pairs[end].observed;
    }
    for (; pairs[first].time < pair.time - half_mean; ++first) {
      product -= pairs[first].product;
      observed -= pairs[first].observed;
    }
    const bool is_inside = pair.time - half_mean >= pairs.front().time - step &&
                           pair.time + half_mean <= pairs.back().time + step;
    const auto count = static_cast<double>(end - first);
    if (!is_inside || count < least_share_of_mean * expected) continue;
    tides.time.push_back(pair.time);
    tides.cell.push_back(pair.cell);
    tides.product.push_back(pair.product - product / count);
    tides.observed_mean.push_back(observed / count);
  }
  return tides;
}

/// c at one lag, over the values [from, to).
Horizontal likeness(const Tides& tides, const ObservedLevel& observed, double lag_h,
                    double noise_m2_s2, std::size_t from, std::size_t to) {
  const Duration lag(static_cast<Duration::rep>(lag_h * 3.6e6));
  Horizontal both{};
  double product = 0;
  double seen = 0;
  double count = 0;
  for (std::size_t t = from; t < to; ++t) {
    const auto value = observed.at({tides.cell[t].start + lag, tides.cell[t].end + lag});
    if (!value) continue;
    const Horizontal o = *value - tides.observed_mean[t];
    both += std::conj(tides.product[t]) * o;
    product += std::norm(tides.product[t]);
    seen += std::norm(o) - 2 * noise_m2_s2;
    ++count;
  }
  if (2 * count < static_cast<double>(to - from) || product <= 0 || seen <= 0) return {};
  const Horizontal c = both / std::sqrt(product * seen);
  return std::abs(c) > 1 ? c / std::abs(c) : c;
}

double unexplained(double likeness) {
  return never_explained + 1 - (likeness > 0 ? likeness * likeness : 0);
}

/// The best of a set of lags and turns.
struct Best {
  double unexplained = 2;
  double lag_h = 0;
  double turn_rad = 0;

  void look_at(double lag, Horizontal c, double most_turned) {
    const double turn = std::clamp(std::arg(c), -most_turned, most_turned);
    const double left = slackwater::calibration::unexplained((c * std::polar(1.0, -turn)).real());
    if (left < unexplained) *this = {left, lag, turn};
  }
};

}  // namespace

std::optional<TideAgreement> tide_disagreement(const VectorColumn& product,
                                               const VectorColumn& observed,
                                               const std::vector<double>& noise_m_s,
                                               const FusionSettings& settings) {
  if (hides_the_tide(averaging_of(product.time))) return std::nullopt;
  const std::vector<Pair> pairs = pairs_of(product, observed, settings);
  if (pairs.size() < 12) return std::nullopt;
  Duration step = hours(1);
  for (std::size_t i = 1; i < std::min<std::size_t>(pairs.size(), 12); ++i)
    step = i == 1 ? pairs[i].time - pairs[i - 1].time
                  : std::min(step, pairs[i].time - pairs[i - 1].time);
  const Tides tides = tides_of(pairs, step);
  const std::size_t n = tides.time.size();
  const double hours_in_all = static_cast<double>(n) * hours_between({}, UtcTime(step));
  if (hours_in_all < least_hours) return std::nullopt;
  double motion = 0;
  Horizontal straight{};
  for (const Horizontal& p : tides.product) {
    motion += std::norm(p);
    straight += p * p;
  }
  if (std::sqrt(motion / static_cast<double>(n)) < least_motion_m_s) return std::nullopt;
  const bool is_circular = std::abs(straight) < most_circular * motion;
  if (is_circular && hours_in_all < least_hours_of_circles) return std::nullopt;

  const VectorColumn mean = depth_mean(observed, product.levels_m);
  const ObservedLevel level(mean, 0, settings);
  double noise = 0;
  for (const double one : noise_m_s) noise += one * one;
  if (!noise_m_s.empty())
    noise *=
        level.noise_left(tides.cell.front()) / std::pow(static_cast<double>(noise_m_s.size()), 2);

  Best honest;
  Best turned;
  Best late;
  for (double lag = -farthest_lag_h; lag <= farthest_lag_h + 1e-9; lag += lag_step_h) {
    const Horizontal c = likeness(tides, level, lag, noise, 0, n);
    const bool is_near = std::abs(lag) <= honest_lag_h;
    late.look_at(lag, c, honest_turn_rad);
    if (!is_near) continue;
    turned.look_at(lag, c, std::numbers::pi);
    honest.look_at(lag, c, honest_turn_rad);
  }
  const double least = std::min(turned.unexplained, late.unexplained);
  if (least > most_unexplained) return std::nullopt;
  const double independent = hours_in_all / (2 * settings.quick_memory_h);
  const double as_likely = least * std::exp(evidence / (2 * independent));
  if (honest.unexplained <= as_likely) return std::nullopt;
  TideAgreement found;
  found.is_turned = turned.unexplained <= as_likely;
  found.is_late = late.unexplained <= as_likely;
  const Best& said = found.is_turned ? turned : late;
  const Horizontal early = likeness(tides, level, said.lag_h, noise, 0, n / 2);
  const Horizontal later = likeness(tides, level, said.lag_h, noise, n / 2, n);
  const bool is_steady = std::norm(early) > 1 - 2 * most_unexplained &&
                         std::norm(later) > 1 - 2 * most_unexplained &&
                         std::abs(std::arg(early * std::conj(later))) < halves_apart_rad;
  if (!is_steady) return std::nullopt;
  found.turned_deg = -said.turn_rad * 180 / std::numbers::pi;
  found.late_h = found.is_late ? late.lag_h : said.lag_h;
  return found;
}

}  // namespace slackwater::calibration
