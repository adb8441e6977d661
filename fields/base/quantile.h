#pragma once
#include <optional>
#include <vector>

namespace slackwater {

/// By linear interpolation between the values in order; what is not finite does not count. Nothing
/// of none. @param share  0: the least, 1: the largest
[[nodiscard]] std::optional<double> quantile_of(std::vector<double> values, double share);

}  // namespace slackwater
