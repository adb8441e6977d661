#include "api/ask/plan/plan_problem.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fields/base/check.h"

namespace slackwater::api {
namespace {

bool are_below(const std::vector<std::size_t>& indices, std::size_t count) {
  return std::all_of(indices.begin(), indices.end(), [&](std::size_t i) { return i < count; });
}

bool is_below(const std::optional<std::size_t>& index, std::size_t count) {
  return !index || *index < count;
}

void expect_sound(const PlanProblem& problem, const PlanJob& job) {
  expects(job.place < problem.places.size(), "a job is at a place");
  expects(job.priority > 0 && std::isfinite(job.priority), "a job is worth something");
  expects(job.contingency_min >= 0, "a contingency is no less than 0");
  expects(job.drop_off_min >= 0, "putting off takes no less than 0");
  std::size_t next = 0;
  for (const JobStart& start : job.starts) {
    expects(start.slot >= next && start.slot < problem.slots, "starts go by slot, each once");
    expects(start.probability >= 0 && start.probability <= 1, "a probability is of 0 to 1");
    expects(start.hold_min > 0, "a job takes time");
    expects(start.energy_wh >= 0, "energy is no less than 0");
    next = start.slot + 1;
  }
}

/// The first of a chain of groups that were joined.
std::size_t head_of(const std::vector<std::size_t>& joined, std::size_t i) {
  while (joined[i] != i) i = joined[i];
  return i;
}

}  // namespace

std::size_t packs_for(const PlanBattery& battery, const JobStart& start) noexcept {
  const double packs = std::ceil(start.energy_wh / battery.usable_wh - 1e-9);
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::max(0.0, packs)));
}

std::vector<std::size_t> kits_of(const PlanProblem& problem) {
  // Vehicles first, then batteries, then chargers: what belongs together is joined.
  const std::size_t vehicles = problem.vehicles.size();
  const std::size_t batteries = problem.batteries.size();
  std::vector<std::size_t> joined(vehicles + batteries + problem.chargers.size());
  std::iota(joined.begin(), joined.end(), std::size_t{0});
  const auto join = [&](std::size_t a, std::size_t b) {
    joined[head_of(joined, b)] = head_of(joined, a);
  };
  for (std::size_t k = 0; k < vehicles; ++k)
    if (problem.vehicles[k].battery) join(k, vehicles + *problem.vehicles[k].battery);
  for (std::size_t b = 0; b < batteries; ++b)
    for (const std::size_t g : problem.batteries[b].chargers)
      join(vehicles + b, vehicles + batteries + g);
  std::vector<std::size_t> heads;
  std::vector<std::size_t> kits;
  for (std::size_t k = 0; k < vehicles; ++k) {
    const std::size_t head = head_of(joined, k);
    const auto known = std::find(heads.begin(), heads.end(), head);
    kits.push_back(static_cast<std::size_t>(known - heads.begin()));
    if (known == heads.end()) heads.push_back(head);
  }
  return kits;
}

void expect_sound(const PlanProblem& problem) {
  expects(problem.slot_min > 0 && problem.slots > 0, "a day has slots");
  expects(problem.least_probability >= 0 && problem.least_probability <= 1,
          "a probability is of 0 to 1");
  for (const PlanVessel& vessel : problem.vessels) {
    expects(is_below(vessel.port, problem.places.size()), "a port is a place");
    expects(vessel.way_min.size() == problem.places.size(), "ways lead between all places");
    for (const auto& ways : vessel.way_min) {
      expects(ways.size() == problem.places.size(), "ways lead between all places");
      expects(std::all_of(ways.begin(), ways.end(), [](Minute way) { return way >= 0; }),
              "no way takes less than no time");
    }
  }
  for (const PlanCrew& crew : problem.crews)
    expects(is_below(crew.vessel, problem.vessels.size()), "a crew is on a vessel");
  for (const PlanVehicle& vehicle : problem.vehicles) {
    expects(is_below(vehicle.vessel, problem.vessels.size()), "a vehicle is on a vessel");
    expects(is_below(vehicle.battery, problem.batteries.size()), "a vehicle has a battery");
    expects(vehicle.swap_min >= 0, "a swap takes no less than no time");
  }
  for (const PlanBattery& battery : problem.batteries) {
    expects(battery.usable_wh > 0 && battery.charge_min > 0, "a battery holds and takes a charge");
    expects(are_below(battery.chargers, problem.chargers.size()), "a battery has chargers");
  }
  for (const PlanJob& job : problem.jobs) expect_sound(problem, job);
}

}  // namespace slackwater::api
