#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "api/cli/command.h"
#include "api/rehearse/score.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

json maybe(const std::optional<double>& value) { return value ? json(*value) : json(nullptr); }

json findings_json(const std::optional<LoggedInspection>& inspection) {
  if (!inspection) return nullptr;
  return {{"found", inspection->found},
          {"missed", inspection->missed},
          {"false_alarms", inspection->false_alarms}};
}

json score_json(const VehicleScore& s) {
  return {{"name", s.name},
          {"done", s.is_done},
          {"time_s", s.time_s},
          {"sailed_m", s.sailed_m},
          {"rms_across_track_m", s.rms_across_track_m},
          {"largest_across_track_m", s.largest_across_track_m},
          {"rms_depth_error_m", s.rms_depth_error_m},
          {"energy_per_metre_j", maybe(s.energy_per_metre_j)},
          {"closest_structure_m", maybe(s.closest_structure_m)},
          {"closest_vehicle_m", maybe(s.closest_vehicle_m)},
          {"closest_vessel_m", maybe(s.closest_vessel_m)},
          {"closest_tether_m", maybe(s.closest_tether_m)},
          {"interventions", s.interventions},
          {"takeover_s", s.takeover_s},
          {"longest_takeover_s", s.longest_takeover_s},
          {"limit_violations", s.limit_violations},
          {"coverage", s.inspection ? json(s.inspection->share()) : json(nullptr)},
          {"findings", findings_json(s.inspection)}};
}

/// What is compared over runs, by vehicle.
const std::map<std::string, double (*)(const VehicleScore&)>& pooled() {
  static const std::map<std::string, double (*)(const VehicleScore&)> all{
      {"time_s", [](const VehicleScore& s) { return s.time_s; }},
      {"rms_across_track_m", [](const VehicleScore& s) { return s.rms_across_track_m; }},
      {"energy_per_metre_j",
       [](const VehicleScore& s) { return s.energy_per_metre_j.value_or(0); }},
      {"interventions", [](const VehicleScore& s) { return static_cast<double>(s.interventions); }},
      {"takeover_s", [](const VehicleScore& s) { return s.takeover_s; }},
      {"coverage", [](const VehicleScore& s) { return s.inspection ? s.inspection->share() : 0; }},
      {"done", [](const VehicleScore& s) { return s.is_done ? 1.0 : 0.0; }}};
  return all;
}

json pooled_json(const std::vector<Scorecard>& cards) {
  std::map<std::string, std::vector<const VehicleScore*>> by_name;
  for (const Scorecard& card : cards)
    for (const VehicleScore& score : card.vehicles) by_name[score.name].push_back(&score);
  json out = json::array();
  for (const auto& [name, scores] : by_name) {
    json vehicle = {{"name", name}, {"runs", scores.size()}};
    for (const auto& [key, of] : pooled()) {
      std::vector<double> values;
      for (const VehicleScore* score : scores) values.push_back(of(*score));
      const Spread spread = spread_of(values);
      vehicle[key] = {{"mean", spread.mean}, {"deviation", spread.deviation}};
    }
    out.push_back(std::move(vehicle));
  }
  return out;
}

std::string metres(const std::optional<double>& value) {
  return value ? formatted("{:.1f}", *value) : "-";
}

void print_cards(const std::vector<Scorecard>& cards) {
  std::printf("%-24s %-12s %5s %8s %9s %8s %9s %8s %8s %8s %6s %9s %7s\n", "run", "vehicle", "done",
              "time s", "sailed m", "off m", "J per m", "pile m", "other m", "ship m", "away",
              "for s", "limits");
  for (const Scorecard& card : cards)
    for (const VehicleScore& s : card.vehicles)
      std::printf("%-24s %-12s %5s %8.0f %9.1f %8.2f %9s %8s %8s %8s %6zu %9.0f %7zu\n",
                  card.run.substr(0, 24).c_str(), s.name.c_str(), s.is_done ? "yes" : "no",
                  s.time_s, s.sailed_m, s.rms_across_track_m, metres(s.energy_per_metre_j).c_str(),
                  metres(s.closest_structure_m).c_str(), metres(s.closest_vehicle_m).c_str(),
                  metres(s.closest_vessel_m).c_str(), s.interventions, s.takeover_s,
                  s.limit_violations);
  for (const Scorecard& card : cards)
    for (const VehicleScore& s : card.vehicles)
      if (s.inspection)
        std::printf("%s, %s: %.0f %% of %.0f m2 covered; %zu found, %zu missed, %zu false alarms\n",
                    card.run.c_str(), s.name.c_str(), 100 * s.inspection->share(),
                    s.inspection->area_m2, s.inspection->found, s.inspection->missed,
                    s.inspection->false_alarms);
  if (cards.size() < 2) return;
  for (const json& vehicle : pooled_json(cards))
    std::printf(
        "%s over %zu runs: time %.0f s (%.0f), off track %.2f m (%.2f), %.1f J/m (%.1f), "
        "away %.1f times for %.0f s\n",
        vehicle["name"].get<std::string>().c_str(), vehicle["runs"].get<std::size_t>(),
        vehicle["time_s"]["mean"].get<double>(), vehicle["time_s"]["deviation"].get<double>(),
        vehicle["rms_across_track_m"]["mean"].get<double>(),
        vehicle["rms_across_track_m"]["deviation"].get<double>(),
        vehicle["energy_per_metre_j"]["mean"].get<double>(),
        vehicle["energy_per_metre_j"]["deviation"].get<double>(),
        vehicle["interventions"]["mean"].get<double>(),
        vehicle["takeover_s"]["mean"].get<double>());
}

void run_score(const std::vector<std::filesystem::path>& logs, const Context& context) {
  std::vector<Scorecard> cards;
  for (const std::filesystem::path& log : logs)
    cards.push_back(
        with_context(log.string(), [&] { return scorecard_of(ingest::read_trajectories(log)); }));
  if (!context.json) {
    print_cards(cards);
    return;
  }
  json out = {{"runs", json::array()}, {"vehicles", pooled_json(cards)}};
  for (std::size_t i = 0; i < cards.size(); ++i) {
    json vehicles = json::array();
    for (const VehicleScore& score : cards[i].vehicles) vehicles.push_back(score_json(score));
    out["runs"].push_back({{"log", logs[i].string()},
                           {"run", cards[i].run},
                           {"seed", cards[i].seed},
                           {"vehicles", vehicles}});
  }
  std::printf("%s\n", out.dump(2, ' ', false, json::error_handler_t::replace).c_str());
}

}  // namespace

void add_score(CLI::App& app, Context& context) {
  auto logs = std::make_shared<std::vector<std::filesystem::path>>();
  CLI::App* command =
      app.add_subcommand("score", "The scorecard of logged runs, whatever steered their vehicles");
  command->add_option("logs", *logs, "FILE.nc of `simulate` or `rehearse --log`")
      ->required()
      ->expected(1, 10000);
  command->callback([logs, &context] { run_score(*logs, context); });
}

}  // namespace slackwater::api
