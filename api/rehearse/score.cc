#include "api/rehearse/score.h"

#include <algorithm>
#include <cmath>

#include "api/rehearse/closest.h"
#include "api/rehearse/mission_events.h"
#include "api/rehearse/run_outcome.h"
#include "api/rehearse/vehicle_log.h"
#include "fields/base/error.h"

namespace slackwater::api {
namespace {

using ingest::TrajectoryFile;

double rms_of(const VehicleLog& vehicle, const char* name) {
  double squares = 0, count = 0;
  for (std::size_t t = 0; t < vehicle.rows(); ++t) {
    const double value = vehicle.at(name, t);
    if (!std::isfinite(value)) continue;
    squares += value * value;
    ++count;
  }
  return count > 0 ? std::sqrt(squares / count) : 0;
}

double sailed_m(const VehicleLog& vehicle) {
  double sum_m = 0;
  for (std::size_t t = vehicle.first() + 1; t < vehicle.rows(); ++t)
    sum_m += twin::length_of(vehicle.place_m(t) - vehicle.place_m(t - 1));
  return sum_m;
}

/// What a vehicle was called away from its task for, by its log.
void count_interventions(const std::vector<MissionEvent>& events, std::size_t vehicle, double end_s,
                         VehicleScore& score) {
  std::optional<double> away_since_s;
  const auto come_back = [&](double t_s) {
    if (!away_since_s) return;
    const double away_s = t_s - *away_since_s;
    score.takeover_s += away_s;
    score.longest_takeover_s = std::max(score.longest_takeover_s, away_s);
    away_since_s.reset();
  };
  for (const MissionEvent& event : events) {
    if (event.vehicle != vehicle) continue;
    if (event.kind == "hold_began" || event.kind == "turned_for_home") {
      ++score.interventions;
      if (event.cause == "limit") ++score.limit_violations;
      if (!away_since_s) away_since_s = event.t_s;
    } else if (event.kind == "resumed") {
      come_back(event.t_s);
    } else if (event.kind == "finished" || event.kind == "gave_up") {
      come_back(event.t_s);
      score.time_s = event.t_s;
      score.is_done = event.kind == "finished" && event.cause == "none";
    }
  }
  come_back(end_s);
}

std::optional<double> distance_m(const std::optional<Approach>& approach) {
  return approach ? std::optional(approach->distance_m) : std::nullopt;
}

}  // namespace

Scorecard scorecard_of(const TrajectoryFile& log) {
  if (log.find("x") == nullptr || log.find("y") == nullptr || log.find("z") == nullptr ||
      log.t_s.empty())
    throw Error(ErrorKind::invalid_input,
                "the log holds no x, y and z over time; give one that `slackwater simulate` or "
                "`rehearse --log` wrote");
  Scorecard card{log.attribute("title"), log.attribute("seed"), {}};
  const std::optional<twin::Scenario> scenario = scenario_of(log);
  const std::vector<MissionEvent> events = mission_events_in(log);
  std::vector<VehicleLog> vehicles;
  for (std::size_t i = 0; i < log.names.size(); ++i) vehicles.emplace_back(log, i);
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    VehicleScore score;
    score.name = log.names[i];
    score.time_s = log.t_s[vehicles[i].rows() - 1];
    count_interventions(events, i, log.t_s.back(), score);
    // What it does when its work is over, hovering where others still work, is not scored.
    const VehicleLog vehicle(log, i, score.time_s);
    score.time_s -= log.t_s[vehicle.first()] - log.t_s.front();
    score.sailed_m = sailed_m(vehicle);
    score.rms_across_track_m = rms_of(vehicle, "across_track");
    if (const auto largest = vehicle.largest("across_track"))
      score.largest_across_track_m = std::abs(largest->value);
    score.rms_depth_error_m = rms_of(vehicle, "below_track");
    if (const double drawn = vehicle.last("electrical_energy"); drawn > 0 && score.sailed_m > 1)
      score.energy_per_metre_j = drawn / score.sailed_m;
    const Closest closest = closest_in(log, vehicles, i, scenario ? &*scenario : nullptr);
    score.closest_structure_m = distance_m(closest.structure);
    score.closest_vehicle_m = distance_m(closest.vehicle);
    score.closest_vessel_m = distance_m(closest.vessel);
    score.closest_tether_m = distance_m(closest.tether);
    score.inspection = inspection_in(log, i);
    card.vehicles.push_back(score);
  }
  return card;
}

Spread spread_of(const std::vector<double>& values) {
  Spread spread;
  spread.runs = values.size();
  for (const double value : values) spread.mean += value / static_cast<double>(values.size());
  double squares = 0;
  for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
  if (values.size() > 1)
    spread.deviation = std::sqrt(squares / static_cast<double>(values.size() - 1));
  return spread;
}

}  // namespace slackwater::api
