#include "api/show/traffic/traffic_json.h"

#include <nlohmann/json.hpp>

#include "api/show/traffic/traffic_words.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

template <typename Value>
json or_null(const std::optional<Value>& value) {
  return value ? json(*value) : json(nullptr);
}
json time_or_null(const std::optional<UtcTime>& time) {
  return time ? json(format_utc(*time)) : json(nullptr);
}
json degrees_or_null(const std::optional<Angle>& angle) {
  return angle ? json(angle->degrees()) : json(nullptr);
}
json place_json(const GeoPoint& place) {
  return {{"longitude_deg", place.longitude_deg()}, {"latitude_deg", place.latitude_deg()}};
}
double seconds(Duration duration) { return std::chrono::duration<double>(duration).count(); }

const char* name_of(Passing passing) {
  switch (passing) {
    case Passing::closing:
      return "closing";
    case Passing::past:
      return "past";
    case Passing::still:
      break;
  }
  return "still";
}

json approach_json(const std::optional<Approach>& approach) {
  if (!approach) return nullptr;
  return {{"turbine", approach->to.empty() ? json(nullptr) : json(approach->to)},
          {"passing", name_of(approach->passing)},
          {"cpa_m", approach->distance_m},
          {"tcpa_s", approach->time_s},
          {"in_words", approach_words(*approach)}};
}

json alarm_json(TrafficAlarm alarm) {
  if (alarm == TrafficAlarm::none) return nullptr;
  return alarm == TrafficAlarm::inside ? "inside" : "closing";
}

json vessel_json(const VesselThere& there) {
  const ingest::AisIdentity& identity = there.heard.identity;
  const ingest::AisPosition& position = there.heard.position;
  const std::string kind(identity.ship_type ? ingest::kind_of_ship_type(*identity.ship_type) : "");
  json out = place_json(there.place);
  out["mmsi"] = there.heard.mmsi;
  out["name"] = or_null(identity.name);
  out["class"] = std::string(ingest::name_of(there.heard.speaker));
  out["kind"] = kind.empty() ? json(nullptr) : json(kind);
  out["ship_type"] = or_null(identity.ship_type);
  out["length_m"] = or_null(identity.length_m);
  out["beam_m"] = or_null(identity.beam_m);
  out["state"] = there.is_fresh ? "fresh" : "old";
  out["reported"] = place_json(position.point);
  out["reported"]["time"] = format_utc(position.time);
  out["age_s"] = seconds(there.age);
  out["dead_reckoned"] = there.is_carried_on;
  out["speed_m_s"] = or_null(position.speed_over_ground_m_s);
  out["to_direction_deg"] = degrees_or_null(position.course_over_ground);
  out["heading_deg"] = degrees_or_null(position.heading);
  out["distance_m"] = there.distance_m;
  out["bearing_deg"] = there.bearing_deg;
  out["ahead"] = there.ahead ? place_json(*there.ahead) : json(nullptr);
  out["to_site"] = approach_json(there.to_site);
  out["to_turbine"] = approach_json(there.to_turbine);
  out["told"] = approach_json(there.told);
  out["alarm"] = alarm_json(there.alarm);
  return out;
}

}  // namespace

json traffic_json(const TrafficQuestion& question, const TrafficHeard& heard,
                  const TrafficAnswer& answer) {
  const TrafficRule& rule = question.rule;
  json sources = json::array(), vessels = json::array();
  for (const TrafficSource& source : heard.sources)
    sources.push_back({{"file", source.file},
                       {"trouble", source.trouble.empty() ? json(nullptr) : json(source.trouble)}});
  for (const VesselThere& there : answer.vessels) vessels.push_back(vessel_json(there));
  return {{"site", question.site},
          {"at", format_utc(question.at)},
          {"place", place_json(question.place)},
          {"in_words", traffic_in_words(question, heard, answer)},
          {"sources", std::move(sources)},
          {"last_heard", time_or_null(heard.last)},
          {"limits", {{"cpa_m", rule.alarm.distance_m}, {"tcpa_s", rule.alarm.time_s}}},
          {"rule",
           {{"reach_m", rule.reach_m},
            {"fresh_under_way_s", seconds(rule.fresh_under_way)},
            {"fresh_at_rest_s", seconds(rule.fresh_at_rest)},
            {"shown_s", seconds(rule.shown)},
            {"way_s", seconds(rule.way)}}},
          {"vessels", std::move(vessels)},
          {"too_old", answer.too_old},
          {"left_out", answer.left_out}};
}

}  // namespace slackwater::api
