#pragma once
#include <string>
#include <vector>

#include "twin/control/autopilot.h"
#include "twin/vehicle/vehicle.h"

namespace slackwater::twin {

/// How a vehicle lies at rest in still water, by its weight and its buoyancy alone. Multirotors
/// have none of it.
struct Balance {
  double net_buoyancy_n = 0;  ///< of what swims: buoyancy less weight; 0 for what floats
  double stability_m = 0;     ///< BG, the centre of buoyancy above that of gravity; of what floats
                              ///< the metacentric height GM across
  double stability_long_m = 0;   ///< BG, or the metacentric height along
  double heel_rad = 0;           ///< at rest; to starboard
  double trim_rad = 0;           ///< bow down, with a moving mass at its best
  double trim_n_m = 0;           ///< moment that the moving mass does not take up, bow down
  double draught_m = 0;          ///< of what floats
  double keel_m = 0;             ///< of what floats: its lowest keel below the origin
  double beam_m = 0;             ///< of what floats: over all its waterlines
  double ahead_m = 0;            ///< of what floats: its weight forward of its buoyancy
  double aside_m = 0;            ///< and to starboard
  double least_freeboard_m = 0;  ///< of what floats: of the corner of its deck that lies lowest
};
/// Of a floating craft
///
///   GM = KB + BM - KG,  BM = I/V,
///
/// with I the second moment of the waterplane about its own centre and V the volume under water;
/// heel and trim are those of small angles, the distance of the centres of gravity and of buoyancy
/// over GM. Of one that swims, the plumb line goes through both centres.
/// Source: Fossen (2011), 4.1 and 4.2.
[[nodiscard]] Balance balance_of(const Vehicle& vehicle);

/// What is amiss with how a vehicle lies or goes.
struct VehicleFinding {
  bool is_error = false;
  const char* key = "";  ///< of the vehicle's YAML
  std::string what;      ///< found, expected, what to do
};

/// What no vehicle of that kind can have (errors), and what its owner wants to know (warnings).
///
/// What swims:
/// - BG not above 0: an error; below 1 % of its height (1): a warning.
/// - An AUV's net buoyancy beyond what its buoyancy engine takes and level flight (level_flight.h)
///   bears at the speed at which it circles a place: an error; beyond half of that pitch at cruise:
///   a warning. Elevator beyond its limit at cruise or the file's least speed: an error; over 80 %
///   (1): a warning. An ROV's beyond 5 % of its weight (1): a warning; see `expect_strength`.
/// - Heel or trim at rest above 30 degrees (1), an AUV's trim beyond its moving mass and its fins
///   at cruise speed: errors; above 5 degrees (1): a warning.
///
/// What floats:
/// - GM across or along not above 0: an error; across below 0.15 m of a vessel (2), 5 % of its beam
///   of a USV (1): a warning.
/// - Heel or trim at rest above 10 degrees (3), a corner of the deck under water: errors; above 3
///   degrees (1): a warning.
///
/// (1) An estimate. A REMUS 100 is 2.3 % light and has a BG of 10 % of its height (Prestero 2001).
/// (2) IMO, International Code on Intact Stability 2008 (MSC.267(85)), A 2.2.4.
/// (3) The same, A 3.1.1: the heel of a crowd on one side.
[[nodiscard]] std::vector<VehicleFinding> findings_on(const Vehicle& vehicle,
                                                      const Balance& balance);

/// What hangs on the strength of the thrusters at the voltage that an autopilot was worked out for:
/// an ROV's vertical ones hold its net buoyancy with a fifth in reserve, a multirotor's rotors hold
/// it level about its centre of gravity.
/// @throws Error(invalid_input) with the numbers
void expect_strength(const Vehicle& vehicle, const Autopilot& autopilot);

}  // namespace slackwater::twin
