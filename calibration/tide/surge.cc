#include "calibration/tide/surge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "calibration/tide/level_tide.h"
#include "fields/record/slice.h"

namespace slackwater::calibration {
namespace {

using std::chrono::days;
using std::chrono::hours;

constexpr double prior_sigma_m = 0.10;
constexpr double prior_share_of_tide = 0.1;
constexpr Duration class_width = hours(12);
/// Two semidiurnal and one diurnal tide: what the fit has left of them averages out.
constexpr Duration tidal_window = hours(25);
constexpr int most_days = 21;
constexpr int fewest_days = 3;
constexpr std::array memories{Duration(hours(0)),  Duration(hours(6)),  Duration(hours(12)),
                              Duration(hours(24)), Duration(hours(48)), Duration(hours(96))};
constexpr std::array windows{Duration(0), tidal_window};

std::size_t class_of(Duration lead) {
  return static_cast<std::size_t>(std::max(Duration(0), lead) / class_width);
}

/// Sums of squares by class of lead.
struct Squares {
  std::vector<double> sum;
  std::vector<std::size_t> count;
  double whole = 0;

  void add(Duration lead, double error) {
    const std::size_t k = class_of(lead);
    if (k >= sum.size()) sum.resize(k + 1, 0), count.resize(k + 1, 0);
    sum[k] += error * error;
    ++count[k];
    whole += error * error;
  }
};

LevelErrors errors_of(const Squares& squares) {
  LevelErrors errors;
  double sigma_m = least_level_sigma_m;
  for (std::size_t k = 0; k < squares.sum.size(); ++k) {
    if (squares.count[k] > 0)
      sigma_m =
          std::max(sigma_m, std::sqrt(squares.sum[k] / static_cast<double>(squares.count[k])));
    errors.sigma_m.push_back(sigma_m);
  }
  return errors;
}

UtcTime end_of(const ScalarColumn& known) { return known.time.back().centre(); }

LevelHindcast prior_of(const ScalarColumn& known) {
  const TideFit fit = fit_level_tide(known.time, known.value, known.status);
  double tide_m2 = 0;
  for (const TimeCell& cell : known.time) {
    const double tide_m = level_over(fit, cell) - fit.mean.real();
    tide_m2 += tide_m * tide_m / static_cast<double>(known.times());
  }
  const double sigma_m = std::sqrt(prior_sigma_m * prior_sigma_m +
                                   prior_share_of_tide * prior_share_of_tide * tide_m2 +
                                   fit.residual_rms_m_s * fit.residual_rms_m_s);
  return {{days(1), tidal_window}, {{sigma_m}}, 0};
}

}  // namespace

double LevelErrors::at(Duration lead) const noexcept {
  return sigma_m[std::min(class_of(lead), sigma_m.size() - 1)];
}

double departure_at_end(const ScalarColumn& known, const TideFit& fit, Duration window) {
  double sum_m = 0;
  double count = 0;
  std::optional<UtcTime> last;
  for (std::size_t t = known.times(); t-- > 0;) {
    if (!known.has(t)) continue;
    if (!last) last = known.time[t].centre();
    if (known.time[t].centre() < *last - window) break;
    sum_m += known.value[t] - level_over(fit, known.time[t]);
    ++count;
  }
  return count > 0 ? sum_m / count : 0;
}

double share_left(const SurgeMemory& surge, Duration after) noexcept {
  if (after <= Duration(0)) return 1;
  if (surge.memory <= Duration(0)) return 0;
  return std::exp(-static_cast<double>(after.count()) / static_cast<double>(surge.memory.count()));
}

LevelHindcast hindcast_level(const ScalarColumn& known, Duration horizon) {
  const UtcTime first = known.time.front().centre();
  const UtcTime last = end_of(known);
  const Duration least = std::max<Duration>(shortest_tide_record, (last - first) / 2);
  std::array<std::array<Squares, windows.size()>, memories.size()> tried;
  std::size_t past_days = 0;
  for (int back = 1; back <= most_days; ++back) {
    const UtcTime origin = last - days(back);
    if (origin - first < least) break;
    const ScalarColumn before = slice(known, UtcTime::min(), origin);
    if (before.time.empty() || record_length(before.time, before.status) < shortest_tide_record)
      break;
    const TideFit fit = fit_level_tide(before.time, before.value, before.status);
    std::array<double, windows.size()> departure_m{};
    for (std::size_t w = 0; w < windows.size(); ++w)
      departure_m[w] = departure_at_end(before, fit, windows[w]);
    for (std::size_t t = before.times(); t < known.times(); ++t) {
      const Duration lead = known.time[t].centre() - origin;
      if (!known.has(t) || lead <= Duration(0)) continue;
      if (lead > horizon) break;
      const double off_m = known.value[t] - level_over(fit, known.time[t]);
      for (std::size_t m = 0; m < memories.size(); ++m) {
        for (std::size_t w = 0; w < windows.size(); ++w)
          tried[m][w].add(lead,
                          off_m - departure_m[w] * share_left({memories[m], windows[w]}, lead));
      }
    }
    ++past_days;
  }
  if (past_days < fewest_days) return prior_of(known);
  LevelHindcast best;
  double least_sum = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < memories.size(); ++m) {
    for (std::size_t w = 0; w < windows.size(); ++w) {
      if (!(tried[m][w].whole < least_sum)) continue;
      least_sum = tried[m][w].whole;
      best = {{memories[m], windows[w]}, errors_of(tried[m][w]), past_days};
    }
  }
  return best.errors.sigma_m.empty() ? prior_of(known) : best;
}

}  // namespace slackwater::calibration
