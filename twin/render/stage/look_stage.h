#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fields/base/config.h"
#include "twin/inspection/defect/defect_kind.h"
#include "twin/inspection/surface/planned_surface.h"
#include "twin/render/light/water_type.h"
#include "twin/render/sheet/render_sensor.h"

namespace slackwater::twin {

/// A kind of defect that a stage plants, and how large.
struct StagedKind {
  DefectKind kind{};
  Range size_m;  ///< longest side, even over the logarithm
};

/// From what single looks are drawn, as data/stages has it: surfaces that stand together, and how
/// a camera comes to look at them. No run is flown.
struct LookStage {
  std::string name;
  std::string source;
  RenderSensor sensor;  ///< a camera
  std::vector<PlannedSurface> surfaces;
  std::vector<StagedKind> defects;
  int most_defects = 0;      ///< in a look that has some: 1 to so many, each as likely
  double share_without = 0;  ///< of the looks: nothing is planted
  Range range_m;             ///< from the lens to the place looked at, even over the logarithm
  Range off_square_rad;      ///< from the surface's normal, even
  double most_roll_rad = 0;  ///< about the axis, even to both sides
  Range visibility_m;        ///< black disc in water, optical range in air; even over the logarithm
  Range daylight;            ///< at the surface, of what is needed; even over the logarithm
  Range lamps;               ///< their range, of the sheet's: even
  Range growth;              ///< 0 none, 1 all over; even
  std::vector<WaterType> waters;  ///< each as likely
};

/// One file of data/stages:
///
///     name: Close looks at a pile by a small ROV
///     source: estimate
///     sensor: rov_camera               # a camera of data/sensors
///     range_m: [0.5, 3]
///     off_square_deg: [0, 50]
///     roll_deg: 15
///     visibility_m: [2, 15]
///     daylight: [0.02, 1]
///     lamps: [0.6, 1]
///     growth: [0.3, 0.7]
///     waters: [coastal_1, coastal_3]   # of data/waters
///     share_without: 0.3
///     most_defects: 3
///     defects: [{kind: corrosion, size_m: [0.03, 0.5]}, ...]
///     surfaces: [{kind: monopile, ...}, ...]     # as an inspection has them (planned_surface.h)
///
/// @throws Error(invalid_input) for a sensor that is no camera, a range beyond the sensor's, a kind
///         that sits on none of the surfaces, ranges the wrong way round
[[nodiscard]] LookStage read_look_stage(const Config& config,
                                        const std::filesystem::path& data_folder);

}  // namespace slackwater::twin
