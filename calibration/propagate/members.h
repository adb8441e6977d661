#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "calibration/propagate/column_memory.h"
#include "calibration/propagate/ensemble_wind.h"
#include "calibration/propagate/wind_error.h"
#include "calibration/solve/calibration.h"

namespace slackwater::calibration {

/// Departures of the members of an ensemble from its centre, in pairs of opposite sign: parameters
/// and wind, then memory. Each pair follows one form, as often as the form's weight asks. Winds of
/// a weather ensemble come in no pairs.
///
/// Members are drawn in sets: forms, the spread of the winds and the scale to sigma are those of a
/// whole set, and the streams of a set have names of their own. So a member depends on the seed and
/// its number, not on how many others are asked for.
class Members {
 public:
  /// @param members  of the set; even
  /// @param size     times x levels
  /// @param set      which of them: 0, 1, ...
  Members(std::span<const Calibration> forms, const std::vector<double>& form_weight, int members,
          std::size_t size, std::uint64_t seed, std::size_t set = 0);

  /// Adds the wind-driven departures: the wind drawn from its error, the parameters from their
  /// posterior. From eight pairs on the winds spread at each sample exactly as their error says.
  /// With a weather ensemble each member has the wind of one of its (EnsembleWind), and departs as
  /// that wind drives it: the mean over members is then no longer the centre.
  /// @param central   the wind's part of each form, m/s
  /// @param ensemble  members x times; empty: none is known
  void draw_wind_driven(std::span<const UtcTime> times, const VectorColumn& wind,
                        UtcTime end_of_day, const WindErrorGrowth& wind_error,
                        std::span<const std::vector<Horizontal>> central,
                        const WindDepartures& ensemble = {});
  /// Adds what the memory of each form leaves open.
  void draw_memory(std::span<const UtcTime> times, std::span<const ColumnMemory> memory,
                   std::span<const std::vector<Horizontal>> central);

  /// Of a component, per time and level: mean over members of |d|^2/2. 0 without members.
  [[nodiscard]] std::vector<double> variance() const;
  /// Scales every time and level to this standard deviation of a component.
  void scale_to(const std::vector<double>& sigma_m_s);

  /// Members x times x levels.
  [[nodiscard]] const std::vector<Horizontal>& departures() const noexcept { return departure_; }
  /// Members x times, m/s; empty where no wind was drawn.
  [[nodiscard]] const std::vector<Horizontal>& wind_departures() const noexcept { return wind_; }
  /// Per member, the number of the ensemble's member whose wind it has; empty without an ensemble.
  [[nodiscard]] const std::vector<int>& wind_numbers() const noexcept { return wind_number_; }

 private:
  [[nodiscard]] std::span<Horizontal> member(std::size_t m) {
    return std::span(departure_).subspan(m * size_, size_);
  }

  std::span<const Calibration> forms_;
  std::size_t size_;
  std::uint64_t seed_;
  std::size_t set_;
  std::vector<std::size_t> form_of_pair_;
  std::vector<Horizontal> departure_;
  std::vector<Horizontal> wind_;
  std::vector<int> wind_number_;
};

}  // namespace slackwater::calibration
