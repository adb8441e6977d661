#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "api/door/edr/sample/collection.h"
#include "api/issued/issued_fields.h"

// A stored product as a collection: its own values, beside the forecasts that were made from it.

namespace slackwater::api::edr {

[[nodiscard]] std::string title_of(const StoredProduct& product);
/// One sentence or two: what it is, and how its values are had.
[[nodiscard]] std::string description_of(const StoredProduct& product);
/// "the product holds 2.00 to 3.00 E, …, from … to …": what a refusal tells.
[[nodiscard]] std::string held_text(const StoredProduct& product);

/// Where the platform of what was measured stands, to some 500 m, and its name as a location.
[[nodiscard]] GeoPoint place_of(const StoredProduct& measured);
[[nodiscard]] std::string own_location(const StoredProduct& measured);

[[nodiscard]] Vertical vertical_of(const StoredProduct& product);

/// The quantities of its kind that it holds, of vectors speed and direction too, and behind them
/// `forecast_period` of what was not measured.
[[nodiscard]] std::vector<Parameter> parameters_of(const StoredProduct& product);

/// The values of `parameters_of`, those selected, from `ProductValues::value`.
[[nodiscard]] std::vector<std::vector<double>> values_of(const StoredProduct& product,
                                                         std::span<const std::size_t> selected,
                                                         std::vector<std::vector<double>> stored);

/// Whether products take a query of this name: position, radius, area, cube.
[[nodiscard]] bool is_for_products(std::string_view query) noexcept;

}  // namespace slackwater::api::edr
