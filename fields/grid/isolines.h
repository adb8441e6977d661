#pragma once
#include <array>
#include <span>
#include <vector>

namespace slackwater {

/// A line along which a quantity has one value: points (x, y). The first and the last are the same
/// where it is closed.
using Isoline = std::vector<std::array<double, 2>>;

/// The lines along which a quantity on a rectilinear grid has one value, by marching squares.
///
/// Along an edge between two nodes of values a < level <= b the line is at (level - a) / (b - a) of
/// the way: exact where the quantity is linear along edges. Within a cell it is straight. A saddle
/// is decided as the bilinear surface over the cell has it: by its value
///
///   (v00 v11 - v01 v10) / (v00 + v11 - v01 - v10)
///
/// at the saddle point. A cell with a missing corner has no line: lines end there, and none runs
/// along it. Higher values lie to the left of the way along a line. Lines are whole: one goes on
/// through all cells until it closes, or ends at the rim or at a missing value.
///
/// @param x, y    of the nodes, ascending
/// @param values  row by row, x fastest; NaN where there is none
/// Cost: each cell once; memory of the lines alone.  Thread-safe.
/// Source: Lorensen and Cline (1987) in two dimensions; Nielson and Hamann (1991) for saddles.
[[nodiscard]] std::vector<Isoline> isolines(std::span<const double> x, std::span<const double> y,
                                            std::span<const float> values, double level);

}  // namespace slackwater
