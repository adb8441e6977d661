#pragma once
#include <functional>
#include <span>
#include <vector>

#include "api/door/edr/read/geometry.h"
#include "api/door/edr/sample/selection.h"

// Domains filled with samples: what the queries are made of.

namespace slackwater::api::edr {

/// What a place with so many times and levels is.
[[nodiscard]] DomainType domain_at_point(std::size_t times, std::size_t verticals);

/// Series and profiles at one place: Point, PointSeries, VerticalProfile, or a Grid of one cell
/// where both times and levels are many.
[[nodiscard]] Coverage at_point(const Selection& selection, double longitude_deg,
                                double latitude_deg, const std::vector<UtcTime>& times,
                                const std::vector<double>& verticals, Absences& absences);

/// A grid; places for which `is_wanted` is false have no value and count for nothing.
[[nodiscard]] Coverage on_grid(const Selection& selection, std::vector<double> longitude_deg,
                               std::vector<double> latitude_deg, const std::vector<UtcTime>& times,
                               const std::vector<double>& verticals,
                               const std::function<bool(double, double)>& is_wanted,
                               Absences& absences);

/// One value a vertex, at the vertex's own time and vertical. @param id  of the coverage
[[nodiscard]] Coverage along(const Selection& selection, std::span<const Vertex> vertices,
                             const std::string& id, Absences& absences);

/// The selection's answer with these coverages, notes and all.
[[nodiscard]] Answer answer_of(Selection selection, std::vector<Coverage> coverages,
                               const Absences& absences);

}  // namespace slackwater::api::edr
