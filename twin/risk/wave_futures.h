#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fields/service/snapshot.h"

namespace slackwater::twin {

/// Wave heights for the futures of a forecast: products of waves serve one sea. Future 0 keeps it;
/// in another its error is z(t) standard deviations (`height_error::height_at`) of the forecast's
/// own spread (`height_spread_of`).
///
/// z follows the wind of the member that the future goes with: as far as a wind that is 1 m/s
/// stronger raises a sea (`height_error::per_wind`), at most nine tenths of its variance; the rest
/// is a path of its own that remembers as exp(-t / 12 h), an estimate: half a day, about as long as
/// the error of a wind that raises a sea lasts.
///
/// Futures come in sets of 24, of one member after the other. In a set the paths of two members
/// that stand beside each other are opposite, and at each stamp their z are those of a normal,
/// evenly: no seed has more high seas than another. Sets differ in where between the strata they
/// draw, so that all of them together are as even again.
///
/// A future depends on (seed, site, day D), its number and the winds of its set, not on how many
/// others are asked for. With the 25 of one set a probability still moves by more than 0.03 with
/// the seed, with `many` by 0.02 at most (tests/twin/risk/wave_futures_test.cc).
class WaveFutures {
 public:
  static constexpr double memory_h = 12;
  static constexpr std::size_t set_size = 24;
  /// 83 whole sets and the central one.
  static constexpr std::size_t many = 1 + 83 * set_size;

  /// @param futures  at least 1, the central one among them
  WaveFutures(const Snapshot& forecast, std::size_t futures);

  /// Where a time lies between the stamps: the same for all futures.
  struct Moment {
    std::size_t low = 0;
    std::size_t high = 0;
    double of_low = 1;  ///< weights of z
    double of_high = 0;
    double spread = 0;
  };
  /// A time before the forecast is as its first, one after it as its last.
  [[nodiscard]] Moment moment(UtcTime time) const noexcept;
  /// NaN of NaN.
  /// @param central_m  significant height as forecast at the place
  [[nodiscard]] double height_m(std::size_t future, double central_m,
                                const Moment& at) const noexcept;
  [[nodiscard]] double height_m(std::size_t future, double central_m, UtcTime time) const noexcept {
    return height_m(future, central_m, moment(time));
  }
  /// Of the forecast, whose water goes with these waves.
  [[nodiscard]] std::size_t member_of(std::size_t future) const noexcept;
  [[nodiscard]] std::size_t futures() const noexcept { return paths_.size() + 1; }

 private:
  std::vector<UtcTime> time_;
  std::vector<double> spread_;
  std::size_t members_ = 1;
  std::vector<std::vector<double>> paths_;  ///< z of futures 1, 2, ... at each stamp
};

}  // namespace slackwater::twin
