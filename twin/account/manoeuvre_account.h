#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "twin/account/manoeuvre_figures.h"
#include "twin/state/manoeuvre_plan.h"

namespace slackwater::twin {

/// What a manoeuvre began with, over the last fifth of its approach.
struct ApproachAccount {
  double speed_m_s = 0;     ///< ahead, mean; through the water where the log has that
  double most_off_m_s = 0;  ///< of it, from that
  double turned_rad = 0;    ///< from the least to the greatest heading
  /// Its speed within 2 % of the mean, from its least to its greatest heading 2 degrees at most.
  [[nodiscard]] bool is_steady() const noexcept;
  bool operator==(const ApproachAccount&) const = default;
};

/// What a pull-out leaves.
struct PullOut {
  double turn_rad_s = 0;      ///< of the turn before, mean of its last fifth
  double residual_rad_s = 0;  ///< with the helm amidships, likewise
  bool operator==(const PullOut&) const = default;
};

/// How a step of heading, speed or depth was followed.
struct StepAccount {
  Ordered what{};
  double at_s = 0;                       ///< of the run
  double from = 0;                       ///< rad, m/s or m
  double to = 0;                         ///< of headings the short way from that
  double lasted_s = 0;                   ///< until the next of its kind, or the end
  std::optional<StepResponse> response;  ///< nothing: too few rows
  bool operator==(const StepAccount&) const = default;
};

/// A figure that there is not.
struct AbsentFigure {
  std::string name;  ///< "tactical_diameter_m"
  std::string why;   ///< in words: "ended at 143 degrees"
  bool operator==(const AbsentFigure&) const = default;
};

/// What came of a manoeuvre of a vehicle's tasks.
struct ManoeuvreAccount {
  std::size_t task = 0;  ///< from 0
  ManoeuvreKind kind{};
  bool by_rudder = false;         ///< its helms are rad; else shares of the thrusters' yaw moment
  double heading_change_rad = 0;  ///< of a zig-zag: psi
  std::size_t legs = 0;           ///< helms that it has in all
  std::vector<TaskOrder> orders;  ///< since it began, the last time that it did; none: it did not
  double followed_s = 0;          ///< of the run: the last step that it had

  // What the rows of the log tell; as it is by default where no log is kept.
  double ended_s = 0;            ///< of the run
  bool was_interrupted = false;  ///< by who steers it, or by its way home, and not taken up again
  double turned_rad = 0;         ///< from its execute to its end, to starboard
  std::optional<ApproachAccount> approach;
  std::optional<TurningCircle> circle;
  std::optional<ZigZag> zig_zag;
  std::optional<Spiral> spiral;
  std::optional<PullOut> pull_out;
  std::vector<StepAccount> steps;
  std::vector<AbsentFigure> absent;

  [[nodiscard]] bool has_begun() const noexcept { return !orders.empty(); }
  /// It came to its own end, and not to that of the run or of the vehicle.
  [[nodiscard]] bool is_over() const noexcept;
  /// When the helm was first put over; nothing: it was not.
  [[nodiscard]] std::optional<double> executed_s() const noexcept;
  bool operator==(const ManoeuvreAccount&) const = default;
};

struct Mission;
struct MissionState;
/// One for each manoeuvre of its tasks, without what rows tell.
[[nodiscard]] std::vector<ManoeuvreAccount> manoeuvres_of(const Mission& mission,
                                                          const MissionState& state);

/// What the rows of the log tell of all manoeuvres of a vehicle. Where they are further apart than
/// 20 degrees of a turn, 1.5 % of its radius, there are no figures.
/// @param until_s  that the vehicle went on
void add_rows(const VehicleRows& rows, double until_s, std::vector<ManoeuvreAccount>& manoeuvres);

}  // namespace slackwater::twin
