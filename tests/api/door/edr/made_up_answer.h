#pragma once
#include <cstddef>

#include "api/door/edr/sample/answer.h"

namespace slackwater::tests {

/// An answer of one domain type as a query might give it: three parameters (the last with a
/// method), values that tell where they stand (see `made_up_value`), the first value of the second
/// parameter missing, texts with quotes and letters beyond ASCII.
/// @param coverages  how many domains, each a degree east of the one before
/// @param levels     of profiles and grids
[[nodiscard]] api::edr::Answer made_up_answer(api::edr::DomainType type, std::size_t coverages = 1,
                                              std::size_t levels = 4);

/// The value of a parameter at the i-th point of a domain.
[[nodiscard]] constexpr double made_up_value(std::size_t coverage, std::size_t parameter,
                                             std::size_t i) {
  return static_cast<double>(coverage) + 0.125 * static_cast<double>(parameter) -
         0.001 * static_cast<double>(i);
}

}  // namespace slackwater::tests
