#pragma once

namespace slackwater {

/// What a standard normal stays below with probability p: Newton's method on the error function of
/// the standard library, which nears the root from one side.
/// @param p  in (0, 1)
/// @throws ContractViolation for another
[[nodiscard]] double normal_quantile(double p);

}  // namespace slackwater
