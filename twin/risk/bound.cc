#include "twin/risk/bound.h"

#include <cmath>

#include "fields/base/check.h"

namespace slackwater::twin {
namespace {

/// A loop without branches, so that the compiler takes several values at once.
template <typename Holds>
void keep(std::span<const double> values, std::span<std::uint8_t> marks, Holds holds) {
  expects(values.size() == marks.size(), "a value and a mark for each step");
  const double* const value = values.data();
  std::uint8_t* const mark = marks.data();
  for (std::size_t i = 0; i < values.size(); ++i)
    mark[i] = static_cast<std::uint8_t>(mark[i] & static_cast<std::uint8_t>(holds(value[i])));
}

}  // namespace

std::string_view sign_of(BoundSide side) noexcept {
  switch (side) {
    case BoundSide::at_most:
      return "<=";
    case BoundSide::below:
      return "<";
    case BoundSide::at_least:
      return ">=";
    case BoundSide::above:
      return ">";
  }
  return "";
}

void keep_within(const Bound& bound, std::span<const double> values,
                 std::span<std::uint8_t> marks) {
  const double limit = bound.value;
  switch (bound.side) {
    case BoundSide::at_most:
      return keep(values, marks, [limit](double v) { return v <= limit; });
    case BoundSide::below:
      return keep(values, marks, [limit](double v) { return v < limit; });
    case BoundSide::at_least:
      return keep(values, marks, [limit](double v) { return v >= limit; });
    case BoundSide::above:
      return keep(values, marks, [limit](double v) { return v > limit; });
  }
}

void keep_known(std::span<const double> values, std::span<std::uint8_t> marks) {
  keep(values, marks, [](double v) { return !std::isnan(v); });
}

}  // namespace slackwater::twin
