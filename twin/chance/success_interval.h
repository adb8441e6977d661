#pragma once
#include <cstddef>

namespace slackwater::twin {

/// Bounds of the probability of a success.
struct SuccessInterval {
  double low = 0;
  double high = 1;
};

/// Bounds that hold at their level however long one looks and whenever one stops: with probability
/// `level` those of all n at once contain the true p (a confidence sequence).
///
/// A bettor who spreads his stake over all p evenly has, after s successes in n,
///
///   W(p) = B(1 + s, 1 + n - s) / (p^s (1 - p)^(n - s)),
///
/// times his stake, B the beta function. If p is the true one W is a martingale, which ever reaches
/// 1/(1 - level) with probability of at most 1 - level (Ville). The bounds are where W stays below.
///
/// Wider than an interval for a fixed n, which looked at after each flight shuts the truth out far
/// more often than its level says. The intersection of those of all n so far holds too.
///
/// @param successes  of `trials`
/// @param level      in (0, 1)
/// @throws ContractViolation for more successes than trials
/// Source: Robbins (1970), Ann. Math. Statist. 41; Howard et al. (2021), Ann. Statist. 49.
[[nodiscard]] SuccessInterval success_interval(std::size_t successes, std::size_t trials,
                                               double level = 0.95);

/// The probability of one more success after so many,
///
///   (s + 1/2) / (n + 1)
///
/// Of futures it is the probability that what comes is a success too, if that is drawn as they are.
/// Their share says too much at both ends.
/// Source: Jeffreys (1946), Proc. R. Soc. A 186, 453: probabilities near 0 and 1 are likelier
/// beforehand. Most starts are done in nearly all futures, or in hardly any.
[[nodiscard]] double next_success(std::size_t successes, std::size_t trials);

}  // namespace slackwater::twin
