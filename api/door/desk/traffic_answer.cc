#include "api/door/desk/traffic_answer.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "api/door/desk/asked_words.h"
#include "api/door/desk/site_list.h"
#include "api/show/traffic/traffic_json.h"

namespace slackwater::api::desk {
namespace {

/// A site that nobody describes lies where its forecast does.
void fill_place(const std::string& id, const IssuedFields& forecasts,
                const std::filesystem::path& store_folder, TrafficQuestion& question) {
  try {
    const Site site = described_site(id, store_folder);
    question.place = site.point;
    question.turbines = site.turbines;
  } catch (const Error&) {
    const auto catalogue = forecasts.catalogue();
    const auto found = std::find_if(catalogue->sites.begin(), catalogue->sites.end(),
                                    [&](const auto& site) { return site.site_id == id; });
    if (found == catalogue->sites.end()) throw;
    question.place = found->field->snapshot().columns.front().point;
  }
}

}  // namespace

nlohmann::json traffic_answer(const Listening& listening, const IssuedFields& forecasts,
                              const Freshness& freshness, const std::filesystem::path& store_folder,
                              const std::string& site, const std::string& query) {
  const AskedWords words(query, {"at"});
  TrafficQuestion question;
  question.site = site;
  const UtcTime now = std::chrono::floor<std::chrono::seconds>(freshness.now());
  question.at = words.read_one("at", parse_utc).value_or(now);
  question.rule = listening.rule;
  fill_place(site, forecasts, store_folder, question);
  // A server whose clock is set back may have a log of what comes: that is not known yet.
  const UtcTime known = std::min(question.at, now);
  const TrafficHeard heard = listening.logs ? listening.logs->heard(known) : TrafficHeard{};
  return traffic_json(question, heard, traffic_about(question, heard));
}

}  // namespace slackwater::api::desk
