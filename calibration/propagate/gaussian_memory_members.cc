#include <cmath>

#include "calibration/propagate/gaussian_memory.h"
#include "fields/base/check.h"

namespace slackwater::calibration {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;

MatrixXcd GaussianMemory::draw(Index rows, Rng& random) const {
  const auto one = [&] {
    const double east = random.normal();
    return Horizontal(east, random.normal()) / std::sqrt(2.0);
  };
  // An exponential correlation along a line is an autoregression from level to level.
  MatrixXcd drawn = MatrixXcd::Zero(rows, static_cast<Index>(levels()));
  std::size_t before = by_depth_.front();
  for (const std::size_t here : by_depth_) {
    const double kept =
        here == before ? 0.0 : std::exp(-(depth_m_[here] - depth_m_[before]) / vertical_scale_m_);
    const double fresh = std::sqrt(1.0 - kept * kept);
    for (Index i = 0; i < rows; ++i)
      drawn(i, static_cast<Index>(here)) =
          kept * drawn(i, static_cast<Index>(before)) + fresh * one();
    before = here;
  }
  return drawn;
}

void GaussianMemory::sample(std::span<const UtcTime> times,
                            std::span<const Horizontal> wind_answer_later, Rng& random, int members,
                            std::span<Horizontal> departures) const {
  const std::size_t n = times.size() * levels();
  expects(members >= 0, "a number of members is not negative");
  expects(departures.size() == static_cast<std::size_t>(members) * n,
          "room for each member, time and level");
  const std::vector<HourCell> hours = hours_of(times);
  const std::vector<LevelRegression::Posterior> at = posteriors(hours, wind_answer_later);
  std::vector<MatrixXcd> factors;
  for (std::size_t g = 0; g < regressions_.size(); ++g)
    factors.push_back(regressions_[g].departure_factor(hours, at[g]));

  const auto rows = static_cast<Index>(times.size());
  std::size_t offset = 0;
  for (int member = 0; member < members; ++member, offset += n) {
    const MatrixXcd drawn = draw(rows + 1, random);
    for (std::size_t k = 0; k < levels(); ++k) {
      const std::size_t like = mix_[k].nearer();
      const auto [g, column] = place_[like];
      const VectorXcd own = drawn.col(static_cast<Index>(k));
      VectorXcd departure = factors[g].triangularView<Eigen::Lower>() * own.head(rows);
      departure +=
          regressions_[g].share_sigma(column) * own(rows) * at[g].share_missing.col(column);
      departure *= surprise_ * amplitude_[like];
      for (std::size_t t = 0; t < times.size(); ++t) {
        const auto i = static_cast<Index>(t);
        const double to_own_variance =
            like == k ? 1.0 : std::sqrt(variance_at(at, i, k) / at[g].variance(i, column));
        departures[offset + t * levels() + k] = to_own_variance * departure(i);
      }
    }
  }
}

}  // namespace slackwater::calibration
