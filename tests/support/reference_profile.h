#pragma once
#include <span>

#include "fields/service/snapshot.h"

namespace slackwater::tests {

/// What fields/service/field.h must answer at a column, written anew in double precision and
/// without any table: linear in time and depth; above the top level the top value holds, below the
/// deepest wet level down to the bed the deepest value holds. `depths_m` and `out` have the same
/// length.
void reference_profile(const Snapshot& snapshot, std::size_t column, UtcTime time,
                       std::span<const double> depths_m, std::span<CurrentSample> out,
                       std::size_t member = 0) noexcept;

}  // namespace slackwater::tests
