#pragma once
#include <cstddef>
#include <string_view>
#include <vector>

#include "api/door/edr/sample/answer.h"

namespace slackwater::api::edr {

/// Lengths of the axes of a coverage; 1 where the axis is empty. On a trajectory x is the number of
/// its vertices and the others are 1.
struct AxisLengths {
  std::size_t t = 1;
  std::size_t z = 1;
  std::size_t y = 1;
  std::size_t x = 1;

  [[nodiscard]] std::size_t size() const noexcept { return t * z * y * x; }
  [[nodiscard]] std::size_t index(std::size_t it, std::size_t iz, std::size_t iy,
                                  std::size_t ix) const noexcept {
    return ((it * z + iz) * y + iy) * x + ix;
  }
};

[[nodiscard]] AxisLengths shape_of(const Coverage& coverage) noexcept;

/// A broken promise of `Answer` is a bug of the query that filled it: ContractViolation where
/// coverages have no place, differ in domain type, have axes that their domain type does not allow
/// (two times in a profile), or values that are not one per parameter and point.
void expect_whole(const Answer& answer);

/// The axes where some coverage has them.
[[nodiscard]] bool has_time(const Answer& answer) noexcept;
[[nodiscard]] bool has_vertical(const Answer& answer) noexcept;

/// "depth_m" or "height_m".
[[nodiscard]] std::string_view vertical_name(const Answer& answer) noexcept;

/// Vertex `i` of a trajectory, whose axis may have one entry for all; the axis is not empty.
template <typename Value>
[[nodiscard]] const Value& at_vertex(const std::vector<Value>& axis, std::size_t i) noexcept {
  return axis.size() == 1 ? axis.front() : axis[i];
}

}  // namespace slackwater::api::edr
