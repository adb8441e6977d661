#include "api/show/people/people_score_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "api/log/score.h"
#include "fields/base/numbers/statistics.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

template <typename T>
json maybe(const std::optional<T>& value) {
  return value ? json(*value) : json(nullptr);
}

/// Null: there were none.
json latencies_json(const std::vector<double>& values) {
  if (values.empty()) return nullptr;
  return {{"count", values.size()},
          {"median", median(values)},
          {"most", *std::max_element(values.begin(), values.end())}};
}

json spread_json(const std::vector<double>& values) {
  if (values.empty()) return nullptr;
  const Spread spread = spread_of(values);
  return {{"mean", spread.mean}, {"deviation", spread.deviation}, {"runs", spread.runs}};
}

/// What is counted of a limit; null where none is set.
json if_set(const std::optional<double>& limit, const json& value) {
  return limit ? value : json(nullptr);
}

json at_limits_json(const AtLimits& at) {
  return {{"nearest_structure_m", maybe(at.nearest_structure_m)},
          {"stand_off_m", maybe(at.stand_off_m)},
          {"stand_off_breaches", if_set(at.stand_off_m, at.stand_off_breaches)},
          {"inside_stand_off_s", if_set(at.stand_off_m, at.inside_stand_off_s)},
          {"near_stand_off_s", if_set(at.stand_off_m, at.near_stand_off_s)},
          {"fence_m", maybe(at.fence_m)},
          {"fence_breaches", if_set(at.fence_m, at.fence_breaches)},
          {"outside_fence_s", if_set(at.fence_m, at.outside_fence_s)},
          {"near_fence_s", if_set(at.fence_m, at.near_fence_s)},
          {"reserve_share", maybe(at.reserve_share)},
          {"below_reserve_s", if_set(at.reserve_share, at.below_reserve_s)},
          {"limits_broken", at.limits_broken},
          {"stopped_by", at.stopped_by.empty() ? json(nullptr) : json(at.stopped_by)}};
}

json helm_json(const HelmScore& helm, double ran_s, bool is_supervisor) {
  json holds = nullptr;
  if (is_supervisor && helm.hold_in_force_s) holds = latencies_json(*helm.hold_in_force_s);
  return {{"vehicle", helm.vehicle.empty() ? json(nullptr) : json(helm.vehicle)},
          {"asked_to_had_s", latencies_json(helm.asked_to_had_s)},
          {"asked_in_vain", helm.asked_in_vain},
          {"taken_over", helm.taken_over},
          {"hold_in_force_run_s", holds},
          {"turns", helm.turns},
          {"had_to_command_s", latencies_json(helm.had_to_command_s)},
          {"turns_without_command", helm.turns_without_command},
          {"links_lost", helm.links_lost},
          {"at_helm_run_s", helm.at_helm_s},
          {"share_of_run", ran_s > 0 ? json(helm.at_helm_s / ran_s) : json(nullptr)},
          {"commands", helm.commands},
          {"commands_per_minute", maybe(commands_per_minute(helm))},
          {"refused", helm.refused},
          {"refused_share", maybe(refused_share(helm))},
          {"refused_for", helm.refused_for},
          {"off_mission", helm.off_mission},
          {"off_helm", helm.off_helm},
          {"at_limits", helm.at_limits ? at_limits_json(*helm.at_limits) : json(nullptr)}};
}

json attention_json(const Attention& attention) {
  json on = json::array();
  for (const auto& [name, for_s] : attention.on_s)
    on.push_back({{"name", name.empty() ? json(nullptr) : json(name)}, {"for_s", for_s}});
  return {{"kept_s", attention.kept_s}, {"on", on}};
}

}  // namespace

json people_score_json(const PeopleScore& score) {
  if (score.people.empty()) return nullptr;
  json people = json::array();
  for (const PersonScore& person : score.people) {
    json vehicles = json::array();
    for (const HelmScore& helm : person.helms)
      vehicles.push_back(helm_json(helm, score.ran_s, person.role == "supervisor"));
    people.push_back(
        {{"seat", person.seat},
         {"name", person.name},
         {"role", person.role},
         {"vehicles", vehicles},
         {"attention", person.attention ? attention_json(*person.attention) : json(nullptr)}});
  }
  json stepped_in = json::object();
  for (const auto& [role, count] : score.by_role)
    stepped_in[role] = {{"off_mission", count.off_mission}, {"off_helm", count.off_helm}};
  return {{"ran_s", score.ran_s},
          {"positions_every_s", maybe(score.log_every_s)},
          {"seats", people},
          {"stepped_in", stepped_in}};
}

json people_over_runs_json(std::span<const PersonOverRuns> people) {
  json all = json::array();
  for (const PersonOverRuns& person : people)
    all.push_back({{"name", person.name},
                   {"role", person.role},
                   {"runs", person.runs},
                   {"asked_to_had_s", latencies_json(person.asked_to_had_s)},
                   {"asked_in_vain", person.asked_in_vain},
                   {"had_to_command_s", latencies_json(person.had_to_command_s)},
                   {"at_helm_run_s", spread_json(person.at_helm_s)},
                   {"share_of_run", spread_json(person.share_of_run)},
                   {"commands_per_minute", spread_json(person.commands_per_minute)},
                   {"refused_share", spread_json(person.refused_share)},
                   {"off_mission", spread_json(person.off_mission)},
                   {"off_helm", spread_json(person.off_helm)},
                   {"breaches", spread_json(person.breaches)},
                   {"near_limit_s", spread_json(person.near_limit_s)}});
  return all;
}

}  // namespace slackwater::api
