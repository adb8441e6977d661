#pragma once
#include <cstddef>

#include "api/door/edr/sample/selection.h"

// How much a query asks for: too much is refused, much is left to the threads for long work.

namespace slackwater::api::edr {

/// What an answer costs before it is written.
struct Work {
  std::size_t values = 0;
  std::size_t comparisons = 0;  ///< cells times vertices of a polygon, held against each other
};

inline constexpr std::size_t most_values = 2'000'000;
/// A domain costs some 500 bytes of answer before it holds a number.
inline constexpr std::size_t most_domains = 50'000;
/// Two seconds.
inline constexpr std::size_t most_comparisons = 100'000'000;

/// The work of a query for so many places and times.
/// @throws Error(usage) where it is more numbers, or more domains, than an answer may hold: says
/// how many were asked and how many are allowed
[[nodiscard]] Work moderate_work(const Selection& selection, std::size_t places,
                                 std::size_t domains = 1);
/// The same of so many parameters.
[[nodiscard]] Work moderate_work(std::size_t parameters, std::size_t places, std::size_t domains);
/// Cells times vertices. @throws Error(usage) where they are more than `most_comparisons`
[[nodiscard]] std::size_t moderate_comparisons(std::size_t cells, std::size_t vertices);

/// What does not take long is answered within 50 ms.
[[nodiscard]] bool takes_long(const Work& work) noexcept;
inline constexpr std::size_t most_short_values = 50'000;
inline constexpr std::size_t most_short_comparisons = 2'000'000;

}  // namespace slackwater::api::edr
