#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "twin/inspection/inspection.h"
#include "twin/scene/structure.h"

namespace slackwater::twin {

/// The nearest place that somebody would turn a camera to: of the surfaces that are inspected the
/// middle of a patch, else of the structures the nearest of all their places. Nothing where none is
/// within reach.
/// @param from_m  NED of the run, outside of the structures
[[nodiscard]] std::optional<Triple<double>> place_to_look_at(
    std::span<const std::shared_ptr<const Inspection>> inspections,
    const std::vector<Structure>& structures, const Triple<double>& from_m, double most_range_m);

}  // namespace slackwater::twin
