#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "fields/base/frame.h"
#include "fields/wind/turbine.h"
#include "fields/wind/wake.h"

namespace slackwater {

/// How the deficits of several wakes make one (the four classic rules; Porte-Agel, Bastankhah &
/// Shamsoddin 2020, Boundary-Layer Meteorol. 174, section 6.1):
///
///   free stream, linear            Lissaman (1979)       overestimates the loss in deep arrays
///   free stream, root sum square   Katic et al. (1986)   the usual company of Jensen's wake
///   local inflow, root sum square  Voutsinas (1990)
///   local inflow, linear           Niayifar & Porte-Agel (2016)
struct Superposition {
  enum class Scale { free_stream, local_inflow };  ///< the speed that a deficit is a fraction of
  enum class Sum { linear, root_sum_square };
  Scale scale = Scale::local_inflow;
  Sum sum = Sum::linear;
  bool operator==(const Superposition&) const = default;
};

struct FarmSettings {
  WakeSettings wake;
  Superposition superposition;
  double turbulence_intensity = 0.08;  ///< of the free wind at hub height, a fraction
  bool added_turbulence = true;        ///< Crespo & Hernandez, from the strongest wake upstream
  bool operator==(const FarmSettings&) const = default;
};

/// What one turbine feels and makes. Rotors face the free wind.
struct TurbineFlow {
  Horizontal position_m;        ///< east, north of the site's origin
  double inflow_speed_m_s = 0;  ///< mean over the disc
  double turbulence_intensity = 0;
  double thrust_coefficient = 0;
  double power_w = 0;
  bool operator==(const TurbineFlow&) const = default;
};

/// Points of a horizontal map, west to east within rows from south to north.
struct HorizontalGrid {
  Horizontal south_west_m;
  double step_east_m = 0;
  double step_north_m = 0;
  std::size_t columns = 0;
  std::size_t rows = 0;
};

/// The steady flow through a farm of equal turbines for one wind: solved once, turbine by turbine
/// from upwind to downwind, then sampled anywhere. Immutable.
///
/// The wind over a rotor is the mean over 32 points of its disc; the power is that of this mean.
class FarmFlow {
 public:
  /// @param turbines_m        positions (m, ENU); equal positions are refused
  /// @param wind_at_hub_m_s   free wind at hub height, ENU, towards
  FarmFlow(const Turbine& turbine, std::span<const Horizontal> turbines_m,
           Horizontal wind_at_hub_m_s, const FarmSettings& settings);

  /// In the order in which the positions were given.
  [[nodiscard]] const std::vector<TurbineFlow>& turbines() const noexcept { return turbines_; }
  [[nodiscard]] double power_w() const noexcept;
  [[nodiscard]] double free_speed_m_s() const noexcept { return free_speed_m_s_; }

  /// What wakes leave of the wind at a point, in [0, 1]: multiply the free wind of that height with
  /// it. 1 outside all wakes. Cost: some ten ns per turbine; no allocation.
  [[nodiscard]] double speed_ratio(Horizontal position_m, double height_m) const noexcept;
  /// Turbulence at a point: the standard deviation along the wind over the free speed at hub
  /// height. That of the free wind outside all wakes; in them, sqrt(I0^2 + I+^2) with the wake that
  /// adds most there (Crespo & Hernandez 1996 for how much, Ishihara & Qian 2018 for where;
  /// wake_turbulence.h). Cost: some 100 ns per turbine upwind; no allocation.
  [[nodiscard]] double turbulence_intensity(Horizontal position_m, double height_m) const noexcept;
  [[nodiscard]] double free_turbulence_intensity() const noexcept { return free_turbulence_; }
  /// `speed_ratio` at hub height over a map, into columns x rows values; no allocation.
  void speed_ratios(const HorizontalGrid& grid, std::span<double> out) const;

 private:
  struct PlacedWake {
    double along_m;   ///< of the turbine, down the wind
    double across_m;  ///< to the left of the wind
    double scale;     ///< speed that the deficit is a fraction of, over the free speed
    double thrust_coefficient;
    Wake wake;
  };
  void solve_turbine(const Turbine& turbine, std::size_t index, const FarmSettings& settings);
  [[nodiscard]] double combine(double total) const noexcept;

  double free_speed_m_s_;
  Horizontal downwind_;  ///< unit vector, towards
  double hub_height_m_;
  double diameter_m_;
  Superposition superposition_;
  double free_turbulence_;
  bool adds_turbulence_;
  std::vector<TurbineFlow> turbines_;
  std::vector<PlacedWake> wakes_;  ///< from upwind to downwind
};

}  // namespace slackwater
