#pragma once
#include <optional>
#include <span>
#include <vector>

#include "api/ask/plan/plan.h"

namespace slackwater::api {

/// What a plan may not do.
enum class Rule {
  chance,        ///< a start of no probability, or of less than is asked for
  skills,        ///< a crew that cannot do it
  kinds,         ///< a vehicle of another kind, or one for two
  packs_of_one,  ///< more packs than there are
  vessel_hours,  ///< out and home again within the vessel's hours, with the contingency
  crew_hours,    ///< and within the shift of every crew aboard
  place_aboard,  ///< a crew or a vehicle on two vessels in one day, or not on its own
  job_twice,
  crew_twice,
  vehicle_twice,
  vessel_twice,  ///< at two places, or without the time from one to the other
  crowded,       ///< more crews aboard than there is room for
  packs,         ///< more packs taken than are charged
  charger,       ///< more packs on a charger than it has places, or charged before they are back
};

/// A rule that is broken, and the vessel, crew, vehicle, battery or charger that it is about.
struct Breach {
  Rule rule = Rule::chance;
  std::size_t resource = 0;
  bool operator==(const Breach&) const = default;
};

/// What stands in the way of an assignment by itself.
[[nodiscard]] std::optional<Breach> breach_of(const PlanProblem& problem,
                                              const Assignment& assignment);
/// What stands in the way of two together.
/// @param kits  of the problem's vehicles, see `kits_of`
[[nodiscard]] std::optional<Breach> breach_between(const PlanProblem& problem,
                                                   const std::vector<std::size_t>& kits,
                                                   const Assignment& a, const Assignment& b);
/// What stands in the way of all together that does not of any two: room aboard.
[[nodiscard]] std::optional<Breach> breach_of_room(const PlanProblem& problem,
                                                   std::span<const Assignment> assignments);
/// Packs are taken charged, charged once they are back, and no charger has more than it can.
[[nodiscard]] std::optional<Breach> breach_of_packs(const PlanProblem& problem,
                                                    std::span<const Assignment> assignments,
                                                    std::span<const Charge> charges);
/// When the vessel of a job has to be at its place: all the time, or to put its crew off and to
/// take it back. For that she is there from the last slot on that leaves her the time.
struct VesselStay {
  Minute from = 0;
  Minute to = 0;
};
[[nodiscard]] std::vector<VesselStay> stays_of(const PlanProblem& problem, const PlanJob& job,
                                               const JobStart& start);
/// All of these.
[[nodiscard]] std::optional<Breach> breach_in(const PlanProblem& problem,
                                              std::span<const Assignment> assignments,
                                              std::span<const Charge> charges);

/// A job at a start by a crew on a vessel: whether their hours hold it.
[[nodiscard]] bool vessel_holds(const PlanProblem& problem, const PlanVessel& vessel,
                                const PlanJob& job, const JobStart& start);
[[nodiscard]] bool shift_holds(const PlanProblem& problem, const PlanVessel& vessel,
                               const PlanCrew& crew, const PlanJob& job, const JobStart& start);
/// Whether a crew has every skill of a job.
[[nodiscard]] bool is_skilled(const PlanCrew& crew, const PlanJob& job);
/// The vehicles of a vessel, or of any, that are of one of these kinds.
[[nodiscard]] std::vector<std::size_t> vehicles_of(const PlanProblem& problem, std::size_t vessel,
                                                   const std::vector<std::string>& kinds);
/// Whether a start has a chance, and as much as is asked for.
[[nodiscard]] inline bool has_chance(const PlanProblem& problem, const JobStart& start) {
  return start.probability > 0 && start.probability >= problem.least_probability;
}
/// Slots that a charge of this battery takes.
[[nodiscard]] inline std::size_t charge_slots(const PlanProblem& problem,
                                              const PlanBattery& battery) {
  return problem.slot_from(battery.charge_min);
}

}  // namespace slackwater::api
