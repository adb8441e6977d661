#include "api/show/rehearse/account_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "api/log/account_tables.h"
#include "api/log/score.h"
#include "api/show/rehearse/cleaning_report.h"
#include "api/show/rehearse/inspection_report.h"
#include "api/show/rehearse/manoeuvre_report.h"
#include "fields/base/constants.h"

namespace slackwater::api {
namespace {

using nlohmann::json;
using twin::VehicleAccount;

json maybe(const std::optional<double>& value) { return value ? json(*value) : json(nullptr); }

json only_if(bool is_there, double value) { return is_there ? json(value) : json(nullptr); }

json name_or_null(const std::string& name) { return name.empty() ? json(nullptr) : json(name); }

json fate_json(const VehicleAccount& vehicle) {
  json events = json::array();
  for (const twin::FateEvent& event : vehicle.fate)
    events.push_back({{"what", words_of(event.what)}, {"at_s", maybe(event.at_s)}});
  return events;
}

json approach_json(const std::optional<twin::Approach>& approach) {
  if (!approach) return nullptr;
  json out{{"distance_m", approach->distance_m},
           {"at_s", approach->t_s},
           {"name", name_or_null(approach->to)}};
  if (approach->mmsi != 0) out["mmsi"] = approach->mmsi;
  return out;
}

json closest_json(const twin::Closest& closest) {
  if (closest == twin::Closest{}) return nullptr;
  json out;
  for (const ApproachKind& kind : approach_kinds())
    out[kind.name] = approach_json(closest.*kind.of);
  return out;
}

json clearance_json(const std::optional<twin::ClearanceAccount>& clearance) {
  if (!clearance) return nullptr;
  json from = json::object();
  for (std::size_t c = 0; c < twin::alarm_causes; ++c)
    from[twin::name_of(static_cast<twin::AlarmCause>(c))] = clearance->alarms_from[c];
  return {
      {"alarms", clearance->alarms()}, {"alarms_from", from}, {"changed_s", clearance->changed_s}};
}

json manoeuvres_json(const VehicleAccount& vehicle) {
  json all = json::array();
  for (const twin::ManoeuvreAccount& one : vehicle.manoeuvres) all.push_back(manoeuvre_json(one));
  return all;
}

json distance_json(const std::optional<twin::Approach>& approach) {
  return approach ? json(approach->distance_m) : json(nullptr);
}

}  // namespace

json account_json(const VehicleAccount& v, UtcTime start) {
  const twin::Makeup& makeup = v.makeup;
  const twin::TrackAccount& track = v.track;
  const std::string fate = v.fate_text(start);
  return {
      {"name", v.name},
      {"model", v.model},
      {"sailed_m", track.sailed_m},
      {"energy_wh", only_if(makeup.is_electric, v.in_all.drawn_j / 3600)},
      {"state_of_charge", only_if(makeup.has_battery, v.in_all.charge)},
      {"least_voltage_v", makeup.has_battery ? maybe(track.least_voltage_v) : json(nullptr)},
      {"fuel_kg", only_if(makeup.burns_fuel, v.in_all.fuel_kg)},
      {"rms_across_track_m", track.rms_across_m},
      {"rms_depth_error_m", only_if(!makeup.floats, track.rms_depth_error_m)},
      {"largest_depth_error_m", only_if(!makeup.floats, magnitude_of(track.depth_error_m))},
      {"largest_roll_deg", v.largest_roll_rad * 180 / constants::pi},
      {"largest_pitch_deg", v.largest_pitch_rad * 180 / constants::pi},
      {"waypoints", v.waypoints},
      {"tasks_done", v.tasks_done},
      {"tasks", v.tasks},
      {"navigation", makeup.by_sensors ? "sensors" : "truth"},
      {"navigation_error_m", makeup.by_sensors ? maybe(track.navigation_error_m) : json(nullptr)},
      {"rms_navigation_error_m",
       makeup.by_sensors ? maybe(track.rms_navigation_error_m) : json(nullptr)},
      {"cleaning", v.cleaning ? cleaning_json(*v.cleaning) : json(nullptr)},
      {"inspection", v.inspection ? inspection_json(*v.inspection) : json(nullptr)},
      {"manoeuvres", manoeuvres_json(v)},
      {"fate", name_or_null(fate)},
      {"events", fate_json(v)},
      {"closest", closest_json(v.closest)},
      {"clearance", clearance_json(v.clearance)},
      {"halt", name_of(v.halt)},
      {"halted_at_s", only_if(v.halt != twin::Halt::none, v.halted_at_s)}};
}

json score_json(const VehicleAccount& v, double ran_s) {
  const twin::Interventions away = twin::interventions_of(v.mission, ran_s);
  json findings;
  if (v.inspection)
    findings = {{"found", v.inspection->score.all.found},
                {"missed", v.inspection->score.missed()},
                {"false_alarms", v.inspection->score.all.false_alarms}};
  return {{"name", v.name},
          {"done", is_scored_done(v, ran_s)},
          {"seen", v.is_seen() ? json(*v.is_seen()) : json(nullptr)},
          {"time_s", scored_time_s(v)},
          {"sailed_m", v.at_work.sailed_m},
          {"rms_across_track_m", v.at_work.rms_across_m},
          {"largest_across_track_m", magnitude_of(v.at_work.across_m)},
          {"rms_depth_error_m", v.at_work.rms_depth_error_m},
          {"energy_per_metre_j", maybe(energy_per_metre_j(v))},
          {"closest_structure_m", distance_json(v.closest.structure)},
          {"closest_vehicle_m", distance_json(v.closest.vehicle)},
          {"closest_vessel_m", distance_json(v.closest.vessel)},
          {"closest_tether_m", distance_json(v.closest.tether)},
          {"interventions", away.count},
          {"takeover_s", away.away_s},
          {"longest_takeover_s", away.longest_away_s},
          {"limit_violations", away.limit_violations},
          {"coverage", v.inspection ? json(v.inspection->share()) : json(nullptr)},
          {"findings", findings}};
}

}  // namespace slackwater::api
