#include "tests/api/ask/plan/plan_days.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "fields/base/text.h"

namespace slackwater::tests {
namespace {

using namespace slackwater::api;

struct Stay {
  Minute from = 0;
  Minute to = 0;
  std::size_t place = 0;
};

/// A pack at any slot: charged, out, waiting or on a charger.
bool packs_suffice(const PlanProblem& problem, const std::vector<Assignment>& assignments,
                   const std::vector<Charge>& charges, std::size_t b, std::string& why) {
  const PlanBattery& battery = problem.batteries[b];
  const std::size_t lasts =
      static_cast<std::size_t>(std::ceil(double(battery.charge_min) / problem.slot_min));
  // Each pack by itself: the slot from which it is charged, and the slot from which it waits.
  constexpr std::size_t never = 1000000;
  struct Pack {
    std::size_t charged_from = 0;
    std::size_t empty_from = never;
  };
  std::vector<Pack> packs(battery.count);
  for (std::size_t slot = 0; slot < problem.slots; ++slot) {
    for (const Charge& charge : charges) {
      if (charge.battery != b || charge.slot != slot) continue;
      const auto pack = std::find_if(packs.begin(), packs.end(),
                                     [&](const Pack& one) { return one.empty_from <= slot; });
      if (pack == packs.end()) {
        why = "a pack of " + battery.id + " is charged that is not there";
        return false;
      }
      *pack = {slot + lasts, never};
    }
    for (const Assignment& one : assignments) {
      const JobStart& start = problem.jobs[one.job].starts[one.start];
      if (start.slot != slot) continue;
      for (const std::size_t k : one.vehicles) {
        if (problem.vehicles[k].battery != b) continue;
        int wanted = std::max(1, static_cast<int>(std::ceil(start.energy_wh / battery.usable_wh)));
        const double back =
            (static_cast<double>(slot) * problem.slot_min + start.hold_min) / problem.slot_min;
        for (Pack& pack : packs) {
          if (wanted == 0 || pack.charged_from > slot) continue;
          pack = {never, static_cast<std::size_t>(std::ceil(back))};
          --wanted;
        }
        if (wanted > 0) {
          why = "no charged pack of " + battery.id + " at " + std::to_string(slot);
          return false;
        }
      }
    }
  }
  return true;
}

bool chargers_suffice(const PlanProblem& problem, const std::vector<Charge>& charges) {
  for (std::size_t g = 0; g < problem.chargers.size(); ++g) {
    for (std::size_t slot = 0; slot < 2 * problem.slots; ++slot) {
      std::size_t busy = 0;
      for (const Charge& charge : charges) {
        if (charge.charger != g || charge.slot > slot) continue;
        const Minute gone = static_cast<Minute>(slot - charge.slot) * problem.slot_min;
        if (gone < problem.batteries[charge.battery].charge_min) ++busy;
      }
      if (busy > problem.chargers[g].places) return false;
    }
  }
  return true;
}

/// What people, vehicles and vessels cannot do; the packs aside.
std::string what_is_wrong_with_times(const PlanProblem& problem,
                                     const std::vector<Assignment>& assignments) {
  std::set<std::size_t> jobs;
  std::map<std::size_t, std::vector<Stay>> of_crew, of_vehicle, of_vessel;
  std::map<std::size_t, std::set<std::size_t>> vessels_of_crew, crews_of_vessel, vessels_of_vehicle;
  std::map<std::size_t, std::vector<std::pair<Minute, Minute>>> trips;  // out and home, by vessel
  for (const Assignment& one : assignments) {
    const PlanJob& job = problem.jobs[one.job];
    const JobStart& start = job.starts[one.start];
    const PlanVessel& vessel = problem.vessels[one.vessel];
    if (!jobs.insert(one.job).second) return job.id + " is done twice";
    if (start.probability <= 0 || start.probability < problem.least_probability)
      return job.id + " has too small a chance";
    for (const std::string& skill : job.skills) {
      const auto& skills = problem.crews[one.crew].skills;
      if (std::find(skills.begin(), skills.end(), skill) == skills.end())
        return "the crew cannot do " + job.id;
    }
    if (one.vehicles.size() != job.vehicles.size()) return job.id + " lacks a vehicle";
    const Minute from = static_cast<Minute>(start.slot) * problem.slot_min;
    const Minute to = from + start.hold_min;
    for (std::size_t r = 0; r < one.vehicles.size(); ++r) {
      const PlanVehicle& vehicle = problem.vehicles[one.vehicles[r]];
      if (std::find(job.vehicles[r].begin(), job.vehicles[r].end(), vehicle.kind) ==
          job.vehicles[r].end())
        return vehicle.id + " is of another kind";
      if (vehicle.vessel && *vehicle.vessel != one.vessel) return vehicle.id + " is elsewhere";
      vessels_of_vehicle[one.vehicles[r]].insert(one.vessel);
      of_vehicle[one.vehicles[r]].push_back({from, to + vehicle.swap_min, job.place});
    }
    const PlanCrew& crew = problem.crews[one.crew];
    if (crew.vessel && *crew.vessel != one.vessel) return crew.id + " are elsewhere";
    of_crew[one.crew].push_back({from, to, job.place});
    Minute fetch = 0;  // the last slot at which she can still come for them
    while (fetch + problem.slot_min <= to - job.drop_off_min) fetch += problem.slot_min;
    if (job.drop_off_min == 0 || fetch <= from + job.drop_off_min) {
      of_vessel[one.vessel].push_back({from, to, job.place});
    } else {
      of_vessel[one.vessel].push_back({from, from + job.drop_off_min, job.place});
      of_vessel[one.vessel].push_back({fetch, to, job.place});
    }
    vessels_of_crew[one.crew].insert(one.vessel);
    crews_of_vessel[one.vessel].insert(one.crew);
    Minute out = from, home = to + job.contingency_min;
    if (vessel.port) {
      out -= vessel.way_min[*vessel.port][job.place];
      home += vessel.way_min[job.place][*vessel.port];
    }
    if (out < vessel.hours.from || home > vessel.hours.to) return vessel.id + " is out too long";
    trips[one.vessel].emplace_back(out, home);
  }
  for (const auto* stays : {&of_crew, &of_vehicle})
    for (const auto& [who, list] : *stays) {
      // Minute by minute: nobody at two jobs.
      std::map<Minute, int> at;
      for (const Stay& stay : list)
        for (Minute m = stay.from; m < stay.to; ++m)
          if (++at[m] > 1) return "someone is at two jobs at minute " + std::to_string(m);
    }
  for (const auto& [v, stays] : of_vessel) {
    for (const Stay& a : stays)
      for (const Stay& b : stays) {
        if (a.place == b.place || a.from > b.from) continue;
        if (b.from < a.to + problem.vessels[v].way_min[a.place][b.place])
          return problem.vessels[v].id + " is not there yet";
      }
  }
  for (const auto& [c, vessels] : vessels_of_crew)
    if (vessels.size() > 1) return problem.crews[c].id + " are on two vessels";
  for (const auto& [v, crews] : crews_of_vessel) {
    if (crews.size() > problem.vessels[v].crews) return problem.vessels[v].id + " is too full";
    for (const std::size_t c : crews)
      for (const auto& [out, home] : trips[v])
        if (out < problem.crews[c].shift.from || home > problem.crews[c].shift.to)
          return problem.crews[c].id + " are out beyond their shift";
  }
  for (const auto& [k, vessels] : vessels_of_vehicle) {
    for (const auto& [l, others] : vessels_of_vehicle) {
      std::set<std::size_t> all = vessels;
      if (k != l && !(problem.vehicles[k].battery &&
                      problem.vehicles[k].battery == problem.vehicles[l].battery))
        continue;
      all.insert(others.begin(), others.end());
      if (all.size() > 1) return problem.vehicles[k].id + " and its packs are on two vessels";
    }
  }
  return {};
}

/// Charges at the first slot that there is a place, for one battery a charger.
std::vector<Charge> charged_at_once(const PlanProblem& problem,
                                    const std::vector<Assignment>& assignments) {
  std::vector<Charge> charges;
  for (std::size_t b = 0; b < problem.batteries.size(); ++b) {
    const PlanBattery& battery = problem.batteries[b];
    std::vector<std::size_t> back;
    for (const Assignment& one : assignments) {
      const JobStart& start = problem.jobs[one.job].starts[one.start];
      for (const std::size_t k : one.vehicles) {
        if (problem.vehicles[k].battery != b) continue;
        const double end = static_cast<double>(start.slot) * problem.slot_min + start.hold_min;
        const int packs = std::max(1, int(std::ceil(start.energy_wh / battery.usable_wh)));
        back.insert(back.end(), static_cast<std::size_t>(packs),
                    static_cast<std::size_t>(std::ceil(end / problem.slot_min)));
      }
    }
    std::sort(back.begin(), back.end());
    if (battery.chargers.empty()) continue;
    const std::size_t g = battery.chargers.front();
    std::vector<std::size_t> free(problem.chargers[g].places, 0);
    const auto lasts =
        static_cast<std::size_t>(std::ceil(double(battery.charge_min) / problem.slot_min));
    for (const std::size_t slot : back) {
      const auto place = std::min_element(free.begin(), free.end());
      const std::size_t at = std::max(slot, *place);
      *place = at + lasts;
      charges.push_back({b, g, at});
    }
  }
  return charges;
}

struct Trial {
  const PlanProblem& problem;
  std::vector<std::vector<Assignment>> ways{};  ///< to do each job, the most probable first
  std::vector<double> rest{};                   ///< what the jobs from here on can be worth
  std::vector<Assignment> chosen{};
  double best = 0;

  void try_from(std::size_t job, double value) {
    best = std::max(best, value);
    if (job == ways.size() || value + rest[job] <= best + 1e-12) return;
    for (const Assignment& way : ways[job]) {
      chosen.push_back(way);
      std::string why;
      bool is_right = what_is_wrong_with_times(problem, chosen).empty();
      for (std::size_t b = 0; is_right && b < problem.batteries.size(); ++b)
        is_right = packs_suffice(problem, chosen, charged_at_once(problem, chosen), b, why);
      if (is_right)
        try_from(job + 1, value + problem.jobs[job].priority *
                                      problem.jobs[job].starts[way.start].probability);
      chosen.pop_back();
    }
    try_from(job + 1, value);
  }
};

void add_vehicle_choices(const PlanProblem& problem, const Assignment& one,
                         std::vector<Assignment>& ways) {
  const std::size_t need = one.vehicles.size();
  if (need == problem.jobs[one.job].vehicles.size()) {
    if (what_is_wrong_with_times(problem, {one}).empty()) ways.push_back(one);
    return;
  }
  for (std::size_t k = 0; k < problem.vehicles.size(); ++k) {
    Assignment more = one;
    more.vehicles.push_back(k);
    add_vehicle_choices(problem, more, ways);
  }
}

std::size_t pick(Rng& random, std::size_t least, std::size_t most) {
  return least + static_cast<std::size_t>(random.uniform() * double(most - least + 1));
}

}  // namespace

std::string what_is_wrong(const PlanProblem& problem, const std::vector<Assignment>& assignments,
                          const std::vector<Charge>& charges) {
  std::string why = what_is_wrong_with_times(problem, assignments);
  for (std::size_t b = 0; why.empty() && b < problem.batteries.size(); ++b)
    packs_suffice(problem, assignments, charges, b, why);
  if (why.empty() && !chargers_suffice(problem, charges)) why = "a charger is too full";
  return why;
}

double best_value_by_trying(const PlanProblem& problem) {
  Trial trial{problem};
  for (std::size_t j = 0; j < problem.jobs.size(); ++j) {
    std::vector<Assignment> ways;
    for (std::size_t s = 0; s < problem.jobs[j].starts.size(); ++s)
      for (std::size_t v = 0; v < problem.vessels.size(); ++v)
        for (std::size_t c = 0; c < problem.crews.size(); ++c)
          add_vehicle_choices(problem, {j, s, v, c, {}}, ways);
    std::stable_sort(ways.begin(), ways.end(), [&](const Assignment& a, const Assignment& b) {
      return problem.jobs[j].starts[a.start].probability >
             problem.jobs[j].starts[b.start].probability;
    });
    trial.ways.push_back(std::move(ways));
  }
  trial.rest.assign(problem.jobs.size() + 1, 0);
  for (std::size_t j = problem.jobs.size(); j-- > 0;) {
    double most = 0;
    for (const Assignment& way : trial.ways[j])
      most = std::max(most, problem.jobs[j].starts[way.start].probability);
    trial.rest[j] = trial.rest[j + 1] + problem.jobs[j].priority * most;
  }
  trial.try_from(0, 0);
  return trial.best;
}

std::vector<std::vector<Minute>> ways_of(std::size_t places, Minute way) {
  std::vector<std::vector<Minute>> ways(places, std::vector<Minute>(places, way));
  for (std::size_t i = 0; i < places; ++i) ways[i][i] = 0;
  return ways;
}

PlanProblem small_random_day(Rng& random) {
  PlanProblem day;
  day.begin = parse_utc("2025-06-02T00:00:00Z");
  day.slot_min = 60;
  day.slots = 9;
  day.least_probability = random.uniform() < 0.4 ? random.uniform(0.2, 0.8) : 0;
  const std::size_t turbines = pick(random, 1, 3);
  for (std::size_t p = 0; p <= turbines; ++p) day.places.push_back("P" + std::to_string(p));
  const std::size_t vessels = pick(random, 1, 2);
  for (std::size_t v = 0; v < vessels; ++v) {
    PlanVessel vessel{"vessel" + std::to_string(v), pick(random, 1, 2), {0, 540}, {}, {}};
    if (random.uniform() < 0.7) vessel.port = 0;
    if (random.uniform() < 0.3) vessel.hours.to = 420;
    vessel.way_min = ways_of(day.places.size(), 0);
    for (auto& row : vessel.way_min)
      for (Minute& way : row) way = static_cast<Minute>(random.uniform(0, 75));
    for (std::size_t p = 0; p < day.places.size(); ++p) vessel.way_min[p][p] = 0;
    day.vessels.push_back(std::move(vessel));
  }
  const std::vector<std::string> skills{"rov", "uav"};
  const std::size_t crews = pick(random, 1, 2);
  for (std::size_t c = 0; c < crews; ++c) {
    PlanCrew crew{"crew" + std::to_string(c), skills, {0, 540}, {}};
    if (random.uniform() < 0.3) crew.skills = {skills[pick(random, 0, 1)]};
    if (random.uniform() < 0.4) crew.shift = {static_cast<Minute>(60 * pick(random, 0, 2)), 480};
    if (random.uniform() < 0.4) crew.vessel = pick(random, 0, vessels - 1);
    day.crews.push_back(std::move(crew));
  }
  const std::size_t vehicles = pick(random, 1, 3);
  if (random.uniform() < 0.7) {
    day.batteries.push_back(
        {"lipo", pick(random, 1, 3), 100, static_cast<Minute>(random.uniform(30, 200)), {}});
    if (random.uniform() < 0.7) {
      day.chargers.push_back({"deck", pick(random, 1, 2)});
      day.batteries.front().chargers.push_back(0);
    }
  }
  for (std::size_t k = 0; k < vehicles; ++k) {
    PlanVehicle vehicle{"vehicle" + std::to_string(k), skills[pick(random, 0, 1)], {}, {}, 0};
    // Those that share packs are on one vessel, or on any.
    if (!day.batteries.empty() && random.uniform() < 0.6)
      vehicle.battery = 0;
    else if (random.uniform() < 0.4)
      vehicle.vessel = pick(random, 0, vessels - 1);
    if (random.uniform() < 0.4) vehicle.swap_min = static_cast<Minute>(random.uniform(0, 60));
    day.vehicles.push_back(std::move(vehicle));
  }
  const std::size_t jobs = pick(random, 2, 4);
  for (std::size_t j = 0; j < jobs; ++j) {
    PlanJob job;
    job.id = "job" + std::to_string(j);
    job.task = "task";
    job.place = pick(random, 1, turbines);
    job.priority = static_cast<double>(pick(random, 1, 3));
    const double kind = random.uniform();
    if (kind < 0.4)
      job.vehicles = {{skills[pick(random, 0, 1)]}};
    else if (kind < 0.6)
      job.vehicles = {{"rov", "uav"}};
    else if (kind < 0.7)
      job.vehicles = {{"rov"}, {"rov", "uav"}};
    if (random.uniform() < 0.5) job.skills = {skills[pick(random, 0, 1)]};
    if (random.uniform() < 0.5) job.contingency_min = static_cast<Minute>(random.uniform(0, 60));
    if (random.uniform() < 0.4) job.drop_off_min = static_cast<Minute>(random.uniform(5, 50));
    for (std::size_t slot = 0; slot < day.slots; ++slot) {
      if (random.uniform() < 0.3) continue;
      const double chance = random.uniform() < 0.1 ? 0 : random.uniform();
      job.starts.push_back({slot, chance, static_cast<Minute>(random.uniform(20, 190)),
                            random.uniform() < 0.3 ? 0 : random.uniform(0, 250)});
    }
    day.jobs.push_back(std::move(job));
  }
  return day;
}

PlanProblem farm_day(std::size_t jobs, std::size_t teams, Rng& random) {
  PlanProblem day;
  day.begin = parse_utc("2025-06-02T00:00:00Z");
  std::vector<std::pair<double, double>> at_km{{-30, -5}};  // the port
  day.places.push_back("port");
  for (std::size_t j = 0; j < jobs; ++j) {
    day.places.push_back(formatted("T{:02}", j + 1));
    at_km.emplace_back(random.uniform(0, 12), random.uniform(0, 12));
  }
  for (std::size_t v = 0; v < (teams + 1) / 2; ++v) {
    PlanVessel vessel{formatted("ctv{}", v + 1), 2, {300, 1200}, 0, {}};
    for (const auto& a : at_km) {
      vessel.way_min.emplace_back();
      for (const auto& b : at_km)
        vessel.way_min.back().push_back(static_cast<Minute>(
            std::ceil(std::hypot(a.first - b.first, a.second - b.second) / 37.0 * 60)));
    }
    day.vessels.push_back(std::move(vessel));
  }
  day.chargers.push_back({"deck", 2});
  day.batteries.push_back({"rov_pack", 3, 220, 120, {0}});
  day.batteries.push_back({"uav_pack", 6, 80, 60, {0}});
  for (std::size_t c = 0; c < teams; ++c) {
    const bool flies = c % 2 == 1;
    day.crews.push_back({formatted("crew{}", c + 1), {"rov", "uav"}, {330, 1110}, c / 2});
    day.vehicles.push_back({formatted("{}{}", flies ? "uav" : "rov", c + 1), flies ? "uav" : "rov",
                            c / 2, std::nullopt, 15});
  }
  // The packs of the first vessel's vehicles; the others have a lead or packs enough.
  if (teams >= 2) {
    day.vehicles[0].battery = 0;
    day.vehicles[1].battery = 1;
  }
  for (std::size_t j = 0; j < jobs; ++j) {
    PlanJob job;
    job.task = j % 3 == 2 ? "blade_scan" : "cp_anode";
    job.place = 1 + (j % 4 == 3 ? j - 1 : j);  // now and then two at one turbine
    job.id = job.task + "@" + day.places[job.place] + (j % 4 == 3 ? "b" : "");
    job.priority = 1 + std::floor(random.uniform(0, 4));
    const bool flies = j % 3 == 2;
    job.vehicles = {{flies ? "uav" : "rov"}};
    job.skills = {flies ? "uav" : "rov"};
    job.contingency_min = 30;
    const auto hold =
        static_cast<Minute>(flies ? random.uniform(80, 140) : random.uniform(150, 260));
    const double calmest = random.uniform(300, 1100), width = random.uniform(120, 400);
    for (std::size_t slot = 0; slot < day.slots; ++slot) {
      const double off = (day.minute_of(slot) - calmest) / width;
      const double chance = std::round(50 * 0.98 * std::exp(-0.5 * off * off)) / 50;
      if (chance > 0) job.starts.push_back({slot, chance, hold, hold * 0.9});
    }
    day.jobs.push_back(std::move(job));
  }
  return day;
}

}  // namespace slackwater::tests
