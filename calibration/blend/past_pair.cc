#include "calibration/blend/past_pair.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater::calibration {
namespace {

using Eigen::Index;

/// A candidate may lack this share of a pair's values (a level too short for a tide, say).
constexpr double greatest_gap = 0.1;

/// (1000 m/s)^2: whatever made such errors, it was no forecast.
constexpr double greatest_mean_square = 1e6;

bool is_finite(Horizontal value) noexcept {
  return std::isfinite(value.real()) && std::isfinite(value.imag());
}

bool all_have(std::span<const std::vector<Horizontal>> errors, const std::vector<bool>& present,
              std::size_t value) {
  for (std::size_t c = 0; c < errors.size(); ++c) {
    if (present[c] && !is_finite(errors[c][value])) return false;
  }
  return true;
}

std::vector<bool> those_nearly_complete(std::span<const std::vector<Horizontal>> errors) {
  std::vector<double> have(errors.size(), 0.0);
  for (std::size_t c = 0; c < errors.size(); ++c) {
    have[c] = static_cast<double>(std::count_if(errors[c].begin(), errors[c].end(), is_finite));
  }
  const double most = have.empty() ? 0.0 : *std::max_element(have.begin(), have.end());
  std::vector<bool> present(errors.size());
  for (std::size_t c = 0; c < errors.size(); ++c) {
    present[c] = have[c] > 0 && have[c] >= (1.0 - greatest_gap) * most;
  }
  return present;
}

/// How many of a candidate's moments with present ones are not finite.
int unusable_moments(const PastPair& pair, Index a) {
  int count = 0;
  for (Index b = 0; b < pair.gram.cols(); ++b) {
    if (!pair.present[static_cast<std::size_t>(b)]) continue;
    if (!std::isfinite(pair.gram(a, b)) || !std::isfinite(pair.gram(b, a))) ++count;
  }
  return count;
}

}  // namespace

PastPair pair_of_errors(std::span<const std::vector<Horizontal>> errors, double age_days) {
  PastPair pair;
  pair.age_days = age_days;
  pair.present = those_nearly_complete(errors);
  const auto k = static_cast<Index>(errors.size());
  pair.gram = Eigen::MatrixXd::Zero(k, k);
  std::size_t length = 0;
  for (const auto& of_one : errors) length = std::max(length, of_one.size());
  for (const auto& of_one : errors) {
    expects(of_one.empty() || of_one.size() == length, "errors of a pair are equally long");
  }
  for (std::size_t value = 0; value < length; ++value) {
    if (!all_have(errors, pair.present, value)) continue;
    ++pair.values;
    for (Index a = 0; a < k; ++a) {
      if (!pair.present[static_cast<std::size_t>(a)]) continue;
      const Horizontal left = errors[static_cast<std::size_t>(a)][value];
      for (Index b = 0; b <= a; ++b) {
        if (!pair.present[static_cast<std::size_t>(b)]) continue;
        pair.gram(a, b) += (std::conj(left) * errors[static_cast<std::size_t>(b)][value]).real();
      }
    }
  }
  for (Index a = 0; a < k; ++a) {
    for (Index b = 0; b <= a; ++b) {
      pair.gram(a, b) /= std::max(1.0, static_cast<double>(pair.values));
      pair.gram(b, a) = pair.gram(a, b);
    }
  }
  return without_unusable(std::move(pair));
}

PastPair without_unusable(PastPair pair) {
  const auto k = static_cast<Index>(pair.present.size());
  expects(pair.gram.rows() == k && pair.gram.cols() == k,
          "the moments of a pair are candidates x candidates");
  expects(std::isfinite(pair.age_days) && pair.age_days >= 0,
          "a past pair is not younger than the day that is forecast from");
  for (Index a = 0; a < k; ++a) {
    const double mean_square = pair.gram(a, a);
    if (pair.values == 0 || !(mean_square >= 0 && mean_square <= greatest_mean_square)) {
      pair.present[static_cast<std::size_t>(a)] = false;
    }
  }
  while (true) {
    Index worst = -1;
    int most = 0;
    for (Index a = 0; a < k; ++a) {
      if (!pair.present[static_cast<std::size_t>(a)]) continue;
      const int count = unusable_moments(pair, a);
      if (count > 0 && count >= most) {
        most = count;
        worst = a;
      }
    }
    if (worst < 0) return pair;
    pair.present[static_cast<std::size_t>(worst)] = false;
  }
}

}  // namespace slackwater::calibration
