#include "twin/rehearse/adapt_intensity.h"

#include <algorithm>

#include "fields/base/error.h"
#include "fields/base/parallel.h"
#include "fields/base/text.h"
#include "twin/chance/rank_rule.h"
#include "twin/step/step_kernel.h"

namespace slackwater::twin {
namespace {

void check(const IntensityQuestion& question) {
  const std::vector<double>& ladder = question.densities;
  if (ladder.empty() || ladder.front() != 1)
    refuse("densities: expected them to begin with 1, the mission as it is");
  for (std::size_t i = 1; i < ladder.size(); ++i)
    if (!(ladder[i] < ladder[i - 1] && ladder[i] > 0))
      refuse(formatted("densities: found {:g} after {:g}, expected less, and more than 0",
                       ladder[i], ladder[i - 1]));
  if (!(question.keep_share > 0 && question.keep_share < 1))
    refuse(formatted("keep_share: found {:g}, expected between 0 and 1", question.keep_share));
  const std::size_t members = question.members.size();
  if (rank_needed(members, question.keep_share) > members)
    refuse(
        formatted("found {} futures; that the reserve is kept with a probability of {:g} takes "
                  "at least {} of them to show",
                  members, question.keep_share, members_needed(question.keep_share)));
}

double work_way_m(const ScenarioVehicle& vehicle) {
  double way_m = 0;
  Triple<double> before = vehicle.start_m;
  for (const ScenarioTask& task : vehicle.tasks)
    for (const Waypoint& at : task.waypoints) {
      if (task.phase == Phase::work) way_m += length_of(at.position_m - before);
      before = at.position_m;
    }
  return way_m;
}

/// Whether two missions lead the same ways.
bool leads_the_same(const Scenario& a, const Scenario& b) {
  const auto same_place = [](const Waypoint& p, const Waypoint& q) {
    return length_of(p.position_m - q.position_m) < 1e-6;
  };
  const auto same_task = [&](const ScenarioTask& s, const ScenarioTask& t) {
    return s.hold_s == t.hold_s && std::equal(s.waypoints.begin(), s.waypoints.end(),
                                              t.waypoints.begin(), t.waypoints.end(), same_place);
  };
  return std::equal(a.vehicles.begin(), a.vehicles.end(), b.vehicles.begin(), b.vehicles.end(),
                    [&](const ScenarioVehicle& v, const ScenarioVehicle& w) {
                      return std::equal(v.tasks.begin(), v.tasks.end(), w.tasks.begin(),
                                        w.tasks.end(), same_task);
                    });
}

double charge_left_of(const Flight& flight, const Scenario& mission,
                      const FlightSettings& settings) {
  double least = 1;
  for (std::size_t v = 0; v < flight.vehicles.size(); ++v)
    if (counts(mission.vehicles[v], settings))
      least = std::min(least, flight.vehicles[v].on_mission.charge);
  return least;
}

struct Rung {
  Intensity thinned_by;
  Scenario mission;
};

/// The plans that differ. Of one whose order alone differs from the one before, the former is left.
std::vector<Rung> rungs_of(const MissionThinned& mission, const IntensityQuestion& question) {
  std::vector<Rung> rungs;
  for (const double density : question.densities) {
    const Intensity by = density < 1 ? Intensity{density, question.order} : Intensity{};
    Rung rung{by, mission(by)};
    if (rungs.empty() || !leads_the_same(rungs.back().mission, rung.mission))
      rungs.push_back(std::move(rung));
  }
  return rungs;
}

TriedIntensity tried(const Rung& rung, const Scenario& fixed_plan, const Surround& given,
                     const IntensityQuestion& question) {
  const Surround surround = shared_by_flights(rung.mission, given);
  const std::size_t members = question.members.size();
  const std::size_t batches = (members + block_lanes - 1) / block_lanes;
  TriedIntensity out;
  out.thinned_by = rung.thinned_by;
  out.fates.resize(members);
  out.charge_left.resize(members);
  out.duration_s.resize(members);
  out.coverage.resize(members);
  for_all(batches, question.threads, [&](std::size_t batch) {
    const std::size_t first = batch * block_lanes;
    const std::size_t last = std::min(first + block_lanes, members);
    std::vector<FlightCase> cases;
    for (std::size_t i = first; i < last; ++i)
      cases.push_back({question.start, question.members[i]});
    const std::vector<Flight> flights = fly(rung.mission, surround, cases, question.flights);
    for (std::size_t i = first; i < last; ++i) {
      const Flight& flight = flights[i - first];
      out.fates[i] = reserve_fate(flight, rung.mission, question.flights);
      out.charge_left[i] = charge_left_of(flight, rung.mission, question.flights);
      out.duration_s[i] = flight.ended_s;
      out.coverage[i] = coverage_of(flight, rung.mission, fixed_plan, question.flights);
    }
  });
  return out;
}

std::string density_text(const TriedIntensity& one) {
  return one.thinned_by.density == 1 ? std::string("all passes")
                                     : formatted("density {:g}", one.thinned_by.density);
}

/// "4 called home by it, 1 not home".
std::string fates_text(const TriedIntensity& one) {
  std::vector<std::string> parts;
  for (const auto& [fate, words] : {std::pair{ReserveFate::called_home, "called home by it"},
                                    {ReserveFate::broken, "home with less"},
                                    {ReserveFate::not_home, "not home"}})
    if (const std::size_t flights = one.count(fate); flights > 0)
      parts.push_back(formatted("{} {}", flights, words));
  return parts.empty() ? "" : " (" + joined(parts, ", ") + ")";
}

std::string reason_of(const IntensityChoice& choice, std::size_t rungs) {
  const auto kept_text = [&](const TriedIntensity& one) {
    return formatted("{} of {} futures", one.kept(), choice.members) + fates_text(one);
  };
  const std::string needed = formatted("{} needed", choice.needed);
  if (!choice.chosen) {
    const TriedIntensity& last = choice.tried.back();
    return (rungs > 1 ? "no density keeps the reserve: do not fly. With "
                      : "the reserve is not kept, and there are no passes to leave out: do not "
                        "fly. With ") +
           density_text(last) + " it is kept in " + kept_text(last) + ", " + needed;
  }
  const TriedIntensity& taken = choice.tried[*choice.chosen];
  std::string text =
      density_text(taken) + ": the reserve is kept in " + kept_text(taken) + ", " + needed;
  if (*choice.chosen > 0) {
    const TriedIntensity& denser = choice.tried[*choice.chosen - 1];
    text += "; with " + density_text(denser) + " in " + kept_text(denser);
  }
  return text;
}

}  // namespace

std::size_t TriedIntensity::count(ReserveFate fate) const {
  return static_cast<std::size_t>(std::count(fates.begin(), fates.end(), fate));
}

double coverage_of(const Flight& flight, const Scenario& flown, const Scenario& fixed_plan,
                   const FlightSettings& settings) {
  double sum = 0;
  std::size_t vehicles = 0;
  for (std::size_t v = 0; v < flight.vehicles.size(); ++v) {
    if (!counts(flown.vehicles[v], settings)) continue;
    ++vehicles;
    if (const auto& inspection = flight.vehicles[v].inspection) {
      sum += inspection->share();
      continue;
    }
    const double whole_m = work_way_m(fixed_plan.vehicles[v]);
    const double planned = whole_m > 0 ? work_way_m(flown.vehicles[v]) / whole_m : 1;
    sum += planned * flight.vehicles[v].work_share();
  }
  return vehicles > 0 ? sum / static_cast<double>(vehicles) : 1;
}

IntensityChoice adapt_intensity(const MissionThinned& mission, const Surround& surround,
                                const IntensityQuestion& question) {
  check(question);
  const std::vector<Rung> rungs = rungs_of(mission, question);
  const Scenario& fixed_plan = rungs.front().mission;
  IntensityChoice choice;
  choice.members = question.members.size();
  choice.needed = rank_needed(choice.members, question.keep_share);
  std::vector<std::optional<TriedIntensity>> flown(rungs.size());
  const auto holds = [&](std::size_t rung) {
    if (!flown[rung]) flown[rung] = tried(rungs[rung], fixed_plan, surround, question);
    return flown[rung]->kept() >= choice.needed;
  };
  std::optional<std::size_t> chosen;
  if (holds(0)) {
    chosen = 0;
  } else if (holds(rungs.size() - 1)) {
    std::size_t fails = 0, keeps = rungs.size() - 1;
    while (keeps - fails > 1) {
      const std::size_t middle = fails + (keeps - fails) / 2;
      (holds(middle) ? keeps : fails) = middle;
    }
    chosen = keeps;
  }
  for (std::size_t rung = 0; rung < rungs.size(); ++rung) {
    if (!flown[rung]) continue;
    if (chosen == rung) choice.chosen = choice.tried.size();
    choice.tried.push_back(std::move(*flown[rung]));
  }
  choice.reason = reason_of(choice, rungs.size());
  return choice;
}

}  // namespace slackwater::twin
