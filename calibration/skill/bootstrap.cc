#include "calibration/skill/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "fields/base/check.h"

namespace slackwater::calibration {

std::optional<Interval95> bootstrap_mean(std::span<const BlockSum> blocks, Rng& random, int draws) {
  expects(draws >= 40, "an interval of 95 % needs at least 40 draws");
  std::vector<BlockSum> filled;
  for (const BlockSum& block : blocks)
    if (block.weight > 0) filled.push_back(block);
  if (filled.size() < 2) return std::nullopt;
  const auto count = static_cast<double>(filled.size());
  std::vector<double> mean(static_cast<std::size_t>(draws));
  for (double& result : mean) {
    BlockSum drawn;
    for (std::size_t b = 0; b < filled.size(); ++b) {
      const BlockSum& block = filled[static_cast<std::size_t>(random.uniform() * count)];
      drawn.sum += block.sum;
      drawn.weight += block.weight;
    }
    result = drawn.sum / drawn.weight;
  }
  std::sort(mean.begin(), mean.end());
  const auto quantile = [&](double share) {
    return mean[static_cast<std::size_t>(std::lround(share * static_cast<double>(draws - 1)))];
  };
  return Interval95{quantile(0.025), quantile(0.975)};
}

std::optional<Interval95> bootstrap_rms(std::span<const BlockSum> blocks, Rng& random, int draws) {
  const std::optional<Interval95> squares = bootstrap_mean(blocks, random, draws);
  if (!squares) return std::nullopt;
  return Interval95{std::sqrt(squares->low), std::sqrt(squares->high)};
}

std::optional<Interval95> bootstrap_rmse(std::span<const double> squared_error,
                                         std::span<const std::size_t> block, Rng& random,
                                         int draws) {
  expects(squared_error.size() == block.size(), "one block id per value");
  std::map<std::size_t, BlockSum> by_id;
  for (std::size_t i = 0; i < block.size(); ++i) {
    BlockSum& sum = by_id[block[i]];
    sum.sum += squared_error[i];
    sum.weight += 1.0;
  }
  std::vector<BlockSum> blocks;
  blocks.reserve(by_id.size());
  for (const auto& [id, sum] : by_id) blocks.push_back(sum);
  return bootstrap_rms(blocks, random, draws);
}

}  // namespace slackwater::calibration
