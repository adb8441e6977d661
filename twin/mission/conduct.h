#pragma once
#include <optional>
#include <vector>

#include "twin/body/attitude.h"
#include "twin/inspection/inspection_plan.h"
#include "twin/mission/fault.h"
#include "twin/mission/limit.h"
#include "twin/mission/standard_behaviour.h"
#include "twin/search/mammal_duty.h"
#include "twin/search/person_search.h"
#include "twin/surface/cleaning.h"

namespace slackwater::twin {

/// Who steers.
enum class Autonomy {
  automatic,  ///< the vehicle itself; it needs no link
  shared,     ///< a pilot, whose motion is kept inside limits
  teleop,     ///< a pilot alone
};
/// auto, shared, teleop.
[[nodiscard]] const char* name_of(Autonomy autonomy) noexcept;

/// How much energy has to be left when a vehicle is home again.
struct Reserve {
  double share = 0.2;   ///< of the battery
  double margin = 1.3;  ///< on what the way home takes by reckoning
  bool operator==(const Reserve&) const = default;
};

/// How a vehicle holds.
struct Holding {
  double resume_after_s = 60;  ///< that limits have to hold again before it goes on
  double overlap_m = 2;        ///< of its leg that is done again
  bool operator==(const Holding&) const = default;
};

/// A pilot's hand: how far off the plan it aims, as an Ornstein-Uhlenbeck process in each
/// direction, and how much faster than asked it goes.
struct PilotHand {
  double wander_m = 0;  ///< standard deviation along each axis
  double memory_s = 5;
  double haste = 1;  ///< times the speed of the plan
  bool operator==(const PilotHand&) const = default;
};

/// What shared autonomy keeps a pilot inside.
struct Envelope {
  double most_speed_m_s = 0;      ///< 0: none
  double stand_off_m = 0;         ///< from structures
  std::optional<double> fence_m;  ///< from home, in the plane
  bool operator==(const Envelope&) const = default;
};

/// How a vehicle conducts itself beside its tasks: what does not change in a run.
struct Conduct {
  BehaviourTree behaviour = standard_behaviour();
  Autonomy autonomy = Autonomy::automatic;
  double tick_s = 1;                     ///< of the tree
  std::optional<Triple<double>> home_m;  ///< absent: where it starts
  double clear_m = 2;                    ///< off structures on its way home
  Reserve reserve;
  Holding holding;
  PilotHand pilot;
  Envelope envelope;
  std::optional<Triple<double>> deck_point_m;  ///< body axes: what is watched for its motion
  std::vector<Limit> limits;
  std::vector<Fault> faults;
  std::vector<Assumption> assumed;
  std::optional<PersonSearch> search;        ///< whom it looks out for
  std::optional<MammalDuty> mammals;         ///< which animals it watches for
  std::optional<CleaningPlan> cleaning;      ///< what it takes growth off
  std::optional<InspectionPlan> inspection;  ///< what it looks at
  bool operator==(const Conduct&) const = default;
};

/// `conduct` of a vehicle's YAML, all keys optional:
///
///     conduct:
///       autonomy: auto | shared | teleop
///       tick_s: 1
///       home: {north_m, east_m, depth_m or height_m}
///       clear_m: 2
///       reserve: {share: 0.2, margin: 1.3}
///       holding: {resume_after: 1min, overlap_m: 2}
///       pilot: {wander_m: 0.3, memory_s: 5, haste: 1.2}     # of shared and teleop
///       envelope: {most_speed_m_s: 0.5, stand_off_m: 3, fence_m: 100}   # of shared
///       deck_point: {forward_m, starboard_m, up_m}
///       limits, faults, assume, search, mammals, cleaning, inspection: see there
///       noise_by: NAME      # beside mammals: the vehicle whose work is the noise
///       behaviour, trees: see read_behaviour_tree.h; absent: `standard_behaviour`
///
/// @throws Error(invalid_input)
[[nodiscard]] Conduct read_conduct(const Config& config);

}  // namespace slackwater::twin
