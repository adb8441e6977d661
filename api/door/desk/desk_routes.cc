#include "api/door/desk/desk_routes.h"

#include <nlohmann/json.hpp>

#include "api/door/desk/bed_answer.h"
#include "api/door/desk/decision_record.h"
#include "api/door/desk/history_answers.h"
#include "api/door/desk/kept_answers.h"
#include "api/door/desk/mission_jobs.h"
#include "api/door/desk/report_page.h"
#include "api/door/desk/site_answers.h"
#include "api/door/desk/site_list.h"
#include "api/door/desk/slack_answer.h"
#include "api/door/desk/texts_of_site.h"
#include "api/door/desk/what_if.h"
#include "fields/base/error.h"

namespace slackwater::api::desk {
namespace {

using http::LongWork;
using http::Outcome;
using http::PathParameters;
using http::Request;
using http::Response;
using nlohmann::json;

/// A forecast may be replaced within seconds.
constexpr int answer_max_age_s = 10;
constexpr int traffic_max_age_s = 1;  // ships move

Response json_response(const json& body) {
  Response response;
  response.media_type = "application/json";
  response.body = body.dump(-1, ' ', false, json::error_handler_t::replace);
  response.max_age_s = answer_max_age_s;
  return response;
}

Response not_kept(const json& body, int status = 200) {
  Response response = json_response(body);
  response.status = status;
  response.max_age_s.reset();
  return response;
}

MissionAsked mission_asked(const std::string& body) {
  const json asked = json::parse(body, nullptr, false);
  const auto unlike = [] {
    return Error(ErrorKind::usage,
                 R"(found a body that is something else, expected {"mission": YAML}, and perhaps )"
                 R"("starts": [TIME] and "members": 1 to 1000)");
  };
  if (!asked.is_object() || !asked.contains("mission")) throw unlike();
  MissionAsked mission;
  for (const auto& [name, value] : asked.items()) {
    if (name == "mission" && value.is_string()) {
      mission.mission = value.get<std::string>();
    } else if (name == "members" && value.is_number_unsigned() && value >= 1 && value <= 1000) {
      mission.members = value.get<std::size_t>();
    } else if (name == "starts" && value.is_array() && value.size() <= 100) {
      for (const json& start : value) {
        if (!start.is_string()) throw unlike();
        mission.starts.push_back(start.get<std::string>());
      }
    } else {
      throw unlike();
    }
  }
  return mission;
}

void add_mission_routes(http::Router& router, const std::shared_ptr<MissionJobs>& jobs) {
  router.add("GET", "/missions", [jobs](const Request&) { return not_kept(jobs->jobs()); });
  router.add("POST", "/missions", [jobs](const Request& request) {
    const std::string id = jobs->submit(mission_asked(request.body));
    Response response = not_kept({{"id", id}}, 202);
    response.headers.emplace_back("Location", "/missions/" + id);
    return response;
  });
  router.add("GET", "/missions/{mission}",
             [jobs](const Request&, const PathParameters& path) -> Outcome {
               return not_kept(jobs->job(path.at("mission")));
             });
  router.add("POST", "/missions/{mission}/cancel",
             [jobs](const Request&, const PathParameters& path) -> Outcome {
               return not_kept(jobs->cancel(path.at("mission")), 202);
             });
}

}  // namespace

void add_routes(http::Router& router, const DeskSettings& settings) {
  const auto kept = std::make_shared<KeptAnswers>(settings.store_folder, settings.data_folder,
                                                  settings.freshness.now);
  Answers from;
  from.store_folder = settings.store_folder;
  from.data_folder = settings.data_folder;
  from.now = settings.freshness.now;
  from.by_clock = settings.by_clock;
  const auto add = [&](const std::string& what, auto answer) {
    router.add("GET", "/sites/{site}/" + what,
               [=](const Request& request, const PathParameters& path) -> Outcome {
                 const std::string question = request.path + '?' + request.query;
                 return LongWork{[=, site = path.at("site"), query = request.query] {
                   return kept->answer(question,
                                       [&] { return json_response(answer(from, site, query)); });
                 }};
               });
  };
  add("windows", windows_answer);
  add("report", report_answer);
  add("plan", plan_answer);
  add("verification", verification_answer);
  add("sources", sources_answer);
  add("decisions", decisions_answer);
  add("workability", workability_answer);
  add("climate", climate_answer);
  add("bed", bed_answer);
  const auto described = std::make_shared<KeptSites>(settings.store_folder);
  router.add("GET", "/sites", [settings, described](const Request&) {
    return json_response(sites_json(*settings.forecasts, settings.freshness, *described));
  });
  router.add("GET", "/sites/{site}",
             [settings, described](const Request&, const PathParameters& path) -> Outcome {
               return json_response(
                   site_json(path.at("site"), *settings.forecasts, settings.freshness, *described));
             });
  router.add(
      "GET", "/sites/{site}/slack",
      [settings](const Request& request, const PathParameters& path) -> Outcome {
        return json_response(slack_answer(*settings.forecasts, path.at("site"), request.query));
      });
  router.add("GET", "/sites/{site}/traffic",
             [settings](const Request& request, const PathParameters& path) -> Outcome {
               Response response = json_response(
                   traffic_answer(settings.listening, *settings.forecasts, settings.freshness,
                                  settings.store_folder, path.at("site"), request.query));
               response.max_age_s = traffic_max_age_s;
               return response;
             });
  router.add("GET", "/sites/{site}/report.html",
             [settings](const Request&, const PathParameters& path) -> Outcome {
               return report_page(path.at("site"), settings.store_folder, settings.freshness.now());
             });
  router.add("GET", "/sites/{site}/texts",
             [from](const Request&, const PathParameters& path) -> Outcome {
               return json_response(texts_json(texts_of_site(path.at("site"), from.store_folder)));
             });
  router.add("POST", "/sites/{site}/what-if",
             [from](const Request& request, const PathParameters& path) -> Outcome {
               return LongWork{[from, site = path.at("site"), body = request.body] {
                 return not_kept(what_if(from, site, body));
               }};
             });
  const auto record = std::make_shared<DecisionRecord>(from);
  router.add("POST", "/sites/{site}/decisions",
             [record, kept](const Request& request, const PathParameters& path) -> Outcome {
               return LongWork{[record, kept, site = path.at("site"), body = request.body] {
                 Response response = record->file(site, body);
                 kept->forget();
                 return response;
               }};
             });
  add_mission_routes(router,
                     std::make_shared<MissionJobs>(settings.store_folder, settings.data_folder,
                                                   settings.missions_at_once));
}

}  // namespace slackwater::api::desk
