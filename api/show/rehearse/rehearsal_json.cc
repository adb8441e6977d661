#include "api/show/rehearse/rehearsal_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "api/ask/rehearse/risks.h"
#include "api/ask/rehearse/unchecked.h"
#include "api/json/plot_json.h"
#include "api/log/account_tables.h"
#include "api/show/rehearse/advice_report.h"
#include "api/show/rehearse/cleaning_report.h"
#include "api/show/rehearse/inspection_report.h"
#include "api/show/rehearse/risk_report.h"
#include "fields/base/numbers/quantile.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

/// How near a vehicle came to what was around it, over all flights of a start; null where there was
/// nothing of a kind in any.
json closest_json(const StartOutcome& start, std::size_t vehicle) {
  json out = json::object();
  bool any = false;
  for (const ApproachKind& kind : approach_kinds()) {
    std::vector<double> distance_m;
    for (const twin::Flight& flight : start.flights)
      if (const auto& near = flight.vehicles[vehicle].closest.*kind.of)
        distance_m.push_back(near->distance_m);
    any |= !distance_m.empty();
    out[kind.name] = distance_m.empty() ? json(nullptr) : quantiles_json(distance_m);
  }
  return any ? out : json(nullptr);
}

/// In how many flights a vehicle that keeps clear raised an alarm.
json alarmed_json(const StartOutcome& start, std::size_t vehicle) {
  if (!start.flights.front().vehicles[vehicle].clearance) return nullptr;
  return std::count_if(start.flights.begin(), start.flights.end(), [&](const twin::Flight& f) {
    const auto& clearance = f.vehicles[vehicle].clearance;
    return clearance && clearance->alarms() > 0;
  });
}

/// In how many flights its inspection covered what is asked; null where nothing is.
json seen_json(const StartOutcome& start, std::size_t vehicle) {
  if (!start.flights.front().vehicles[vehicle].is_seen()) return nullptr;
  return std::count_if(start.flights.begin(), start.flights.end(), [&](const twin::Flight& f) {
    return f.vehicles[vehicle].is_seen() == true;
  });
}

/// Of one vehicle over all flights of a start.
json vehicle_json(const StartOutcome& start, std::size_t vehicle) {
  std::vector<double> left, energy_wh, fuel_kg, held_s, worst, thrust, line;
  std::size_t done = 0;
  for (const twin::Flight& flight : start.flights) {
    const twin::VehicleAccount& v = flight.vehicles[vehicle];
    done += v.is_done ? 1 : 0;
    left.push_back(v.least_charge);
    energy_wh.push_back(v.on_mission.drawn_j / 3600);
    fuel_kg.push_back(v.on_mission.fuel_kg);
    held_s.push_back(v.held_s);
    worst.push_back(v.worst_share);
    thrust.push_back(1 - v.thrust_used);
    line.push_back(v.line_used > 0 ? 1 - v.line_used : std::nan(""));
  }
  return {{"name", start.flights.front().vehicles[vehicle].name},
          {"done", done},
          {"seen", seen_json(start, vehicle)},
          {"least_state_of_charge", quantiles_json(left)},
          {"energy_wh", quantiles_json(energy_wh)},
          {"fuel_kg", quantiles_json(fuel_kg)},
          {"held_s", quantiles_json(held_s)},
          {"most_of_a_limit", quantiles_json(worst)},
          {"thrust_margin", quantiles_json(thrust)},
          {"tether_margin", quantiles_json(line)},
          {"cleaning", cleaning_json(start, vehicle)},
          {"inspection", inspection_json(start, vehicle)},
          {"closest_m", closest_json(start, vehicle)},
          {"flights_with_clearance_alarms", alarmed_json(start, vehicle)}};
}

json flight_json(const twin::Flight& flight) {
  json out{{"member", flight.flown.member},
           {"done", flight.is_done},
           {"stopped_by", flight.is_done ? json(nullptr) : json(flight.stopped_by)},
           {"seen", flight.is_seen ? json(*flight.is_seen) : json(nullptr)},
           {"unseen_by", flight.unseen_by.empty() ? json(nullptr) : json(flight.unseen_by)},
           {"ended_s", number(flight.ended_s)}};
  if (flight.found_s) out["found_s"] = number(*flight.found_s);
  if (const auto& noise = flight.noise)
    out["noise"] = {{"made_s", number(noise->noise_s)},
                    {"stops", number(noise->stops)},
                    {"mammal_within_s", number(noise->exposed_s)},
                    {"by", noise->by.empty() ? json(nullptr) : json(noise->by)}};
  for (const twin::VehicleAccount& vehicle : flight.vehicles) {
    if (vehicle.cleaning) out["cleaned_share"][vehicle.name] = number(vehicle.cleaning->share());
    if (vehicle.inspection)
      out["covered_share"][vehicle.name] = number(vehicle.inspection->share());
  }
  return out;
}

json causes_json(const std::vector<StoppedBy>& causes) {
  json out = json::array();
  for (const StoppedBy& cause : causes)
    out.push_back({{"cause", cause.cause}, {"flights", cause.flights}});
  return out;
}

/// P(done), P(seen): of how many flights, and the bounds.
json count_json(const FlightCount& count) {
  return {{"flights", count.flights},
          {"probability", number(count.share())},
          {"interval_95", {number(count.low), number(count.high)}}};
}

json start_json(const StartOutcome& start, const std::vector<twin::Consequence>& consequences) {
  std::vector<double> duration_s;
  for (const twin::Flight& flight : start.flights)
    if (flight.is_done) duration_s.push_back(flight.ended_s);
  json vehicles = json::array();
  json flights = json::array();
  if (!start.flights.empty())
    for (std::size_t v = 0; v < start.flights.front().vehicles.size(); ++v)
      vehicles.push_back(vehicle_json(start, v));
  for (const twin::Flight& flight : start.flights) flights.push_back(flight_json(flight));
  const twin::LimitsSay& limits = start.by_the_limits;
  const std::string disagreement = disagreement_of(start);
  return {{"start", format_utc(start.start)},
          {"flights", start.flights.size()},
          {"done", start.done.flights},
          {"seen", start.seen ? json(start.seen->flights) : json(nullptr)},
          {"succeeded", start.success.flights},
          {"probability", number(start.success.share())},
          {"interval_95", {number(start.success.low), number(start.success.high)}},
          {"p_done", count_json(start.done)},
          {"p_seen", start.seen ? count_json(*start.seen) : json(nullptr)},
          {"narrow_enough", start.is_narrow},
          {"by_the_limits",
           {{"allows", limits.allows},
            {"binding", limits.binding.empty() ? json(nullptr) : json(limits.binding)},
            {"share", number(limits.share)}}},
          {"disagreement", disagreement.empty() ? json(nullptr) : json(disagreement)},
          {"forbidden", start.forbidden.empty() ? json(nullptr) : json(start.forbidden)},
          {"stopped_by", causes_json(start.stopped_by)},
          {"unseen_by", causes_json(start.unseen_by)},
          {"duration_s", quantiles_json(duration_s)},
          {"vehicles", vehicles},
          {"risks", risks_json(risks_of(start, consequences))},
          {"members", flights},
          {"verdict", verdict_of(start)}};
}

std::string clock_text(UtcTime time) { return format_utc(time).substr(0, 16) + "Z"; }

/// "22 of 24".
std::string count_text(std::size_t done, std::size_t flights) {
  return formatted("{} of {}", done, flights);
}

std::string bounds_text(const FlightCount& count) {
  return formatted("{:.0f} to {:.0f} %", 100 * count.low, 100 * count.high);
}

std::string first_text(const std::vector<StoppedBy>& causes, std::size_t flights) {
  return causes.front().cause + formatted(" ({})", count_text(causes.front().flights, flights));
}

/// With most flights that are no success.
std::string what_is_wrong(const StartOutcome& start) {
  const std::size_t stopped = start.done.of - start.done.flights;
  const std::size_t unseen = start.seen ? start.seen->of - start.seen->flights : 0;
  if (unseen > stopped)
    return "most flights do not see what is asked: " + start.unseen_by.front().cause;
  return "the flights are stopped by " +
         (start.stopped_by.empty() ? std::string("time") : start.stopped_by.front().cause);
}

}  // namespace

json quantiles_json(const std::vector<double>& values) {
  json out = json::object();
  for (const auto& [name, share] : {std::pair{"p10", 0.1}, {"p50", 0.5}, {"p90", 0.9}}) {
    const auto value = quantile_of(values, share);
    out[name] = value ? number(*value) : json(nullptr);
  }
  return out;
}

std::string verdict_of(const StartOutcome& start) {
  if (!start.forbidden.empty())
    return clock_text(start.start) + ": not to be flown, " + start.forbidden + ".";
  const std::size_t flights = start.flights.size();
  std::string text =
      clock_text(start.start) + ": done in " + count_text(start.done.flights, flights) + " futures";
  // Done is not seen: where fewer have seen what they were to see, that is said beside it.
  if (start.seen)
    text += (start.seen->flights < start.done.flights ? " but seen in only " : ", seen in ") +
            count_text(start.seen->flights, flights);
  text += "; P(done) " + bounds_text(start.done);
  if (start.seen) text += ", P(seen) " + bounds_text(*start.seen);
  if (!start.stopped_by.empty()) text += "; stopped by " + first_text(start.stopped_by, flights);
  if (!start.unseen_by.empty()) text += "; not seen: " + first_text(start.unseen_by, flights);
  return text + ".";
}

std::string verdict_of(const Rehearsal& rehearsal) {
  const auto best = std::max_element(rehearsal.starts.begin(), rehearsal.starts.end(),
                                     [](const StartOutcome& a, const StartOutcome& b) {
                                       return a.success.share() < b.success.share();
                                     });
  if (best == rehearsal.starts.end()) return "Nothing was flown.";
  return (rehearsal.starts.size() > 1 ? "Best start " : "") + verdict_of(*best);
}

std::string disagreement_of(const StartOutcome& start) {
  if (start.flights.empty()) return "";
  const double share = start.done.share();
  if (start.by_the_limits.allows && start.success.share() < 0.5)
    return "The limits allow it (" +
           (start.by_the_limits.binding.empty() ? std::string("none is near")
                                                : start.by_the_limits.binding) +
           "), but " + what_is_wrong(start) + ".";
  if (!start.by_the_limits.allows && share >= 0.5)
    return "The limits forbid it (" + start.by_the_limits.binding +
           "), but most flights are done: the vehicle holds, or is elsewhere, while the limit is "
           "exceeded.";
  return "";
}

json rehearsal_json(const LoadedMission& mission, const RehearsalPlan& plan,
                    const Rehearsal& rehearsal, const std::vector<Advice>& advice) {
  const Unchecked unchecked = unchecked_of(mission.scenario);
  json starts = json::array();
  for (const StartOutcome& start : rehearsal.starts)
    starts.push_back(start_json(start, mission.consequences));
  return {
      {"mission", mission.name},
      {"tasks", mission.expanded.tasks},
      {"turbines", mission.expanded.turbines},
      {"site", mission.site},
      {"forecast", mission.water.forecast_name},
      {"forecast_sha256",
       mission.water.forecast_sha256.empty() ? json(nullptr) : json(mission.water.forecast_sha256)},
      {"seed", mission.scenario.seed},
      {"members", plan.members},
      {"members_issued", mission.water.members_issued},
      {"narrow_enough", plan.narrow_enough > 0 ? json(plan.narrow_enough) : json(nullptr)},
      {"not_checked", unchecked.not_checked},
      {"assumed", unchecked.assumed},
      {"warnings", mission.water.warnings},
      {"wall_s", number(rehearsal.wall_s)},
      {"first_answer_s", number(rehearsal.first_answer_s)},
      {"verdict", verdict_of(rehearsal)},
      {"starts", starts},
      {"advice", advice_json(advice)}};
}

}  // namespace slackwater::api
