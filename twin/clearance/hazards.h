#pragma once
#include "twin/clearance/cell.h"
#include "twin/clearance/lookout.h"

namespace slackwater::twin {

/// How far away a hazard is: between hulls, less the stand-off, of the claims. Enough of either is
/// enough.
struct Slack {
  double aside_m = 0;
  double in_depth_m = 0;
  /// Whether two keep clear by their depths. Depth is kept where it is enough and a tenth of what
  /// there is aside: vehicles go some ten times faster ahead than up and down.
  [[nodiscard]] bool is_by_depth() const noexcept {
    return in_depth_m >= 0 && 10 * in_depth_m >= aside_m;
  }
};

/// What a vehicle has its room from.
struct Outlook {
  const Handling* handling = nullptr;
  StandOff stand_off;
  Claim claim;         ///< of its motion now
  Planar position_m;   ///< now
  double reach_m = 0;  ///< what is farther than this off its claim is left out
};

void keep_clear_of(const Structure& structure, const Outlook& own, Cell& cell) noexcept;
/// Each piece of the line is a wall in its own depths. Of a vehicle's own line the last
/// `attached_m` and twice its stand-off are left out; one that swims or flies drags the rest behind
/// it as it likes.
void keep_clear_of(const Line& line, bool is_own, const Outlook& own, Cell& cell) noexcept;
/// Half of the room between two claims is each one's; all of it, of one that has halted, and in
/// depth of one that floats.
void keep_clear_of(const Craft& other, std::ptrdiff_t whose, const Craft& self, const Outlook& own,
                   Cell& cell) noexcept;

/// Time that a vehicle needs to leave the way of a passer: to come about, to gain speed and to
/// cross its whole breadth.
[[nodiscard]] double leaving_time_s(const Handling& handling, double half_breadth_m) noexcept;

/// A vehicle before a passer: `is_ahead` within the time to leave its way.
struct Encounter {
  bool is_ahead = false;
  bool is_in_the_way = false;
  bool is_too_late = false;  ///< there is not the time left to leave it
  Planar off_course;         ///< the direction away from its course, of length one
};
/// Its way is as broad as its beam and the stand-off, and as long as it sails in the time to leave
/// it; it is not entered from aside. Who is in it as its end comes by is to leave it: no plane
/// keeps that one from the way out.
[[nodiscard]] Encounter keep_clear_of(const Passer& passer, const Outlook& own,
                                      Cell& cell) noexcept;

}  // namespace slackwater::twin
