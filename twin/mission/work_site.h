#pragma once
#include <optional>
#include <string>
#include <vector>

#include "twin/scene/structure.h"

namespace slackwater::twin {

/// A mooring line of a floating foundation, as the straight way between its ends.
struct MooringLine {
  std::string id;
  Triple<double> fairlead_m;
  Triple<double> anchor_m;
};

/// A turbine where work is done: NED metres about the run's origin.
struct WorkTurbine {
  std::string id;
  double north_m = 0;
  double east_m = 0;
  double bed_m = 0;           ///< depth of water
  double radius_m = 3;        ///< of the foundation, or of the circle about it
  double top_m = -20;         ///< z of the transition piece's upper edge: negative
  double foot_m = 0;          ///< z of its lower end: the bed, or the draught of one that floats
  double hub_m = 0;           ///< z of the hub: negative; 0: nobody says
  double rotor_radius_m = 0;  ///< 0: nobody says
  double landing_rad = 0;     ///< bearing of the boat landing from the axis
  std::vector<MooringLine> moorings;

  /// A place by bearing and distance from the axis.
  [[nodiscard]] Triple<double> around(double bearing_rad, double distance_m, double down_m) const;
  [[nodiscard]] bool floats() const noexcept { return foot_m < bed_m; }
};

/// What a cable is for, by what it joins.
enum class CableRole {
  array,     ///< a turbine at either end
  to_shore,  ///< "export": it leads off from a turbine, or past them
};

/// A cable on the bed.
struct WorkCable {
  std::string id;
  std::vector<Triple<double>> route_m;
  std::optional<double> burial_m;  ///< of its top below the bed; nothing: nobody says
  CableRole role = CableRole::array;
};

/// All that the geometry of a task is made from.
struct WorkSite {
  std::vector<WorkTurbine> turbines;
  std::vector<WorkCable> cables;
};

}  // namespace slackwater::twin
