#pragma once
#include <chrono>
#include <span>
#include <string>

#include "fields/base/time.h"

namespace slackwater {

/// Means over this and longer are not the current of any hour: they pass two thirds of the
/// semidiurnal tide at most (a day's mean 3 %) and nothing of what is faster.
inline constexpr Duration shortest_tideless_mean = std::chrono::hours(6);

/// How long the values of a series were averaged: the usual width of its cells, 0 for instants and
/// for no cells.
[[nodiscard]] Duration averaging_of(std::span<const TimeCell> cells);

/// Whether means over this must not pass as instants. Bounds written to the last second count as
/// what they stand for.
[[nodiscard]] bool hides_the_tide(Duration averaging) noexcept;

/// "daily means", "means over 6 h", "instants".
[[nodiscard]] std::string averaging_text(Duration averaging);

}  // namespace slackwater
