#include "tests/scenarios/ensemble_score.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater::calibration {
namespace {

/// How many ordered pairs of n members are independent of each other.
double pairs_of(double n, Drawn drawn) {
  if (drawn == Drawn::as_they_are) return n * n;
  return drawn == Drawn::independently ? n * (n - 1) : n * (n - 2);
}

double distance(std::span<const double> a, std::span<const double> b) {
  double squares = 0;
  for (std::size_t i = 0; i < a.size(); ++i) squares += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(squares);
}

}  // namespace

double ensemble_quantile(std::span<const double> ascending, double probability) {
  expects(!ascending.empty(), "an ensemble has a member");
  expects(probability > 0 && probability < 1, "a quantile of a probability within (0, 1)");
  const double place = probability * static_cast<double>(ascending.size() + 1) - 1.0;
  if (place <= 0) return ascending.front();
  const auto low = static_cast<std::size_t>(place);
  if (low + 1 >= ascending.size()) return ascending.back();
  const double share = place - static_cast<double>(low);
  return (1.0 - share) * ascending[low] + share * ascending[low + 1];
}

double probability_below(std::span<const double> ascending, double y) {
  expects(!ascending.empty(), "an ensemble has a member");
  const auto n = static_cast<double>(ascending.size());
  const auto first = std::lower_bound(ascending.begin(), ascending.end(), y);
  const auto beyond = std::upper_bound(first, ascending.end(), y);
  if (first != beyond) {  // the middle of the members that are y
    const auto below = static_cast<double>(first - ascending.begin());
    const auto up_to = static_cast<double>(beyond - ascending.begin());
    return 0.5 * (below + 1.0 + up_to) / (n + 1.0);
  }
  if (first == ascending.begin()) return 0.5 / (n + 1.0);
  if (first == ascending.end()) return 1.0 - 0.5 / (n + 1.0);
  const double low = *std::prev(first);
  const auto below = static_cast<double>(first - ascending.begin());
  return (below + (y - low) / (*first - low)) / (n + 1.0);
}

double ensemble_crps(std::span<const double> ascending, double y, Drawn drawn) {
  expects(drawn != Drawn::in_opposite_pairs, "who is opposite to whom is lost by sorting");
  expects(ascending.size() > (drawn == Drawn::as_they_are ? 0U : 1U),
          "an ensemble has members to compare");
  const auto n = static_cast<double>(ascending.size());
  double off = 0;
  double apart = 0;  // sum over i < j of x_j - x_i
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    off += std::abs(ascending[i] - y);
    apart += (2.0 * static_cast<double>(i) + 1.0 - n) * ascending[i];
  }
  return off / n - apart / pairs_of(n, drawn);
}

double energy_score(std::span<const double> members, std::span<const double> y, Drawn drawn) {
  expects(!y.empty() && members.size() % y.size() == 0, "members have the truth's dimensions");
  const std::size_t n = members.size() / y.size();
  expects(drawn != Drawn::in_opposite_pairs || n % 2 == 0, "opposite members come in pairs");
  const double pairs = pairs_of(static_cast<double>(n), drawn);
  expects(pairs > 0, "an ensemble has members to compare");
  const auto member = [&](std::size_t i) { return members.subspan(i * y.size(), y.size()); };
  double off = 0;
  double apart = 0;
  for (std::size_t i = 0; i < n; ++i) {
    off += distance(member(i), y);
    for (std::size_t j = i + 1; j < n; ++j) {
      const bool is_opposite = drawn == Drawn::in_opposite_pairs && j == i + 1 && i % 2 == 0;
      if (!is_opposite) apart += distance(member(i), member(j));
    }
  }
  return off / static_cast<double>(n) - apart / pairs;
}

double variogram_score(std::span<const double> members, std::span<const double> y,
                       std::span<const VariogramPair> pairs, double power) {
  expects(!y.empty() && !members.empty() && members.size() % y.size() == 0,
          "members have the truth's dimensions");
  expects(power > 0, "a variogram of a positive order");
  const std::size_t n = members.size() / y.size();
  double score = 0;
  for (const VariogramPair& pair : pairs) {
    expects(pair.from < y.size() && pair.to < y.size(), "dimensions of the truth");
    double forecast = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double* x = members.data() + i * y.size();
      forecast += std::pow(std::abs(x[pair.from] - x[pair.to]), power);
    }
    const double miss =
        std::pow(std::abs(y[pair.from] - y[pair.to]), power) - forecast / static_cast<double>(n);
    score += pair.weight * miss * miss;
  }
  return score;
}

}  // namespace slackwater::calibration
