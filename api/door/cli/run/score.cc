#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "api/door/cli/command.h"
#include "api/log/score.h"
#include "api/show/people/people_score_json.h"
#include "api/show/people/people_score_text.h"
#include "api/show/rehearse/account_json.h"
#include "api/show/rehearse/detections_report.h"
#include "fields/base/text.h"
#include "ingest/apart/read_tracks_apart.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

double coverage_of(const twin::VehicleAccount& v) {
  return v.inspection ? v.inspection->share() : 0;
}

/// A vehicle of a run that lasted `ran_s`.
struct Scored {
  const twin::VehicleAccount& vehicle;
  double ran_s = 0;

  [[nodiscard]] twin::Interventions away() const {
    return twin::interventions_of(vehicle.mission, ran_s);
  }
};

/// What is compared over runs, by vehicle.
const std::map<std::string, double (*)(const Scored&)>& pooled() {
  static const std::map<std::string, double (*)(const Scored&)> all{
      {"time_s", [](const Scored& s) { return scored_time_s(s.vehicle); }},
      {"rms_across_track_m", [](const Scored& s) { return s.vehicle.at_work.rms_across_m; }},
      {"energy_per_metre_j",
       [](const Scored& s) { return energy_per_metre_j(s.vehicle).value_or(0); }},
      {"interventions", [](const Scored& s) { return static_cast<double>(s.away().count); }},
      {"takeover_s", [](const Scored& s) { return s.away().away_s; }},
      {"coverage", [](const Scored& s) { return coverage_of(s.vehicle); }},
      {"done", [](const Scored& s) { return is_scored_done(s.vehicle, s.ran_s) ? 1.0 : 0.0; }}};
  return all;
}

/// Of the runs in which something was to be seen; null: of none.
json pooled_seen_json(const std::vector<Scored>& scores) {
  std::vector<double> values;
  for (const Scored& score : scores)
    if (const std::optional<bool> is_seen = score.vehicle.is_seen())
      values.push_back(*is_seen ? 1 : 0);
  if (values.empty()) return nullptr;
  const Spread spread = spread_of(values);
  return {{"mean", spread.mean}, {"deviation", spread.deviation}};
}

json pooled_json(const std::vector<Scorecard>& cards) {
  std::map<std::string, std::vector<Scored>> by_name;
  for (const Scorecard& card : cards)
    for (const twin::VehicleAccount& vehicle : card.account.vehicles)
      by_name[vehicle.name].push_back({vehicle, card.account.ran_s});
  json out = json::array();
  for (const auto& [name, scores] : by_name) {
    json vehicle = {{"name", name}, {"runs", scores.size()}};
    for (const auto& [key, of] : pooled()) {
      std::vector<double> values;
      for (const Scored& score : scores) values.push_back(of(score));
      const Spread spread = spread_of(values);
      vehicle[key] = {{"mean", spread.mean}, {"deviation", spread.deviation}};
    }
    vehicle["seen"] = pooled_seen_json(scores);
    out.push_back(std::move(vehicle));
  }
  return out;
}

std::vector<PersonOverRuns> people_of(const std::vector<Scorecard>& cards) {
  std::vector<PeopleScore> runs;
  runs.reserve(cards.size());
  for (const Scorecard& card : cards) runs.push_back(card.people);
  return people_over_runs(runs);
}

void print_people(const std::vector<Scorecard>& cards) {
  for (const Scorecard& card : cards)
    std::fputs(people_score_text(card.run, card.people).c_str(), stdout);
  if (cards.size() < 2) return;
  const std::string table = people_over_runs_text(people_of(cards));
  if (!table.empty())
    std::printf("People over runs: mean (standard deviation) of those in which they were\n%s",
                table.c_str());
}

std::string one_decimal(const std::optional<double>& value) {
  return value ? formatted("{:.1f}", *value) : "-";
}

std::string metres(const std::optional<twin::Approach>& near) {
  return near ? one_decimal(near->distance_m) : "-";
}

/// Done is not seen.
const char* seen_cell(const twin::VehicleAccount& vehicle) {
  const std::optional<bool> is_seen = vehicle.is_seen();
  return !is_seen ? "-" : *is_seen ? "yes" : "no";
}

void print_cards(const std::vector<Scorecard>& cards) {
  std::printf("%-24s %-12s %5s %5s %8s %9s %8s %9s %8s %8s %8s %6s %9s %7s\n", "run", "vehicle",
              "done", "seen", "time s", "sailed m", "off m", "J per m", "pile m", "other m",
              "ship m", "away", "for s", "limits");
  for (const Scorecard& card : cards)
    for (const twin::VehicleAccount& v : card.account.vehicles) {
      const twin::Interventions away = twin::interventions_of(v.mission, card.account.ran_s);
      std::printf("%-24s %-12s %5s %5s %8.0f %9.1f %8.2f %9s %8s %8s %8s %6zu %9.0f %7zu\n",
                  card.run.substr(0, 24).c_str(), v.name.c_str(),
                  is_scored_done(v, card.account.ran_s) ? "yes" : "no", seen_cell(v),
                  scored_time_s(v), v.at_work.sailed_m, v.at_work.rms_across_m,
                  one_decimal(energy_per_metre_j(v)).c_str(), metres(v.closest.structure).c_str(),
                  metres(v.closest.vehicle).c_str(), metres(v.closest.vessel).c_str(), away.count,
                  away.away_s, away.limit_violations);
    }
  for (const Scorecard& card : cards)
    for (const twin::VehicleAccount& v : card.account.vehicles) {
      if (!v.inspection) continue;
      const twin::DetectionScore& score = v.inspection->score;
      std::printf("%s, %s: %.0f %% of %.0f m2 covered; %zu found, %zu missed, %zu false alarms\n",
                  card.run.c_str(), v.name.c_str(), 100 * v.inspection->share(),
                  v.inspection->area_m2(), score.all.found, score.missed(), score.all.false_alarms);
    }
  for (const Scorecard& card : cards)
    for (std::size_t i = 0; i < card.account.vehicles.size(); ++i) {
      const std::string whose = card.run + ", " + card.account.vehicles[i].name;
      std::fputs(detections_text(card.detectors, i, whose).c_str(), stdout);
    }
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
  cards.reserve(logs.size());
  for (const std::filesystem::path& log : logs)
    cards.push_back(
        with_context(log.string(), [&] { return scorecard_of(ingest::read_tracks_apart(log)); }));
  if (!context.json) {
    print_cards(cards);
    print_people(cards);
    return;
  }
  json out = {{"runs", json::array()}, {"vehicles", pooled_json(cards)}};
  const std::vector<PersonOverRuns> people = people_of(cards);
  if (!people.empty()) out["people"] = people_over_runs_json(people);
  for (std::size_t i = 0; i < cards.size(); ++i) {
    json vehicles = json::array();
    const twin::RunAccount& account = cards[i].account;
    for (std::size_t v = 0; v < account.vehicles.size(); ++v) {
      vehicles.push_back(score_json(account.vehicles[v], account.ran_s));
      vehicles.back()["detectors"] = detections_json(cards[i].detectors, v);
    }
    out["runs"].push_back({{"log", logs[i].string()},
                           {"run", cards[i].run},
                           {"seed", cards[i].seed},
                           {"vehicles", vehicles}});
    if (!cards[i].people.people.empty())
      out["runs"].back()["people"] = people_score_json(cards[i].people);
  }
  std::printf("%s\n", out.dump(2, ' ', false, json::error_handler_t::replace).c_str());
}

}  // namespace

void add_score(CLI::App& app, Context& context) {
  auto logs = std::make_shared<std::vector<std::filesystem::path>>();
  CLI::App* command =
      app.add_subcommand("score", "The scorecard of logged runs, whatever steered their vehicles");
  command->add_option("logs", *logs, "FILE.nc of `simulate`, `live --out` or `rehearse --log`")
      ->required()
      ->expected(1, 10000);
  command->callback([logs, &context] { run_score(*logs, context); });
}

}  // namespace slackwater::api
