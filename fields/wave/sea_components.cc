#include "fields/wave/sea_components.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "fields/base/text.h"
#include "fields/wave/spreading.h"
#include "fields/wave/variance_division.h"

namespace slackwater {
namespace {

using constants::pi;

constexpr double lowest_over_peak = 0.4;   ///< below lies exp(-48) of the variance
constexpr double highest_over_peak = 6.0;  ///< above lies 1e-3 of it
constexpr std::size_t table_points = 4096;
constexpr std::size_t least_share = 8;
constexpr double most_blocked = 0.02;

/// The three streams of a realisation, apart so that more frequencies do not move the phases.
struct Streams {
  explicit Streams(std::uint64_t run_seed)
      : frequencies(run_seed, "fields/wave/frequencies"),
        directions(run_seed, "fields/wave/directions"),
        phases(run_seed, "fields/wave/phases") {}
  Rng frequencies;
  Rng directions;
  Rng phases;
};

DensityTable table_of(const JonswapSpectrum& spectrum) {
  DensityTable table;
  const double step = std::log(highest_over_peak / lowest_over_peak) / (table_points - 1);
  for (std::size_t i = 0; i < table_points; ++i) {
    const double omega =
        lowest_over_peak * spectrum.peak_rad_s() * std::exp(step * static_cast<double>(i));
    table.frequency_rad_s.push_back(omega);
    table.density_m2_s.push_back(spectrum.density(omega));
  }
  return table;
}

/// Shares whose variance is `variance_m2` in total, whatever the table cut off.
std::vector<VarianceShare> shares_of(const DensityTable& table, double variance_m2,
                                     std::size_t count, Rng& rng) {
  std::vector<VarianceShare> shares = divide_variance(table, count, rng);
  double sum = 0;
  for (const VarianceShare& share : shares) sum += share.variance_m2;
  for (VarianceShare& share : shares) share.variance_m2 *= variance_m2 / sum;
  return shares;
}

/// 0, 1, ..., count - 1 in an order of the stream's choosing (Fisher & Yates).
std::vector<std::size_t> shuffled(std::size_t count, Rng& rng) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i) {
    const auto other = static_cast<std::size_t>(rng.uniform() * static_cast<double>(i));
    std::swap(order[i - 1], order[std::min(other, i - 1)]);
  }
  return order;
}

void add_waves(SeaComponents& sea, const std::vector<VarianceShare>& shares,
               const WavePartition& partition, const WaveWater& water, FrequencyFrame frame,
               Streams& streams) {
  const std::vector<std::size_t> strata = shuffled(shares.size(), streams.directions);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double probability = (static_cast<double>(strata[i]) + streams.directions.uniform()) /
                               static_cast<double>(shares.size());
    // The turn is symmetric, so that compass and mathematical sense give the same sea.
    const double turn = spreading_quantile_rad(partition.spreading_s, probability);
    const double from_deg = partition.from_direction_deg + Angle::from_radians(turn).degrees();
    const auto wave =
        wave_component(std::sqrt(2.0 * shares[i].variance_m2), shares[i].frequency_rad_s, frame,
                       from_deg, streams.phases.uniform(0.0, 2.0 * pi), water);
    if (wave) {
      sea.waves.push_back(*wave);
    } else {
      sea.blocked_variance_m2 += shares[i].variance_m2;
    }
  }
}

void expect_little_blocked(const SeaComponents& sea, double variance_m2, const WaveWater& water) {
  if (sea.blocked_variance_m2 <= most_blocked * variance_m2) return;
  throw Error(
      ErrorKind::invalid_input,
      formatted(
          "a current of {:.2f} m/s blocks {:.0f} % of the wave energy, at most {:.0f} % can be "
          "left out; give the spectrum in intrinsic frequencies, or a weaker current",
          std::abs(water.current_m_s), 100.0 * sea.blocked_variance_m2 / variance_m2,
          100.0 * most_blocked));
}

/// How many sinusoids each partition gets: in proportion to its height, the rest to the highest.
std::vector<std::size_t> counts_by_height(const std::vector<WavePartition>& partitions,
                                          std::size_t count) {
  double sum = 0;
  std::size_t highest = 0;
  for (std::size_t i = 0; i < partitions.size(); ++i) {
    sum += partitions[i].significant_height_m;
    if (partitions[i].significant_height_m > partitions[highest].significant_height_m) highest = i;
  }
  const double free = static_cast<double>(count - least_share * partitions.size());
  std::vector<std::size_t> counts;
  std::size_t given = 0;
  for (const WavePartition& p : partitions) {
    counts.push_back(least_share + static_cast<std::size_t>(free * p.significant_height_m / sum));
    given += counts.back();
  }
  counts[highest] += count - given;
  return counts;
}

}  // namespace

SeaComponents components_of(const PartitionedSea& sea, const WaveWater& water,
                            std::uint64_t run_seed, const ComponentChoice& choice) {
  std::vector<WavePartition> partitions;
  for (const WavePartition& p : sea.partitions) {
    if (p.significant_height_m > 0) partitions.push_back(p);
  }
  SeaComponents result;
  if (partitions.empty()) return result;
  expects(choice.count >= least_share * partitions.size(),
          "a sea needs eight sinusoids or more for each partition");
  Streams streams(run_seed);
  const std::vector<std::size_t> counts = counts_by_height(partitions, choice.count);
  for (std::size_t i = 0; i < partitions.size(); ++i) {
    const WavePartition& p = partitions[i];
    const double variance = p.significant_height_m * p.significant_height_m / 16.0;
    add_waves(result, shares_of(table_of(p.spectrum()), variance, counts[i], streams.frequencies),
              p, water, choice.frame, streams);
  }
  const double height_m = sea.significant_height_m();
  expect_little_blocked(result, height_m * height_m / 16.0, water);
  return result;
}

}  // namespace slackwater
