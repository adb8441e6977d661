#pragma once
#include "api/door/edr/sample/answer.h"
#include "api/door/edr/sample/product_asked.h"

// Only sources of this folder include this.

namespace slackwater::api::edr {

/// Places of the answer, and how they become coverages.
struct Places {
  std::vector<GeoPoint> point;
  std::vector<double> longitude_deg;  ///< axes of a grid; of points one each
  std::vector<double> latitude_deg;
  std::vector<std::size_t> cell;  ///< of a grid: which cell each point is
  bool is_grid = false;
  bool has_own_levels = false;  ///< as many levels as points, one each
};

/// The answer: values, why some are absent, and where they come from.
/// @throws Error(not_found) where all points are on land
[[nodiscard]] Answer filled(const Asked& asked, const ProductView& view, const Places& places,
                            std::vector<UtcTime> times, std::vector<double> levels,
                            std::vector<std::string> notes);

}  // namespace slackwater::api::edr
