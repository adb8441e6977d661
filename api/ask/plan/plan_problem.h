#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/local_time.h"
#include "fields/base/time.h"

namespace slackwater::api {

/// Whole minutes after the beginning of the plan's day.
using Minute = int;

/// From one minute to another, both ends included.
struct PlanHours {
  Minute from = 0;
  Minute to = 24 * 60;
  bool operator==(const PlanHours&) const = default;
};

/// Takes crews and their vehicles out, lies at one place at a time, and comes home.
struct PlanVessel {
  std::string id;
  std::size_t crews = 1;  ///< aboard at most, and at work from it at once
  PlanHours hours;        ///< from leaving its port to being back
  /// Where it comes from and goes back to; absent: it lies in the farm, wherever the work is.
  std::optional<std::size_t> port;
  /// Minutes of its way from the first place to the second; 0 from a place to itself.
  std::vector<std::vector<Minute>> way_min;
};

/// People who work together, on one task at a time and on one vessel all day.
struct PlanCrew {
  std::string id;
  std::vector<std::string> skills;
  PlanHours shift;                    ///< from leaving port to being back; the vessel keeps to it
  std::optional<std::size_t> vessel;  ///< absent: any
};

/// What is flown, dived or sailed at a task. It stays with one vessel all day.
struct PlanVehicle {
  std::string id;
  std::string kind;                   ///< rov, auv, usv, uav
  std::optional<std::size_t> vessel;  ///< absent: any
  std::optional<std::size_t> battery;
  Minute swap_min = 0;  ///< after each task, before it can begin another
};

/// Packs of one make, all charged at the beginning. Vehicles that share them sail together.
struct PlanBattery {
  std::string id;
  std::size_t count = 1;
  double usable_wh = 0;
  Minute charge_min = 0;
  std::vector<std::size_t> chargers;  ///< empty: what is used is not charged again that day
};

/// Charges so many packs at once.
struct PlanCharger {
  std::string id;
  std::size_t places = 1;
};

/// One start of a job, as the windows have it.
struct JobStart {
  std::size_t slot = 0;
  double probability = 0;  ///< 0 to 1, of all being well to the way home
  Minute hold_min = 0;     ///< the crew, the vehicles and the vessel are there for so long
  double energy_wh = 0;    ///< of each vehicle; 0: nobody knows, one pack
};

/// A task at a place, done once or not at all.
struct PlanJob {
  std::string id;    ///< "cp_anode@A01"
  std::string task;  ///< "cp_anode"
  std::size_t place = 0;
  double priority = 1;  ///< what it is worth that it is done, more than 0
  /// One for each vehicle that it takes: the kinds that will do.
  std::vector<std::vector<std::string>> vehicles;
  std::vector<std::string> skills;  ///< that its crew has to have
  Minute contingency_min = 0;       ///< more that there has to be until the end of the hours
  /// How long the vessel lies there when she puts the crew off and when she takes it back; in
  /// between she may go elsewhere. 0: she stays for all of it.
  Minute drop_off_min = 0;
  std::vector<JobStart> starts;  ///< by slot, each slot once; others are none
  std::string without_starts;    ///< why there are none, or so few, in words; may be empty
};

/// A day's work and what there is to do it with. Indices are into these lists.
///
/// Starts and charges begin at slots; times in between are told in minutes.
struct PlanProblem {
  UtcTime begin{};
  std::optional<TimeZone> zone;  ///< of the clocks in texts; absent: UTC
  Minute slot_min = 15;
  std::size_t slots = 96;
  /// A start with less is not taken: 0 plans by expected value alone.
  double least_probability = 0;
  std::vector<std::string> places;
  std::vector<PlanVessel> vessels;
  std::vector<PlanCrew> crews;
  std::vector<PlanVehicle> vehicles;
  std::vector<PlanBattery> batteries;
  std::vector<PlanCharger> chargers;
  std::vector<PlanJob> jobs;

  [[nodiscard]] Minute minute_of(std::size_t slot) const noexcept {
    return static_cast<Minute>(slot) * slot_min;
  }
  /// The first slot that does not begin before a minute.
  [[nodiscard]] std::size_t slot_from(Minute minute) const noexcept {
    return static_cast<std::size_t>((minute + slot_min - 1) / slot_min);
  }
};

/// Packs that a vehicle of this battery takes along to a start.
[[nodiscard]] std::size_t packs_for(const PlanBattery& battery, const JobStart& start) noexcept;

/// Vehicles in groups, by the batteries and chargers that they share: a group sails together.
/// @return the group of each vehicle, counted from 0 without holes
[[nodiscard]] std::vector<std::size_t> kits_of(const PlanProblem& problem);

/// @throws ContractViolation for indices beyond the lists, and for numbers out of their range
void expect_sound(const PlanProblem& problem);

}  // namespace slackwater::api
