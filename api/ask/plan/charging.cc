#include "api/ask/plan/charging.h"

#include "api/ask/plan/plan_rules.h"

namespace slackwater::api {

std::vector<Charge> earliest_charges(const PlanProblem& problem,
                                     std::span<const Assignment> assignments) {
  std::vector<Charge> charges;
  std::vector<std::size_t> empty(problem.batteries.size());
  // The slot from which each place of each charger is free.
  std::vector<std::vector<std::size_t>> free_from;
  for (const PlanCharger& charger : problem.chargers) free_from.emplace_back(charger.places, 0);
  for (std::size_t slot = 0; slot < problem.slots; ++slot) {
    for (const Assignment& one : assignments) {
      if (problem.slot_from(end_of(problem, one)) != slot) continue;
      for (const std::size_t k : one.vehicles)
        if (const auto b = problem.vehicles[k].battery)
          empty[*b] += packs_for(problem.batteries[*b], start_of(problem, one));
    }
    for (std::size_t b = 0; b < empty.size(); ++b) {
      for (const std::size_t g : problem.batteries[b].chargers) {
        for (std::size_t& free : free_from[g]) {
          if (empty[b] == 0 || free > slot) continue;
          free = slot + charge_slots(problem, problem.batteries[b]);
          charges.push_back({b, g, slot});
          --empty[b];
        }
      }
    }
  }
  return charges;
}

}  // namespace slackwater::api
