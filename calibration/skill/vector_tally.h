#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "calibration/skill/bootstrap.h"
#include "calibration/skill/predictive.h"
#include "fields/base/frame.h"

namespace slackwater::calibration {

struct VectorScore;

/// What one pair of forecast and truth adds to any tally it belongs to, worked out once.
struct PairContribution {
  Horizontal forecast{};
  Horizontal truth{};
  double squared_error = 0;
  double speed_error = 0;
  std::optional<double> direction_error_deg;  ///< absolute; where both exceed 0.05 m/s
  std::optional<std::array<ComponentScore, 2>>
      spread;  ///< east, north; where the forecast has a spread
};
[[nodiscard]] PairContribution contribution_of(Horizontal forecast, Horizontal truth) noexcept;
/// The same with the standard deviation of each component. Throws ContractViolation for a negative
/// one.
[[nodiscard]] PairContribution contribution_of(Horizontal forecast, Horizontal truth,
                                               double sigma_m_s);

/// Sums from which every score of a vector forecast follows, so that scores by hour, band and
/// column are added up, never recomputed from the values. Adding and merging neither allocate nor
/// fail.
class VectorTally {
 public:
  void add(const PairContribution& pair) noexcept;
  void merge(const VectorTally& other) noexcept;
  [[nodiscard]] std::size_t size() const noexcept { return n_; }
  /// Sum and number of squared vector errors: a block of a bootstrap.
  [[nodiscard]] BlockSum squares() const noexcept { return {squares_, static_cast<double>(n_)}; }
  /// Throws ContractViolation where nothing was added.
  [[nodiscard]] VectorScore score() const;

 private:
  void score_correlation(VectorScore& score) const;
  void score_spread(VectorScore& score) const;

  static constexpr std::size_t pit_cells = 20;  ///< of 5 %: every quantile we report is an edge
  std::size_t n_ = 0;
  double squares_ = 0;
  Horizontal error_{};
  double speed_error_ = 0;
  double direction_error_deg_ = 0;
  std::size_t directions_ = 0;
  Horizontal forecast_{};
  Horizontal truth_{};
  Horizontal product_{};  ///< conj(forecast) truth
  double forecast_power_ = 0;
  double truth_power_ = 0;
  std::size_t spreads_ = 0;  ///< pairs with a spread
  double crps_ = 0;
  std::array<std::uint32_t, pit_cells> pit_{};
};

}  // namespace slackwater::calibration
