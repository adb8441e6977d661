#pragma once
#include <cstddef>
#include <string_view>
#include <variant>
#include <vector>

namespace slackwater::api::edr {

constexpr std::size_t max_levels = 1'000;

/// All levels between and including two.
struct LevelRange {
  double low = 0;
  double high = 0;
  bool operator==(const LevelRange&) const = default;
};
/// Levels by name, ascending, none twice.
using Levels = std::vector<double>;
using VerticalQuery = std::variant<Levels, LevelRange>;

/// Reads `z` of OGC API-EDR 1.1 (/req/edr/z-response), in metres of the collection's vertical
/// reference (depth down or height up):
///
///   10   0,5,10   0/50 (a range)   R20/100/50 (20 levels from 100, 50 apart)
///
/// Levels may be negative and come in any order; a sequence may step downwards. Throws Error(usage)
/// for anything else, a range whose first level is above its second, a step of 0, levels beyond
/// max_vertical_m (wkt.h) and more than max_levels of them.
[[nodiscard]] VerticalQuery parse_vertical(std::string_view text);

}  // namespace slackwater::api::edr
