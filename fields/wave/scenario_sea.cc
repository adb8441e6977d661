#include "fields/wave/scenario_sea.h"

#include <cmath>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "fields/wave/growth.h"

namespace slackwater {
namespace {

/// A height at the limit, worked out elsewhere, may pass it by rounding alone.
constexpr double room_for_rounding = 1.0 + 1e-9;

/// Shortest period that carries this height: `steepest_height_m` grows with the period.
double least_period_s(double height_m) {
  double low = 0.0;
  double high = 1.0;
  while (steepest_height_m(high) < height_m) high *= 2.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (steepest_height_m(middle) < height_m ? low : high) = middle;
  }
  return high;
}

[[noreturn]] void refuse(const std::string& what, const std::string& why) {
  throw Error(ErrorKind::invalid_input, what + ": " + why);
}

void expect_range(const std::string& what, const char* key, double found, double low, double high) {
  if (found >= low && found <= high) return;
  refuse(what, formatted("found {} = {:g}, expected {:g} to {:g}", key, found, low, high));
}

void expect_existing(const std::string& what, double height_m, double period_s) {
  const double limit_m = steepest_height_m(period_s);
  if (height_m <= limit_m * room_for_rounding) return;
  refuse(
      what,
      formatted("found Hs {:.4g} m with Tp {:.4g} s, a steepness 2 pi Hs/(g Tp^2) of {:.3f}; such "
                "waves break, the limit is {:.3f} (DNV-RP-C205); lower Hs to {:.3g} m or less, "
                "or lengthen Tp to {:.3g} s or more",
                height_m, period_s, steepness_of(height_m, period_s),
                steepness_of(limit_m, period_s), std::floor(limit_m * 100.0) / 100.0,
                std::ceil(least_period_s(height_m) * 100.0) / 100.0));
}

void expect_sound(const std::string& what, const WavePartition& partition) {
  expect_range(what, "significant_height_m", partition.significant_height_m, 0.0, 40.0);
  expect_range(what, "peak_period_s", partition.peak_period_s, 0.1, 60.0);
  expect_range(what, "from_direction_deg", partition.from_direction_deg, -360.0, 360.0);
  expect_range(what, "spreading_s", partition.spreading_s, 0.0, 1000.0);
  if (partition.gamma) expect_range(what, "gamma", *partition.gamma, 1.0, 10.0);
}

}  // namespace

PartitionedSea scenario_sea(std::span<const WavePartition> partitions, const std::string& what) {
  PartitionedSea sea;
  for (std::size_t i = 0; i < partitions.size(); ++i) {
    const std::string which = what + ", partition " + std::to_string(i + 1);
    expect_sound(which, partitions[i]);
    expect_existing(which, partitions[i].significant_height_m, partitions[i].peak_period_s);
    sea.partitions.push_back(partitions[i]);
  }
  const double total_m = sea.significant_height_m();
  if (total_m > 0) expect_existing(what + ", in total", total_m, sea.peak_period_s());
  return sea;
}

}  // namespace slackwater
