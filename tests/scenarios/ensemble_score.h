#pragma once
#include <cstddef>
#include <span>

namespace slackwater::calibration {

/// How the members of an ensemble of n were drawn, which says what n -> infinity would score. The
/// sum over pairs of members that measures an ensemble's own spread runs over
enum class Drawn {
  as_they_are,        ///< all n^2: the members are all that there is, a step function
  independently,      ///< n (n - 1): no member beside itself ("fair", Ferro 2014)
  in_opposite_pairs,  ///< n (n - 2): nor beside its opposite; 0 and 1, 2 and 3, ... are pairs
};

/// The value below which a share of the distribution lies that n equally likely members stand for:
/// linear between members x_1 <= ... <= x_n with P(x_i) = i/(n + 1), held beyond the outermost.
///
/// It is the rule under which a truth that is one more draw lies below the quantile as often as the
/// quantile says, whatever the law of the draws (Hyndman & Fan 1996, American Statistician 50, 361,
/// rule 6). A centre with opposite pairs about it may count as a member: P(|y| < |d|_i) = i/(m + 1)
/// of m pairs is the same rule.
///
/// @param ascending    at least one
/// @param probability  in (0, 1)
[[nodiscard]] double ensemble_quantile(std::span<const double> ascending, double probability);

/// The probability of a value below y by the same rule; beyond the outermost member, where nothing
/// is known but that it is the outermost of n + 1, the middle of what is left: 0.5/(n + 1).
/// @param ascending  at least one
[[nodiscard]] double probability_below(std::span<const double> ascending, double y);

/// Continuous ranked probability score of members, in their unit:
///
///   CRPS = mean |x_i - y| - (1/2) mean |x_i - x_j|
///
/// The second mean over the pairs that `Drawn` names, for which the expectation is the score of the
/// law behind the draws; `as_they_are` exceeds it by mean |x - x'|/2n. Fair scores of single cases
/// may be negative.
///
/// @param ascending  none of them opposite pairs any more: give those to the energy score, which in
///                   one dimension is this
/// Sources: Gneiting & Raftery (2007), J. Amer. Statist. Assoc. 102, 359, eq. 21; Ferro (2014),
/// Quart. J. Roy. Meteor. Soc. 140, 1917. Cost: n.
[[nodiscard]] double ensemble_crps(std::span<const double> ascending, double y,
                                   Drawn drawn = Drawn::independently);

/// The score of a path (times, levels, components in any order) against its truth:
///
///   ES = mean |x_i - y| - (1/2) mean |x_i - x_j|,   |.| Euclidean over the dimensions
///
/// proper, blind to little but dependence, and dull in it: see the variogram score. In one
/// dimension the CRPS.
///
/// @param members  n x dimensions, a member's values together; @param y  dimensions, at least one
/// Source: Gneiting & Raftery (2007), eq. 22. Cost: n^2 dimensions.
[[nodiscard]] double energy_score(std::span<const double> members, std::span<const double> y,
                                  Drawn drawn = Drawn::independently);

/// Two dimensions that are held against each other.
struct VariogramPair {
  std::size_t from = 0;
  std::size_t to = 0;
  double weight = 1;
};

/// Whether members vary from time to time and level to level as the truth does:
///
///   VS = sum over pairs w (|y_a - y_b|^p - mean_i |x_ia - x_ib|^p)^2,   p = 1/2
///
/// proper; sees a dependence that is too strong or too weak, does not see a bias common to all.
/// Source: Scheuerer & Hamill (2015), Mon. Wea. Rev. 143, 1321, eq. 6. Cost: n x pairs.
[[nodiscard]] double variogram_score(std::span<const double> members, std::span<const double> y,
                                     std::span<const VariogramPair> pairs, double power = 0.5);

}  // namespace slackwater::calibration
