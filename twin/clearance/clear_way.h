#pragma once
#include <array>
#include <optional>

#include "twin/clearance/hazards.h"

namespace slackwater::twin {

/// The motion that is wanted, over ground.
struct Wish {
  Planar velocity_m_s;
  double down_m_s = 0;
  /// The place that is gone for, or the one on a way beside the vehicle, and how that moves on;
  /// nowhere: the velocity is all that is wanted.
  std::optional<Planar> place_m{};
  Planar place_m_s{};
};

/// What an alarm began with.
enum class AlarmCause : std::uint8_t {
  vehicle,     ///< its claim is not in its cell: for another vehicle
  structure,   ///< the same for what stands there
  line,        ///< or for a tether
  vessel,      ///< or for the hull of one of the traffic
  no_warning,  ///< in the way of a vessel, with less time left than it takes to leave it
  crowded,     ///< more hazards than planes
};
inline constexpr std::size_t alarm_causes = 6;
[[nodiscard]] const char* name_of(AlarmCause cause) noexcept;

/// What a vehicle remembers of keeping clear. Numbers only, stored and compared as a block of them.
struct ClearanceState {
  Planar wish_m;            ///< where it would go within its stopping way
  double hindered_by = -1;  ///< the vehicle that keeps it from there, or nobody
  double is_leaving = 0;    ///< the way of a vessel
  double side = 0;        ///< of what it goes round: 1 leaves it to port, -1 to starboard; 0: none
  double side_s = 0;      ///< for how long
  double slack_m = 0;     ///< of its claim at the last look; negative: nearer than promised
  double is_alarmed = 0;  ///< the bound is not promised now
  double alarms = 0;      ///< how often that began
  std::array<double, alarm_causes> alarms_from{};  ///< the same by `AlarmCause`
  double changed_s = 0;  ///< for how long in all it was made to do otherwise
};

/// What a vehicle may do.
struct ClearWay {
  bool is_as_wished_aside = true;
  bool is_as_wished_in_depth = true;
  /// Otherwise: at this velocity over ground. `turns`: with no way on, its bow that way, where
  /// `only_turns`. `circles`: its bow that way, at the speed it has; nowhere: a circle to
  /// starboard.
  Planar velocity_m_s;
  bool only_turns = false;
  double least_depth_m = 0;  ///< z of its origin
  double most_depth_m = 0;
};

/// Keeps a vehicle clear of everything around it: as wished where that keeps clear, else slower,
/// not at all, round it, or out of its way.
///
/// **The rule.** Each vehicle i has a claim C_i, a convex set that it need not leave: the way in
/// which it stops, v (t_r + v/(2 a)) ahead, or the circle in which an AUV stays. A vehicle goes on
/// only to motions whose claim lies in its cell: on its own side of every plane between it and a
/// hazard. Otherwise it stops, or circles. Let R be the stand-off and |A - B| the distance of two
/// sets, hulls included.
///
/// **Two vehicles that obey never come nearer than R.** Say |C_A - C_B| >= R at a barrier. Both
/// have seen the same two claims, and lay the same two planes square to the shortest way between
/// them, each (|C_A - C_B| - R)/2 beyond its own claim, so that R lies between the planes. A convex
/// set lies on one side of the plane through its nearest place, so that each old claim is in its
/// cell: to stop (to circle) is always allowed, and the claim of one that stops shrinks within
/// itself. Whatever each claims until the next barrier is in its cell, thus |C_A - C_B| >= R at the
/// next barrier too; each is in its claim, thus |A - B| >= R. Nobody needs to know what the other
/// wishes, and the order in which they act does not matter.
///
/// **What stands still** (structures, lines, vessels at anchor): the same with all of the room on
/// one side. The distance d(s) to a convex set is convex along the way in which a vehicle stops, so
/// that it stays beyond R once its claim is.
///
/// **Depth.** Hulls are upright cylinders, from their tops to their keels. Two keep clear aside, or
/// in depth by `vertical_m`; which, is decided at each barrier by what they have (`Slack`), so that
/// max(aside, in depth) >= 0 is what is kept: an ROV at 20 m is clear of a vessel of 2 m draught.
///
/// **Traffic** that keeps course and speed: a vessel's way is not entered from aside within T =
/// `leaving_time_s` before it, and who is in it then leaves it across. That takes no longer than T:
/// to react and stop from the largest speed, twice, to come about, and the breadth of the way at
/// `sure_speed_m_s`. Holds if the vessel was known T before it came, keeps its course for as long,
/// and nothing else bars the way out.
///
/// **Without the preconditions there is an alarm and no promise**: a claim that is not in its cell
/// (placed too near, pushed there by gusts, a line that comes nearer, a vessel that turned), more
/// hazards than planes, less time than T. What can be done is done all the same: out of the
/// stand-off the shortest way.
///
/// **Deadlock.** One that cannot go on goes round to starboard, along the plane that stops it, for
/// a place beyond that plane which is not itself too near to a structure. Two that meet leave each
/// other to port. Right of way is the order of the run, but for one that
/// leaves a vessel's way: whoever bars the way of one that has it moves out of it, square to it.
///
/// No allocation, no exception. @param dt_s  of a step of this vehicle
[[nodiscard]] ClearWay clear_way(const Handling& handling, const StandOff& stand_off,
                                 const Lookout& lookout, const OwnMotion& own, const Wish& wish,
                                 double dt_s, ClearanceState& state) noexcept;

/// What the others are told of a vehicle, at a barrier.
[[nodiscard]] Craft craft_of(const Handling& handling, const OwnMotion& own,
                             const ClearanceState& state) noexcept;

}  // namespace slackwater::twin
