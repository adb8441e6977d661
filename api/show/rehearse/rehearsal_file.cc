#include "api/show/rehearse/rehearsal_file.h"

#include <algorithm>
#include <cmath>

#include "api/program/version.h"
#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/scenario/write_scenario.h"

namespace slackwater::api {
namespace {

using ingest::TrajectoryFile;
using ingest::TrajectoryTable;
using twin::Flight;
using twin::FlightSample;

constexpr double none = constants::nan;

TrajectoryTable flight_table(const Rehearsal& rehearsal) {
  TrajectoryTable table;
  table.name = "flight";
  TrajectoryTable::Column start{"start", "s", "since the first start", {}};
  TrajectoryTable::Column member{"member", "1", "of the forecast", {}};
  TrajectoryTable::Column done{"done", "1", "1: by all whose work counts", {}};
  TrajectoryTable::Column seen{
      "seen", "1", "1: its inspections covered what is asked; none: nothing is asked", {}};
  TrajectoryTable::Column ended{"ended", "s", "since its start", {}};
  TrajectoryTable::TextColumn cause{"stopped_by", "why it was not done", {}};
  TrajectoryTable::TextColumn unseen{"unseen_by", "why it saw too little", {}};
  for (const StartOutcome& outcome : rehearsal.starts)
    for (const Flight& flight : outcome.flights) {
      start.values.push_back(seconds_between(rehearsal.starts.front().start, outcome.start));
      member.values.push_back(static_cast<double>(flight.flown.member));
      done.values.push_back(flight.is_done ? 1 : 0);
      seen.values.push_back(flight.is_seen ? (*flight.is_seen ? 1 : 0) : none);
      ended.values.push_back(flight.ended_s);
      cause.values.push_back(flight.stopped_by);
      unseen.values.push_back(flight.unseen_by);
    }
  table.columns = {std::move(start), std::move(member), std::move(done), std::move(seen),
                   std::move(ended)};
  table.texts = {std::move(cause), std::move(unseen)};
  return table;
}

struct Kept {
  const char* name;
  const char* units;
  const char* long_name;
  double (*of)(const FlightSample&);
};
constexpr Kept kept[] = {
    {"x", "m", "east of the origin", [](const FlightSample& s) { return double{s.east_m}; }},
    {"y", "m", "north of the origin", [](const FlightSample& s) { return double{s.north_m}; }},
    {"z", "m", "up from mean sea level", [](const FlightSample& s) { return -double{s.down_m}; }},
    {"state_of_charge", "1", "of the battery",
     [](const FlightSample& s) { return double{s.charge}; }},
    {"charge_needed", "1", "for the way home, its margin and the reserve",
     [](const FlightSample& s) { return double{s.needed}; }},
    {"current_speed", "m s-1", "at the vehicle",
     [](const FlightSample& s) { return double{s.current_m_s}; }},
    {"wind_speed", "m s-1", "mean, at the vehicle, at 10 m at least",
     [](const FlightSample& s) { return double{s.wind_m_s}; }},
    {"significant_wave_height", "m", "of the sea",
     [](const FlightSample& s) { return double{s.wave_height_m}; }},
    {"phase", "1", "0 transit, 1 launch, 2 work, 3 recovery, 4 return",
     [](const FlightSample& s) { return static_cast<double>(s.phase); }},
    {"doing", "1", "0 its task, 1 holding, 2 on the way back to it, 3 on the way home",
     [](const FlightSample& s) { return static_cast<double>(s.doing); }},
};

}  // namespace

TrajectoryFile rehearsal_file(const LoadedMission& mission, const RehearsalPlan& plan,
                              const Rehearsal& rehearsal) {
  TrajectoryFile file;
  file.epoch = rehearsal.starts.front().start;
  std::size_t times = 0;
  std::vector<const std::vector<FlightSample>*> tracks;
  for (const StartOutcome& outcome : rehearsal.starts)
    for (const Flight& flight : outcome.flights)
      for (std::size_t v = 0; v < flight.samples.size(); ++v) {
        tracks.push_back(&flight.samples[v]);
        times = std::max(times, flight.samples[v].size());
        file.names.push_back(flight.vehicles[v].name + " " +
                             format_utc(outcome.start).substr(0, 16) +
                             formatted("Z #{}", flight.flown.member));
      }
  for (std::size_t t = 0; t < times; ++t)
    file.t_s.push_back(plan.flights.sample_every_s * static_cast<double>(t));
  for (const Kept& quantity : kept) {
    TrajectoryFile::Variable variable{quantity.name, "", quantity.units, quantity.long_name, 1, {}};
    for (const auto* track : tracks)
      for (std::size_t t = 0; t < times; ++t)
        variable.values.push_back(t < track->size() ? quantity.of((*track)[t]) : none);
    file.variables.push_back(std::move(variable));
  }
  file.attributes = {{"title", "Rehearsal: " + mission.name},
                     {"source", "slackwater " + code_version()},
                     {"time_is", "since the start of each flight"},
                     {"forecast", mission.water.forecast_name},
                     {"forecast_sha256", mission.water.forecast_sha256},
                     {"seed", std::to_string(mission.scenario.seed)},
                     {"scenario", mission.scenario.yaml}};
  file.tables.push_back(flight_table(rehearsal));
  return file;
}

twin::Scenario scenario_of_flight(const twin::Scenario& mission, const twin::FlightCase& flown) {
  twin::Scenario scenario = mission;
  scenario.seed = twin::seed_of(mission.seed, flown);
  scenario.start = flown.start;
  scenario.member = std::holds_alternative<twin::MadeUpWater>(mission.water) ? 0 : flown.member;
  scenario.yaml = twin::write_scenario(scenario);
  return scenario;
}

}  // namespace slackwater::api
