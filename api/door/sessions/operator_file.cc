#include "api/door/sessions/operator_file.h"

#include <algorithm>

#include "api/ask/rehearse/mission_file.h"
#include "api/program/secret_file.h"
#include "fields/base/config.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::sessions {
namespace {

using std::filesystem::path;

constexpr std::size_t longest_id = 40;
constexpr int most_ever_at_once = 16;

bool is_letter_or_digit(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// It becomes part of addresses and of names of files.
std::string read_id(const Config& entry) {
  std::string id = entry.text("id");
  const bool is_plain =
      std::all_of(id.begin(), id.end(), [](char c) { return is_letter_or_digit(c) || c == '-'; });
  if (id.empty() || id.size() > longest_id || !is_plain || !is_letter_or_digit(id[0]))
    entry.refuse("id", formatted("found '{}', expected 1 to {} letters, digits and '-', the first "
                                 "one no '-'",
                                 id, longest_id));
  return id;
}

twin::Scenario scenario_of(const Offer& offer, const path& store_folder) {
  if (!offer.is_mission) return twin::read_scenario(offer.file);
  const path folder = std::filesystem::absolute(offer.file).parent_path();
  return api::lay_out_mission(Config::load(offer.file), folder, store_folder, {}).scenario;
}

Offer read_offer(const Config& entry, const path& folder, const path& store_folder) {
  Offer offer;
  offer.id = read_id(entry);
  const auto scenario = entry.optional_text("scenario"), mission = entry.optional_text("mission");
  if (scenario.has_value() == mission.has_value())
    entry.refuse(
        mission ? "mission" : "id",
        formatted("found {} of scenario and mission, expected one: the file of what is run",
                  mission ? "both" : "neither"));
  offer.is_mission = mission.has_value();
  offer.file = folder / (mission ? *mission : *scenario);
  offer.real_time_factor =
      entry.optional_number("real_time_factor", {0, 1e6}).value_or(offer.real_time_factor);
  if (offer.real_time_factor != 0 && offer.real_time_factor < 0.1)
    entry.refuse("real_time_factor",
                 formatted("found {:g}, expected 0 (as fast as it goes) or 0.1 and more",
                           offer.real_time_factor));
  const std::string begins = entry.optional_text("begins").value_or("by_supervisor");
  if (begins != "by_supervisor" && begins != "at_start")
    entry.refuse("begins", "found '" + begins + "', expected by_supervisor or at_start");
  offer.begins_at_start = begins == "at_start";
  try {
    offer.name = scenario_of(offer, store_folder).name;
  } catch (const Error& problem) {
    entry.refuse(offer.is_mission ? "mission" : "scenario", problem.message());
  }
  return offer;
}

path read_logs(const Config& config, const path& folder) {
  const auto logs = config.optional_text("logs");
  if (!logs) return {};
  if (!std::filesystem::is_directory(folder / *logs))
    config.refuse("logs", "found no folder " + (folder / *logs).string() +
                              ", expected one that exists; make it first");
  return folder / *logs;
}

/// Rules between keys.
void expect_sense(const Config& config, const OperatorFile& read) {
  const auto at_start = static_cast<std::size_t>(std::count_if(
      read.offers.begin(), read.offers.end(), [](const Offer& o) { return o.begins_at_start; }));
  if (at_start > read.most_at_once)
    config.refuse("sessions", formatted("found {} that begin at_start, expected {} at most: "
                                        "most_at_once",
                                        at_start, read.most_at_once));
  const auto& grants = read.people.grants();
  const bool has_supervisor = std::any_of(grants.begin(), grants.end(), [](const auto& grant) {
    return grant.role == people::Role::supervises;
  });
  if (at_start < read.offers.size() && !has_supervisor)
    config.refuse("people",
                  "found no supervisor, expected one: no one else begins a session whose begins is "
                  "by_supervisor");
}

}  // namespace

OperatorFile read_operator_file(const path& file, const path& store_folder) {
  api::expect_secret(file);
  const Config config = Config::load(file);
  const path folder = std::filesystem::absolute(file).parent_path();
  OperatorFile read;
  for (const Config& entry : config.children("sessions")) {
    Offer offer = read_offer(entry, folder, store_folder);
    const auto is_same = [&](const Offer& other) { return other.id == offer.id; };
    if (std::any_of(read.offers.begin(), read.offers.end(), is_same))
      entry.refuse("id", "'" + offer.id + "' stands twice; each session needs its own");
    read.offers.push_back(std::move(offer));
  }
  if (read.offers.empty())
    config.refuse("sessions", "found none, expected a list of {id, scenario}");
  if (const auto most = config.optional_integer("most_at_once", 1, most_ever_at_once))
    read.most_at_once = static_cast<std::size_t>(*most);
  read.logs = read_logs(config, folder);
  read.people = people::TokenBook::read(config);
  config.expect_all_read();
  expect_sense(config, read);
  return read;
}

api::ScenarioAtHand at_hand(const Offer& offer, const path& store_folder) {
  if (!offer.is_mission) return api::scenario_at_hand(offer.file, store_folder);
  api::LoadedMission mission = api::load_mission(offer.file, store_folder, {}, {});
  return {std::move(mission.scenario), std::move(mission.water)};
}

}  // namespace slackwater::sessions
