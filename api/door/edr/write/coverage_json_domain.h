#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "api/door/edr/sample/answer.h"

// The domain of a CoverageJSON coverage: where its values stand, and in which reference systems.

namespace slackwater::api::edr {

/// "Point", "PointSeries", "VerticalProfile", "Grid", "Trajectory".
[[nodiscard]] std::string_view name_of(DomainType type) noexcept;

/// Appends `"axes":{...}`.
/// @return of a trajectory the vertices that its composite axis holds (a tuple
/// stands once); else nothing
std::vector<std::size_t> append_axes(std::string& out, const Coverage& coverage);

/// Appends `"referencing":[...]` with the systems of the axes that the answer has.
void append_referencing(std::string& out, const Answer& answer);

}  // namespace slackwater::api::edr
