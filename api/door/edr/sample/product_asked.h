#pragma once
#include <optional>
#include <string>
#include <vector>

#include "api/door/edr/read/query_string.h"
#include "api/door/edr/read/wkt.h"
#include "api/door/edr/sample/asked_area.h"
#include "api/door/edr/sample/product_collection.h"
#include "api/issued/product_values.h"
#include "fields/base/error.h"

// Only sources of this folder include this.

namespace slackwater::api::edr {

/// What of a product a query asks for, whatever the places.
struct Asked {
  const StoredProduct* product = nullptr;
  std::vector<Parameter> all;
  std::vector<std::size_t> parameters;
  std::optional<UtcTime> instant;
  UtcTime from{};
  UtcTime to{};
  std::optional<std::string> z;
};

[[nodiscard]] Asked asked_of(const StoredProduct& product, const QueryString& query);

/// What was asked is not held: what was found, and what the product holds.
[[nodiscard]] Error outside(const StoredProduct& product, const std::string& found);

/// Of an instant the mean that holds it, of two that meet there the later; else, where the times
/// around it hang together, the nearest. Of a stretch all its times.
/// @throws Error(not_found) where there is none
[[nodiscard]] std::vector<UtcTime> times_of(const Asked& asked, const ProductView& view,
                                            std::vector<std::string>& notes);

/// Levels this near are one.
inline constexpr double same_level_m = 1e-3;

/// "depth 0 to 30 m", "height 10 m alone".
[[nodiscard]] std::string levels_text(const StoredProduct& product,
                                      const std::vector<double>& levels_m);
/// Whether a level lies between the first and the last of a product.
[[nodiscard]] bool is_held(double level_m, const std::vector<double>& levels_m);
/// Empty without a vertical.
/// @param own  points that have their levels themselves
[[nodiscard]] std::vector<double> levels_of(const Asked& asked, const ProductView& view,
                                            const Path& own = {});

[[nodiscard]] GeoPoint point_of(double longitude_deg, double latitude_deg);
/// So much of the product as lies in a box, in the time that is asked for.
[[nodiscard]] ProductWindow window_of(const Asked& asked, const Box& box);
/// Where it lies, unrolled eastward over the antimeridian.
[[nodiscard]] Box box_of(const StoredProduct& product);

}  // namespace slackwater::api::edr
