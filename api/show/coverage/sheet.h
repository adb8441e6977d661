#pragma once
#include <optional>
#include <string>
#include <vector>

#include "api/show/coverage/marks.h"
#include "api/show/coverage/view.h"

namespace slackwater::api {

/// The surface unrolled, as an SVG element: what was covered, seen and not seen, with depths or
/// metres at its side, a scale, the compass above (a sheet that goes all round) or north (a flat
/// one), the level of the sea and the marks. At most `sheet_cells` cells, however many patches.
[[nodiscard]] std::string sheet_svg(const InspectionCoverage& coverage,
                                    const std::vector<CoverageMark>& marks);

inline constexpr std::size_t sheet_columns = 240;
inline constexpr std::size_t sheet_rows = 170;

/// How many times longer a metre down is drawn than a metre along: 1 but for very long or narrow
/// surfaces.
[[nodiscard]] double sheet_stretch(const CoverageSheet& sheet) noexcept;

/// The way to north on a sheet that lies flat, clockwise from the page's up, degrees; nothing for
/// others.
[[nodiscard]] std::optional<double> north_on_sheet_deg(const InspectionCoverage& coverage);

/// 1, 2 or 5 times a power of ten, at most `length`.
[[nodiscard]] double round_length(double length) noexcept;

}  // namespace slackwater::api
