#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "twin/control/route.h"
#include "twin/inspection/cast/ray_caster.h"
#include "twin/inspection/defect/detection_method.h"
#include "twin/inspection/inspection_plan.h"
#include "twin/inspection/inspection_state.h"
#include "twin/inspection/instrument/pose.h"
#include "twin/inspection/instrument/view.h"
#include "twin/sensor/camera_pointing.h"

namespace slackwater::twin {

/// Which surface a line of the plan inspects.
struct InspectedPair {
  std::size_t line = 0;
  std::size_t surface = 0;
  double range_m = 0;  ///< from which the work passes it by: the median
};

/// A plan with all that is worked out once: it does not change, and the flights of a rehearsal
/// share it.
struct Inspection {
  std::string inspector;  ///< the vehicle: what it draws, no other does
  InspectionPlan plan;
  std::vector<Instrument> instruments;  ///< of each line
  std::vector<Surface> surfaces;
  std::vector<ViewIndex> indices;  ///< of each surface
  std::vector<InspectedPair> pairs;
  DefectFacts facts;
  std::vector<DetectionMethod> methods;
  std::size_t rays_per_look = 0;
  std::unique_ptr<const RayCaster> caster;  ///< of the surfaces' meshes
};

/// @param inspector      name of the vehicle
/// @param way            all waypoints of the vehicle's work
/// @param data_folder    instruments/, detection/
/// @param rays_per_look  where the plan does not say
/// @throws Error(invalid_input) where the work does not come within an instrument's reach of what
///         it is to inspect
[[nodiscard]] std::shared_ptr<const Inspection> ready_inspection(
    const std::string& inspector, const InspectionPlan& plan, std::span<const Waypoint> way,
    const std::filesystem::path& data_folder, std::size_t rays_per_look);

[[nodiscard]] InspectionState begin_inspection(const Inspection& inspection, std::uint64_t seed);

/// How far one sees, and where cameras look.
struct Sight {
  std::optional<double> water_visibility_m;  ///< of a black disc; absent: as the plan has it
  std::optional<double> air_visibility_m;    ///< optical range; absent: as the plan has it
  CameraPointing camera;
};

/// One look of each instrument that has moved far enough since its last. No allocation but for the
/// scratch of a thread's first looks.
/// @param is_at_work  the vehicle does its work and has power
/// @param known_m     where it takes itself to be, NED
/// @param dt_s        since the call before
/// @param sight       what somebody makes of what there is to see
void inspect(const Inspection& inspection, bool is_at_work, const Carriage& carriage,
             const Triple<double>& known_m, double t_s, double dt_s, InspectionState& state,
             const Sight& sight = {});

}  // namespace slackwater::twin
