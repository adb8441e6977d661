#include "twin/risk/chance_calibration.h"

#include <algorithm>
#include <cmath>

#include "fields/base/numbers/square.h"

namespace slackwater::twin {
namespace {

constexpr double starts_a_morning = 2;
constexpr double shift_sigma = 0.7;
constexpr double slope_sigma = 0.2;
/// What is surer than this is not told apart: one start that came otherwise would outweigh all.
constexpr double surest = 0.995;

double logit(double p) noexcept {
  const double held = std::clamp(p, 1 - surest, surest);
  return std::log(held / (1 - held));
}
double logistic(double x) noexcept { return 1 / (1 + std::exp(-x)); }

struct Pair {
  double x = 0;
  double y = 0;
  double weight = 1;
};

/// The likeliest shift and slope by Newton's method: the sum is convex. The slope stays at 0 where
/// it would fall below.
void fit(const std::vector<Pair>& pairs, ChanceCalibration& to) {
  constexpr int most_steps = 50;
  for (int step = 0; step < most_steps; ++step) {
    double da = to.shift / square(shift_sigma), db = (to.slope - 1) / square(slope_sigma);
    double aa = 1 / square(shift_sigma), ab = 0, bb = 1 / square(slope_sigma);
    for (const Pair& pair : pairs) {
      const double p = logistic(to.shift + to.slope * pair.x);
      const double off = pair.weight * (p - pair.y);
      const double curvature = pair.weight * p * (1 - p);
      da += off;
      db += off * pair.x;
      aa += curvature;
      ab += curvature * pair.x;
      bb += curvature * pair.x * pair.x;
    }
    const bool is_flat = to.slope <= 0 && db > 0;
    const double determinant = aa * bb - ab * ab;
    const double shift = is_flat ? da / aa : (bb * da - ab * db) / determinant;
    const double slope = is_flat ? 0 : (aa * db - ab * da) / determinant;
    // Steps of at most 1: farther off the curvature is another.
    const double most = std::max({1.0, std::abs(shift), std::abs(slope)});
    to.shift -= shift / most;
    to.slope = std::max(0.0, to.slope - slope / most);
    if (std::abs(shift) + std::abs(slope) < 1e-10) return;
  }
}

}  // namespace

double ChanceCalibration::operator()(double probability) const noexcept {
  if (starts == 0) return probability;
  // Beyond what is told apart it goes on as steeply as there.
  const double p = std::clamp(probability, 1e-12, 1 - 1e-12);
  return logistic(shift + slope * std::log(p / (1 - p)));
}

ChanceCalibration chance_calibration(std::span<const PastStarts> mornings) {
  ChanceCalibration out;
  std::vector<Pair> pairs;
  for (const PastStarts& morning : mornings) {
    if (morning.empty()) continue;
    ++out.mornings;
    out.starts += morning.size();
    for (const PastStart& start : morning) {
      out.said += start.said;
      out.held += start.held ? 1 : 0;
      pairs.push_back({logit(start.said), start.held ? 1.0 : 0.0,
                       starts_a_morning / static_cast<double>(morning.size())});
    }
  }
  if (out.starts == 0) return out;
  out.said /= static_cast<double>(out.starts);
  out.held /= static_cast<double>(out.starts);
  fit(pairs, out);
  return out;
}

}  // namespace slackwater::twin
