#pragma once
#include <cstddef>

namespace slackwater::twin {

/// Of how many members a plan has to hold for it to hold in the truth with a probability of at
/// least p,
///
///   k = ceil(p (n + 1)),
///
/// of n members. Each member i, and the truth, has a most demanding plan D_i that it can bear; the
/// plan chosen is the most demanding that k of the members bear, their k-th largest D. If truth and
/// members are drawn alike the truth is as likely at any rank among all n + 1, so that it bears
/// that plan too with a probability of at least k/(n + 1), however the D are spread and although
/// the very same members chose the plan. (Where a less demanding plan is always easier to bear; a
/// share of p of the members alone would give less than p.)
///
/// @param members  n
/// @param share    p, in (0, 1)
/// @return k; more than n where so few members cannot show it: p = 0.9 takes at least 9
/// Source: Wilks (1941), Ann. Math. Statist. 12, 91; Vovk, Gammerman and Shafer (2005), ch. 2.
[[nodiscard]] std::size_t rank_needed(std::size_t members, double share);
/// The least n with which p can be shown. @param share  p, in (0, 1)
[[nodiscard]] std::size_t members_needed(double share);

}  // namespace slackwater::twin
