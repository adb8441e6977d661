#include "api/ask/plan/plan_rules.h"

#include <algorithm>
#include <set>

namespace slackwater::api {
namespace {

/// From leaving the port to being back, the contingency used up.
PlanHours out_and_home(const PlanProblem& problem, const PlanVessel& vessel, const PlanJob& job,
                       const JobStart& start) {
  const Minute begin = problem.minute_of(start.slot);
  PlanHours hours{begin, begin + start.hold_min + job.contingency_min};
  if (vessel.port) {
    hours.from -= vessel.way_min[*vessel.port][job.place];
    hours.to += vessel.way_min[job.place][*vessel.port];
  }
  return hours;
}

bool holds(const PlanHours& outer, const PlanHours& inner) {
  return outer.from <= inner.from && inner.to <= outer.to;
}

bool shift_holds(const PlanProblem& problem, std::size_t crew, const Assignment& assignment) {
  return shift_holds(problem, problem.vessels[assignment.vessel], problem.crews[crew],
                     problem.jobs[assignment.job], start_of(problem, assignment));
}

/// Whether a vessel can lie at two places for two jobs, with the ways between.
bool can_be_at_both(const PlanProblem& problem, const PlanVessel& vessel, const Assignment& a,
                    const Assignment& b) {
  const PlanJob &job_a = problem.jobs[a.job], &job_b = problem.jobs[b.job];
  const Minute there = vessel.way_min[job_a.place][job_b.place];
  const Minute back = vessel.way_min[job_b.place][job_a.place];
  for (const VesselStay& at_a : stays_of(problem, job_a, start_of(problem, a)))
    for (const VesselStay& at_b : stays_of(problem, job_b, start_of(problem, b)))
      if (at_b.from < at_a.to + there && at_a.from < at_b.to + back) return false;
  return true;
}

/// The packs of one battery, slot by slot.
struct PackCount {
  std::vector<int> taken;
  std::vector<int> back;
};

PackCount packs_used(const PlanProblem& problem, std::span<const Assignment> assignments,
                     std::size_t battery) {
  PackCount count{std::vector<int>(problem.slots + 1), std::vector<int>(problem.slots + 1)};
  for (const Assignment& one : assignments) {
    for (const std::size_t k : one.vehicles) {
      if (problem.vehicles[k].battery != battery) continue;
      const JobStart& start = start_of(problem, one);
      const int packs = static_cast<int>(packs_for(problem.batteries[battery], start));
      count.taken[start.slot] += packs;
      count.back[std::min(problem.slot_from(end_of(problem, one)), problem.slots)] += packs;
    }
  }
  return count;
}

}  // namespace

bool vessel_holds(const PlanProblem& problem, const PlanVessel& vessel, const PlanJob& job,
                  const JobStart& start) {
  return holds(vessel.hours, out_and_home(problem, vessel, job, start));
}

bool shift_holds(const PlanProblem& problem, const PlanVessel& vessel, const PlanCrew& crew,
                 const PlanJob& job, const JobStart& start) {
  return holds(crew.shift, out_and_home(problem, vessel, job, start));
}

bool is_skilled(const PlanCrew& crew, const PlanJob& job) {
  return std::all_of(job.skills.begin(), job.skills.end(), [&](const std::string& skill) {
    return std::find(crew.skills.begin(), crew.skills.end(), skill) != crew.skills.end();
  });
}

std::vector<std::size_t> vehicles_of(const PlanProblem& problem, std::size_t vessel,
                                     const std::vector<std::string>& kinds) {
  std::vector<std::size_t> fit;
  for (std::size_t k = 0; k < problem.vehicles.size(); ++k) {
    const PlanVehicle& vehicle = problem.vehicles[k];
    if (vehicle.vessel.value_or(vessel) == vessel &&
        std::find(kinds.begin(), kinds.end(), vehicle.kind) != kinds.end())
      fit.push_back(k);
  }
  return fit;
}

std::optional<Breach> breach_of(const PlanProblem& problem, const Assignment& assignment) {
  const PlanJob& job = problem.jobs[assignment.job];
  const JobStart& start = start_of(problem, assignment);
  const PlanCrew& crew = problem.crews[assignment.crew];
  const std::size_t vessel = assignment.vessel;
  if (!has_chance(problem, start)) return Breach{Rule::chance, 0};
  if (!is_skilled(crew, job)) return Breach{Rule::skills, assignment.crew};
  if (assignment.vehicles.size() != job.vehicles.size()) return Breach{Rule::kinds, 0};
  for (std::size_t r = 0; r < job.vehicles.size(); ++r) {
    const std::size_t k = assignment.vehicles[r];
    const std::vector<std::size_t> fit = vehicles_of(problem, vessel, job.vehicles[r]);
    if (std::count(assignment.vehicles.begin(), assignment.vehicles.end(), k) > 1 ||
        std::find(fit.begin(), fit.end(), k) == fit.end())
      return Breach{Rule::kinds, k};
    if (problem.vehicles[k].battery) {
      const PlanBattery& battery = problem.batteries[*problem.vehicles[k].battery];
      if (packs_for(battery, start) > battery.count)
        return Breach{Rule::packs_of_one, *problem.vehicles[k].battery};
    }
  }
  if (crew.vessel.value_or(vessel) != vessel) return Breach{Rule::place_aboard, assignment.crew};
  if (problem.vessels[vessel].crews == 0) return Breach{Rule::crowded, vessel};
  if (!vessel_holds(problem, problem.vessels[vessel], job, start))
    return Breach{Rule::vessel_hours, vessel};
  if (!shift_holds(problem, assignment.crew, assignment))
    return Breach{Rule::crew_hours, assignment.crew};
  return std::nullopt;
}

std::vector<VesselStay> stays_of(const PlanProblem& problem, const PlanJob& job,
                                 const JobStart& start) {
  const Minute begin = problem.minute_of(start.slot), end = begin + start.hold_min;
  const Minute back = (end - job.drop_off_min) / problem.slot_min * problem.slot_min;
  if (job.drop_off_min == 0 || back <= begin + job.drop_off_min) return {{begin, end}};
  return {{begin, begin + job.drop_off_min}, {back, end}};
}

std::optional<Breach> breach_between(const PlanProblem& problem,
                                     const std::vector<std::size_t>& kits, const Assignment& a,
                                     const Assignment& b) {
  if (a.job == b.job) return Breach{Rule::job_twice, a.job};
  const Minute begin_a = begin_of(problem, a), end_a = end_of(problem, a);
  const Minute begin_b = begin_of(problem, b), end_b = end_of(problem, b);
  const auto apart = [&](Minute after_a, Minute after_b) {
    return begin_b >= end_a + after_a || begin_a >= end_b + after_b;
  };
  for (const std::size_t k : a.vehicles) {
    const Minute swap = problem.vehicles[k].swap_min;
    if (std::find(b.vehicles.begin(), b.vehicles.end(), k) != b.vehicles.end() &&
        !apart(swap, swap))
      return Breach{Rule::vehicle_twice, k};
  }
  if (a.crew == b.crew && !apart(0, 0)) return Breach{Rule::crew_twice, a.crew};
  if (a.vessel == b.vessel) {
    const PlanVessel& vessel = problem.vessels[a.vessel];
    const std::size_t place_a = problem.jobs[a.job].place, place_b = problem.jobs[b.job].place;
    if (place_a != place_b && !can_be_at_both(problem, vessel, a, b))
      return Breach{Rule::vessel_twice, a.vessel};
    if (!shift_holds(problem, a.crew, b)) return Breach{Rule::crew_hours, a.crew};
    if (!shift_holds(problem, b.crew, a)) return Breach{Rule::crew_hours, b.crew};
    return std::nullopt;
  }
  if (a.crew == b.crew) return Breach{Rule::place_aboard, a.crew};
  for (const std::size_t k : a.vehicles)
    for (const std::size_t l : b.vehicles)
      if (kits[k] == kits[l]) return Breach{Rule::place_aboard, k};
  return std::nullopt;
}

std::optional<Breach> breach_of_room(const PlanProblem& problem,
                                     std::span<const Assignment> assignments) {
  std::vector<std::set<std::size_t>> aboard(problem.vessels.size());
  for (const Assignment& one : assignments) aboard[one.vessel].insert(one.crew);
  for (std::size_t v = 0; v < aboard.size(); ++v)
    if (aboard[v].size() > problem.vessels[v].crews) return Breach{Rule::crowded, v};
  return std::nullopt;
}

std::optional<Breach> breach_of_packs(const PlanProblem& problem,
                                      std::span<const Assignment> assignments,
                                      std::span<const Charge> charges) {
  for (std::size_t b = 0; b < problem.batteries.size(); ++b) {
    const PlanBattery& battery = problem.batteries[b];
    const PackCount used = packs_used(problem, assignments, b);
    int charged = static_cast<int>(battery.count);
    int empty = 0;
    for (std::size_t slot = 0; slot < problem.slots; ++slot) {
      empty += used.back[slot];
      for (const Charge& charge : charges) {
        if (charge.battery != b) continue;
        if (charge.slot + charge_slots(problem, battery) == slot) ++charged;
        if (charge.slot == slot) --empty;
      }
      charged -= used.taken[slot];
      if (charged < 0) return Breach{Rule::packs, b};
      if (empty < 0) return Breach{Rule::charger, b};
    }
  }
  for (std::size_t g = 0; g < problem.chargers.size(); ++g) {
    for (std::size_t slot = 0; slot < problem.slots; ++slot) {
      std::size_t busy = 0;
      for (const Charge& charge : charges) {
        const std::size_t end =
            charge.slot + charge_slots(problem, problem.batteries[charge.battery]);
        busy += charge.charger == g && charge.slot <= slot && slot < end ? 1 : 0;
      }
      if (busy > problem.chargers[g].places) return Breach{Rule::charger, g};
    }
  }
  for (const Charge& charge : charges) {
    const std::vector<std::size_t>& fit = problem.batteries[charge.battery].chargers;
    if (std::find(fit.begin(), fit.end(), charge.charger) == fit.end())
      return Breach{Rule::charger, charge.charger};
  }
  return std::nullopt;
}

std::optional<Breach> breach_in(const PlanProblem& problem, std::span<const Assignment> assignments,
                                std::span<const Charge> charges) {
  const std::vector<std::size_t> kits = kits_of(problem);
  for (std::size_t i = 0; i < assignments.size(); ++i) {
    if (auto breach = breach_of(problem, assignments[i])) return breach;
    for (std::size_t j = 0; j < i; ++j)
      if (auto breach = breach_between(problem, kits, assignments[j], assignments[i]))
        return breach;
  }
  if (auto breach = breach_of_room(problem, assignments)) return breach;
  return breach_of_packs(problem, assignments, charges);
}

}  // namespace slackwater::api
