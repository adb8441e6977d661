#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "data/store/rows.h"

namespace slackwater::api {

/// What of a product is served by itself.
enum class ProductKind { currents, wind, waves };
/// "currents", "wind", "waves".
[[nodiscard]] std::string_view name_of(ProductKind kind) noexcept;
/// CF standard names. Of currents and wind the two components come first, east before north; of
/// waves height, period and direction, then those of wind sea and swells apart.
[[nodiscard]] const std::vector<std::string>& quantities_of(ProductKind kind);

/// Of currents and wind.
inline constexpr std::size_t vector_components = 2;

/// One dataset that product files on the same levels were ingested of, as far as it is about one
/// kind: a gridded product, or what the instruments of one platform measured where they stand.
struct StoredProduct {
  /// "product-currents-cmems_mod_glo_phy-cur_anfc_0.083deg_PT6H-i": by its dataset, else its
  /// product; fit for a path. Where that names several (cuts at other depths), and always of files
  /// that name neither, it has "-3fa29c" behind it, by what tells it from others: no name passes
  /// from one sea to another. Of what was measured "instrument-currents-FINO1", by the platform.
  std::string id;
  std::string station;  ///< the platform that measured it; empty: a gridded product
  ProductKind kind = ProductKind::currents;
  std::string product_id;
  std::string dataset_id;  ///< empty: its files do not say
  std::vector<std::string> attributions;
  /// Those of `quantities_of` that it holds, in their order; of a vector both components.
  std::vector<std::string> standard_names;
  UtcTime from{};      ///< start of the first cell
  UtcTime to{};        ///< end of the last
  BoundingBox bounds;  ///< of all its files; west > east across the antimeridian
  VerticalKind vertical = VerticalKind::none;
  std::optional<double> lowest_level_m;
  std::optional<double> highest_level_m;
  bool has_analysis = false;
  std::vector<UtcTime> runs;  ///< reference times of the provider's forecasts, ascending
  std::vector<store::GranuleRow> granules;  ///< in catalogue order
  [[nodiscard]] bool is_measured() const noexcept { return !station.empty(); }
  bool operator==(const StoredProduct&) const = default;
};

/// The products among a store's granules, by id.
[[nodiscard]] std::vector<StoredProduct> stored_products(
    const std::vector<store::GranuleRow>& granules);

/// What instruments measured, by id. One platform is one: files of one dataset, of one platform's
/// name, at most 500 m apart (a mooring is laid anew near its place). Where the name is taken, of
/// two the first ingested keeps it, and the other has six letters more, by its dataset and place.
[[nodiscard]] std::vector<StoredProduct> stored_instruments(
    const std::vector<store::GranuleRow>& granules);

}  // namespace slackwater::api
