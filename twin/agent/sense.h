#pragma once
#include "twin/environment/environment.h"
#include "twin/navigation/navigator.h"
#include "twin/navigation/sensor_suite.h"
#include "twin/vehicle/vehicle.h"

namespace slackwater::twin {

/// How a vehicle knows where it is: its instruments, and what it makes of them.
struct Navigation {
  SensorSuite instruments;
  Navigator navigator;
  bool steers = true;  ///< the autopilot goes by it; else by the truth, and it only goes along
};

/// Whether a vehicle can find its way by its own instruments: an IMU and a compass, what tells a
/// velocity (a GNSS receiver or a DVL), and under water a depth sensor.
/// @throws Error(invalid_input) that says what is missing
[[nodiscard]] Navigation plan_navigation(const Vehicle& vehicle, double dt_s, bool steers);

struct NavigationState {
  InstrumentState instruments;
  NavigatorState navigator;
  Triple<double>
      error_m;  ///< NED: where it takes itself to be less where it is, as of the last look
};
/// It has stood still for half a minute: IMU and compass are averaged, and the place is that of the
/// first fix, or else the one it was put in at, which its crew knows.
[[nodiscard]] NavigationState begun(const Navigation& navigation, std::uint64_t seed,
                                    std::string_view vehicle, const BodyState<double>& body);

/// What is around a vehicle for its instruments.
struct SensedWater {
  const EnvironmentSampler& sampler;
  double elevation_m = 0;  ///< of the surface above the vehicle
  double t_s = 0;
  bool has_gnss = true;  ///< the receiver works
};

/// Lets the instruments look and the navigator reckon. No allocation.
/// @return what the vehicle takes for true
[[nodiscard]] Measured sense(const Navigation& navigation, const SensedWater& water,
                             const BodyState<double>& body, NavigationState& state);

/// What sound meets about a place: the structures, the bed as deep as there, the surface.
[[nodiscard]] Scene scene_at(const SensedWater& water, const Triple<double>& position_m) noexcept;

}  // namespace slackwater::twin
