#pragma once
#include "fields/base/yaml_value.h"
#include "twin/mission/conduct.h"

// Only sources of this folder include this.

namespace slackwater::twin {

/// What `read_conduct` reads as the same.
[[nodiscard]] YamlValue conduct_value(const Conduct& conduct);
/// What `read_surface` reads as the same.
[[nodiscard]] YamlValue surface_value(const PlannedSurface& surface);
/// What `read_inspection` reads as the same.
[[nodiscard]] YamlValue inspection_value(const InspectionPlan& plan);
/// What `read_cleaning` reads as the same.
[[nodiscard]] YamlValue cleaning_value(const CleaningPlan& plan);
/// A NODE of read_behaviour_tree.h, all below it with it.
[[nodiscard]] YamlValue behaviour_value(const BehaviourTree& tree);

}  // namespace slackwater::twin
