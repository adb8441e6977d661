#pragma once
#include <array>
#include <optional>
#include <vector>

#include "twin/environment/environment.h"

namespace slackwater::people {

/// Where behind a turbine it is told what its wake and others leave of the wind, in diameters.
inline constexpr std::array behind_diameters{2.0, 5.0, 10.0};

/// What one turbine makes, and leaves.
struct TurbineNow {
  double power_w = 0;
  double wind_m_s = 0;           ///< over its rotor
  double rotor_speed_rad_s = 0;  ///< as the renders have it (turning_rotor.h)
  std::array<double, behind_diameters.size()> wind_left{};  ///< share of the free wind, hub height
};

/// What the turbines of a site make now.
struct FarmNow {
  double power_w = 0, rated_w = 0;
  std::vector<TurbineNow> turbines;  ///< in the order of their places
};

/// What they make of the wind, wakes and all. Worked out anew once the wind is
/// another by what changes the answer; not thread-safe.
class FarmOutput {
 public:
  explicit FarmOutput(twin::StandingTurbines turbines) : turbines_(std::move(turbines)) {}
  /// @param hub_wind_m_s  free wind at hub height, towards
  [[nodiscard]] FarmNow at(Horizontal hub_wind_m_s);

 private:
  twin::StandingTurbines turbines_;
  std::optional<Horizontal> worked_out_for_m_s_;
  FarmNow now_;
};

}  // namespace slackwater::people
