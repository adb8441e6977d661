#pragma once
#include <filesystem>

#include "api/door/edr/sample/answer.h"
#include "api/door/edr/sample/product_asked.h"

// Only sources of this folder include this.

namespace slackwater::api::edr {

/// What an instrument measured, at its own place, times and levels: nothing is interpolated.
/// @throws Error(not_found) for points too far from it
[[nodiscard]] Answer measured_near(const std::filesystem::path& store, const Asked& asked,
                                   const Path& points);
/// The same. @throws Error(not_found) for an area without it
[[nodiscard]] Answer measured_in(const std::filesystem::path& store, const Asked& asked,
                                 const AskedArea& shape);

}  // namespace slackwater::api::edr
