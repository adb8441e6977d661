#pragma once
#include "fields/base/time.h"

namespace slackwater::calibration {

/// The stated errors of fusion: of a product, of an instrument, and of taking one place for
/// another. All are standard deviations of one component.
struct FusionSettings {
  /// Of a product's current at a point. Analysed currents differ from drifters by about 0.10 m/s
  /// where no observation was assimilated (QUID of Copernicus INSITU_GLO_UV 013_044, section
  /// IV.1.2, "near 0.10 m/s"); shelf models are not better.
  double product_error_m_s = 0.10;
  /// e-folding distance of the product's error in depth. Ours: half the depth of the waters where
  /// wind farms stand; errors of tide and slope are nearly barotropic, those of the mixed layer
  /// not.
  double vertical_length_m = 25.0;
  /// Over which distance the product's errors at two places are alike, exp(-d/L). Ours: two to
  /// three cells of the 1/12 degree global product, some internal Rossby radii of the shelf.
  double product_length_m = 20000.0;
  /// Share of the product's error variance that is slow (bias, misplaced eddies), and its memory;
  /// the rest (wrong tide, wrong inertial phase) is forgotten within hours. Ours: half and half.
  double slow_share = 0.5;
  double slow_memory_h = 72.0;
  double quick_memory_h = 3.0;
  /// Of an average over some minutes by a moored profiler: zero offset of about 1 cm/s in the
  /// towing tank (NOAA/NOS tests of forty-one profilers), and pings, tilt and compass of the same
  /// size.
  double instrument_error_m_s = 0.02;
  /// Difference between two places: `difference_m_s` at `difference_m` apart, growing with the cube
  /// root of the distance. 5 cm/s over squares of 1 to 4 km2: Ohlmann et al. (2007), J. Atmos.
  /// Oceanic Technol. 24, 666. Structure function growing with the 2/3 power: Poje et al. (2014),
  /// PNAS 111, 12693.
  double difference_m_s = 0.05;
  double difference_m = 1500.0;
  /// An instrument farther away is not used.
  double farthest_m = 10000.0;
  /// An instant of the product takes the observation between neighbours at most this far apart; the
  /// tide turns by 45 degrees in it.
  Duration widest_gap = std::chrono::minutes(90);
  /// A mean takes the mean of the observations within its cell where they fill this share of it.
  double least_coverage = 0.5;
};

}  // namespace slackwater::calibration
