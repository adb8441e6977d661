#pragma once
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "twin/body/vehicle_kind.h"
#include "twin/environment/environment.h"
#include "twin/inspection/inspection.h"
#include "twin/render/scene/render_scene.h"
#include "twin/traffic/traffic_picture.h"

namespace slackwater::twin {

/// How a vehicle looks from outside, as its file has it.
struct VehicleShape {
  VehicleKind kind = VehicleKind::rov;
  Triple<double> size_m;    ///< length, width, height
  Triple<double> middle_m;  ///< of its hull, body axes
};
/// `kind` and `dimensions_m` of a vehicle's file, which `read_vehicle` checks as a whole; the keel
/// of one with `hulls`.
/// @throws Error(invalid_input), Error(not_found)
[[nodiscard]] VehicleShape read_vehicle_shape(const std::filesystem::path& file);

/// A vehicle at a moment.
struct SeenVehicle {
  std::string name;
  VehicleShape shape;
  Triple<double> position_m;  ///< NED of the run
  Rotation<double> attitude;  ///< body to NED
};

/// The line of a vehicle at a moment.
struct SeenTether {
  std::string name;
  double diameter_m = 0;
  std::vector<Triple<double>> at_m;  ///< from its top to the vehicle, NED of the run
};

/// What the scene of a run is made of at a moment.
struct RunMoment {
  const EnvironmentSampler& sampler;  ///< of its water, and the sea as somebody leads it
  std::span<const std::shared_ptr<const Inspection>> inspections;  ///< each once
  std::span<const SeenVehicle> vehicles;  ///< but the one that looks: it does not see itself
  std::span<const SeenTether> tethers;    ///< with that of the one that looks
  const std::vector<TrafficVessel>& traffic;
  std::uint64_t seed = 0;  ///< of the run: for the defects that are there
  double t_s = 0;          ///< since the epoch
  /// About which bed and sea are laid: the camera's place, the same for both moments of a flow.
  Triple<double> middle_m;
  double reach_m = 0;  ///< how far the camera sees
};

/// What can be seen then: the inspected surfaces with their planted defects, the structures, the
/// bed, the other vehicles, tethers, passing vessels, running turbines and the sea, in this order.
///
/// - A structure is as its scenario has it; where an inspected surface lies on it, it is drawn 4 %
///   thinner, so that the surface is what is seen. The bed is level at the depth that the
///   environment's field says at the middle, but where an inspected bed is.
/// - Vessels are where their tracks say (passing_vessel.h). A turbine of the site of which nobody
///   inspects tower, nacelle or blades runs in the wind at its hub (turning_rotor.h), its tower on
///   what stands there; one that looks from under water does not see it.
/// - The sea is that of the run's own waves about the middle (sea_mesh.h), the bed within the same
///   reach.
[[nodiscard]] RenderScene scene_of_run(const RunMoment& moment);

}  // namespace slackwater::twin
