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

/// What was held likely before the first trial, as so many successes and as many failures.
struct Beforehand {
  double trials_each = 1;
};
/// All p alike (Laplace). For members whose limits hold or not: their chances, of several variables
/// over hours, are spread over all of it (tests/twin/risk/window_probabilities_test.cc).
inline constexpr Beforehand any_chance{1};
/// Those near 0 and 1 likelier (Jeffreys). For flights: most starts are done in nearly all futures,
/// or in hardly any (tests/twin/rehearse/twin_probabilities_test.cc).
inline constexpr Beforehand mostly_sure{0.5};

/// The probability of one more success after so many,
///
///   (s + a) / (n + 2 a),   a = `trials_each`
///
/// Of a forecast's members it is the probability that what comes is a success too, if that is drawn
/// as they are. Their share says too much at both ends: where it is 0.96 in 25 members, 0.93 come
/// true. What was held likely beforehand matters as much there: of limits `mostly_sure` says 0.952
/// where 0.934 come true, of flights `any_chance` 0.937 where 0.979 do.
/// Source: rules of succession, Laplace (1814) and Jeffreys (1946), Proc. R. Soc. A 186, 453.
[[nodiscard]] double next_success(std::size_t successes, std::size_t trials, Beforehand held);

}  // namespace slackwater::twin
