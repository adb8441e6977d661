#pragma once
#include <array>
#include <complex>
#include <cstddef>
#include <string_view>

#include "api/made_up/synthetic/random_series.h"
#include "api/made_up/synthetic/wind_driven_column.h"
#include "fields/base/frame.h"
#include "fields/base/time.h"

namespace slackwater::api {

/// The tide of the synthetic ocean: M2, S2, N2, K1, O1 and M4, in the sizes of the bay of
/// Saint-Brieuc (streams of 0.3 m/s at neaps, 0.8 m/s at springs, range of 4 to 11 m), with true
/// astronomical arguments (nodal factors left at 1). Each constituent is an ellipse far from the
/// bed,
///
///   W = e^{i theta} [M cos(V - g) + i m sin(V - g)] = W+ e^{iV} + W- e^{-iV},
///
/// and each of its two rotary parts has its own bottom layer (`bottom_layer_factor` with sigma =
/// +-omega). The level of the surface goes with it: that of M2 is highest 75 degrees (2.6 h) after
/// the stream runs east, between a standing wave (90), as the closed end of the bay makes it, and
/// one that travels along the coast (0); the others alike (S2 76, N2 75, M4 70, K1 58, O1 35), each
/// of its own frequency, so that springs and neaps of both fall on the same days. The amplitude
/// and the lag vary gently in space: the wave travels east along the coast and grows towards it.
class Tide {
 public:
  static constexpr std::size_t constituents = 6;
  /// e^{iV} of every constituent at one time.
  using Arguments = std::array<std::complex<double>, constituents>;
  /// The rotary parts (W+, W-) of every constituent at one place and depth.
  struct RotaryParts {
    std::array<Horizontal, constituents> counter_clockwise;
    std::array<Horizontal, constituents> clockwise;
  };

  [[nodiscard]] static Arguments arguments(UtcTime time) noexcept;
  [[nodiscard]] static RotaryParts parts(const ColumnPhysics& physics, PlanePoint point,
                                         double water_depth_m, double depth_m) noexcept;
  [[nodiscard]] static Horizontal current(const RotaryParts& parts,
                                          const Arguments& arguments) noexcept;
  /// Height of the surface above mean sea level, metres.
  [[nodiscard]] static double elevation_m(PlanePoint point, const Arguments& arguments) noexcept;

  [[nodiscard]] static std::string_view name(std::size_t constituent) noexcept;
  /// Angular speed in degrees per hour, from the multiples of the lunar and solar motions.
  [[nodiscard]] static double speed_deg_h(std::size_t constituent) noexcept;
};

}  // namespace slackwater::api
