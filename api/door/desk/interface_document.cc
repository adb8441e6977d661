#include "api/door/desk/interface_document.h"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "api/door/http/interface_words.h"

namespace slackwater::api::desk {
namespace {

using nlohmann::json;

using http::openapi::answer;
using http::openapi::list_of;
using http::openapi::object;
using http::openapi::operation;
using http::openapi::reference;
using http::openapi::refusals;
using http::openapi::refused_for;
using http::openapi::text;

struct Word {
  const char* name;
  const char* description;
  const char* example;
  bool is_many = false;
};

json in_query(const Word& word) {
  json schema = word.is_many ? list_of(text()) : text();
  json out{{"name", word.name},
           {"in", "query"},
           {"required", false},
           {"description", word.description},
           {"schema", std::move(schema)},
           {"example", word.is_many ? json::array({word.example}) : json(word.example)}};
  if (word.is_many) {
    out["style"] = "form";
    out["explode"] = false;
  }
  return out;
}

const std::vector<Word>& words_of_windows() {
  static const std::vector<Word> all{
      {"day", "Day D of the forecast; else the one in force", "2025-03-12"},
      {"task", "Tasks by id; else those of the site", "blade_scan", true},
      {"turbine", "Where; else the first that a task can be done at", "A01", true},
      {"from", "First start, UTC", "2025-03-14T06:00:00Z"},
      {"to", "Starts before this, UTC", "2025-03-14T18:00:00Z"},
      {"every", "From one start to the next", "30min"},
      {"contingency", "Beyond the planned time; else the task sheet's", "1h"},
      {"members", "Futures; else all that were issued", "25"},
      {"waves", "error: each future's waves err as forecasts do; forecast: none does", "error"},
      {"assume", "What no forecast serves", "visibility_m=5000", true},
      {"light", "sun_up, civil or nautical: the task is done in that light", "civil"},
      {"shift", "Hours in which the task is done; else the site's", "06:00-18:00"},
      {"timezone", "Of the shift; else the site's", "Europe/Paris"},
      {"alpha-from", "issue or start: from when the planned period of alpha counts", "issue"},
      {"go", "Probability of a start that is a go", "0.9"},
      {"marginal", "Probability of a marginal one", "0.5"}};
  return all;
}

json of_site(const std::vector<Word>& words) {
  json parameters = json::array({reference("parameters", "siteId")});
  for (const Word& word : words) parameters.push_back(in_query(word));
  return parameters;
}

/// What a command answers: its JSON is described with the command.
json answer_of(const char* id, const char* summary, const char* like,
               const std::vector<Word>& words, const char* schema = "Answer") {
  json responses = refusals({"404"});
  responses["200"] = answer(std::string("As `") + like + "`", reference("schemas", schema));
  return {{"get", operation(id, "Sites", summary, of_site(words), std::move(responses))}};
}

json report_page() {
  json responses = refusals({"404"});
  responses["200"] = {{"description", "One file, with style and script inside"},
                      {"content", {{"text/html", {{"schema", text()}}}}}};
  return {{"get", operation("get_report_page", "Sites", "The page of the report that was made last",
                            of_site({}), std::move(responses))}};
}

json guarded(json operation) { return http::openapi::for_operators(std::move(operation), "401"); }

json what_if() {
  json responses = refusals({"404"});
  responses["200"] = answer("The windows and the plan as they would be; nothing is saved",
                            reference("schemas", "WhatIfAnswer"));
  json post = guarded(operation("ask_what_if", "Sites", "The same questions with other texts",
                                of_site({}), std::move(responses)));
  post["requestBody"] = {
      {"required", true},
      {"content", {{"application/json", {{"schema", reference("schemas", "WhatIf")}}}}}};
  return {{"post", std::move(post)}};
}

json decision_path() {
  json path =
      answer_of("get_decisions", "What was decided, and what came", "slackwater decisions --json",
                {{"task", "Only of this one", "blade_scan"},
                 {"from", "Only starts from this day on", "2025-03-01"}});
  json responses = refusals({"404"});
  responses["201"] = answer("It is filed for good; as `slackwater decisions --json` has it",
                            reference("schemas", "Answer"));
  responses["409"] = refused_for(
      "Another forecast is in force than was looked at, or somebody decided meanwhile; nothing is "
      "filed");
  json post = guarded(operation("file_decision", "Sites",
                                "Files who decided what about a start, as `slackwater decide`",
                                of_site({}), std::move(responses)));
  post["requestBody"] = {
      {"required", true},
      {"content", {{"application/json", {{"schema", reference("schemas", "Decision")}}}}}};
  path["post"] = std::move(post);
  return path;
}

json mission_paths() {
  const json job = reference("schemas", "MissionJob");
  json listed = refusals();
  listed["200"] = answer("The rehearsals that are known", object({{"missions", list_of(job)}}));
  json taken = refusals();
  taken["202"] =
      answer("It waits its turn; Location says where it is told", object({{"id", text()}}));
  json one = refusals({"404"});
  one["200"] = answer("How it stands, and its result: as `slackwater rehearse --json`", job);
  json ended = refusals({"404"});
  ended["202"] = answer("It ends with the round that is flown", job);
  json submit = guarded(operation("submit_mission", "Missions",
                                  "Rehearses a mission in the futures of the forecast",
                                  json::array(), std::move(taken)));
  submit["requestBody"] = {
      {"required", true},
      {"content", {{"application/json", {{"schema", reference("schemas", "Mission")}}}}}};
  const json id = json::array({reference("parameters", "missionId")});
  return {{"/missions",
           {{"get", operation("list_missions", "Missions", "Rehearsals", json::array(),
                              std::move(listed))},
            {"post", std::move(submit)}}},
          {"/missions/{missionId}",
           {{"get", operation("get_mission", "Missions", "One rehearsal", id, std::move(one))}}},
          {"/missions/{missionId}/cancel",
           {{"post", guarded(operation("cancel_mission", "Missions", "Ends a rehearsal", id,
                                       std::move(ended)))}}}};
}

json paths() {
  const std::string at = "/sites/{siteId}";
  json listed = refusals();
  listed["200"] = answer("Every site and how its forecast is", reference("schemas", "Sites"));
  json out{
      {"/sites",
       {{"get", operation("list_sites", "Sites", "Sites", json::array(), std::move(listed))}}},
      {at,
       answer_of("get_site", "What lies at a site, and its chart datum", "a map of it has it", {})},
      {at + "/windows", answer_of("get_windows", "When tasks can be begun",
                                  "slackwater windows --json", words_of_windows())},
      {at + "/report", answer_of("get_report", "Go or no-go, today and tomorrow",
                                 "slackwater report --json", words_of_windows())},
      {at + "/report.html", report_page()},
      {at + "/plan", answer_of("get_plan", "What to do when", "slackwater plan --json",
                               {{"chance", "Take no start of a smaller probability", "0.5"},
                                {"time-limit", "Of the search, s; at most 20", "5"},
                                {"assume", "What no forecast serves", "visibility_m=5000", true}})},
      {at + "/verification",
       answer_of("get_verification", "How past forecasts did", "slackwater verify --json",
                 {{"from", "First day D", "2025-03-01"},
                  {"to", "Last day D", "2025-03-12"},
                  {"bands", "Edges of depth bands, m", "0,150"}},
                 "Skill")},
      {at + "/sources",
       answer_of("get_sources", "What a forecast would rest on", "slackwater site sources --json",
                 {{"day", "Day D; else the newest whole one", "2025-03-12"},
                  {"horizon", "Beyond the end of D", "72h"},
                  {"wind", "best, forecast or persist", "best"}})},
      {at + "/decisions", decision_path()},
      {at + "/workability",
       answer_of("get_workability", "How often one can work there",
                 "slackwater workability --site SITE --json",
                 {{"limit", "NAME<=VALUE UNIT", "sea_surface_wave_significant_height<=1.5", true},
                  {"duration", "That the task takes", "12h"},
                  {"contingency", "More that a window has to last", "1h"},
                  {"start-hours", "A task begins in these hours", "6-18"},
                  {"daylight", "sun_up, civil or nautical: it is done in that light", "civil"},
                  {"timezone", "Of the hours, months and years", "Europe/Paris"},
                  {"depth", "Of currents, m", "5"},
                  {"from", "First day", "2025-01-01"},
                  {"to", "Last day", "2025-03-12"}})},
      {at + "/climate",
       answer_of("get_climate", "Roses, scatter tables and extremes",
                 "slackwater climate --site SITE --json",
                 {{"what", "roses, scatter, extremes; else all", "roses", true},
                  {"of", "wind, waves, current; else what there is", "waves", true},
                  {"sectors", "Of roses", "12"},
                  {"return-period", "Years", "50", true},
                  {"depth", "Of currents, m", "5"},
                  {"from", "First day", "2025-01-01"},
                  {"to", "Last day", "2025-03-12"}})},
      {at + "/bed",
       answer_of("get_bed", "Depth contours around a site, as GeoJSON", "the page draws it", {})},
      {at + "/slack", answer_of("get_slack", "When the current is slack at a place and a depth",
                                "the forecast's page has it",
                                {{"depth", "m; default 5", "20"},
                                 {"below", "Likely speed, m/s; default 0.5", "0.5"},
                                 {"longitude", "Degrees; default the first column", "-2.55"},
                                 {"latitude", "Degrees; default the first column", "48.85"}})},
      {at + "/traffic",
       answer_of("get_traffic", "What vessels are about a site, with their closest approaches",
                 "slackwater ais FILE --site SITE --at TIME --json",
                 {{"at", "UTC; default the server's now. Nothing that was heard later is used",
                   "2025-03-14T06:00:00Z"}},
                 "Traffic")},
      {at + "/texts", answer_of("get_texts", "The YAML of site, tasks and plan",
                                "people wrote them", {}, "Texts")},
      {at + "/what-if", what_if()}};
  out.update(mission_paths());
  return out;
}

json path_parameter(const char* name, const char* description, const char* example) {
  return {{"name", name},     {"in", "path"},       {"required", true},
          {"schema", text()}, {"example", example}, {"description", description}};
}

json decision_schema() {
  json out = object({{"task", text()},
                     {"turbine", text()},
                     {"start", text()},
                     {"decided", {{"type", "string"}, {"enum", json::array({"go", "no_go"})}}},
                     {"by", text()},
                     {"note", text()},
                     {"hand_over", text()},
                     {"at", text()},
                     {"forecast", text()},
                     {"in_place_of", {{"type", "integer"}, {"nullable", true}}}});
  out["required"] = json::array({"task", "start", "decided", "by"});
  return out;
}

json nullable(json schema) {
  schema["nullable"] = true;
  return schema;
}
json real() { return {{"type", "number"}}; }

json traffic_schema() {
  const json place = object({{"longitude_deg", real()}, {"latitude_deg", real()}});
  const json passing{{"type", "string"}, {"enum", json::array({"closing", "past", "still"})}};
  const json approach = object({{"turbine", nullable(text())},
                                {"passing", passing},
                                {"cpa_m", real()},
                                {"tcpa_s", real()},
                                {"in_words", text()}});
  const json vessel = object(
      {{"mmsi", {{"type", "integer"}}},
       {"name", nullable(text())},
       {"kind", nullable(text())},
       {"length_m", nullable(real())},
       {"state", {{"type", "string"}, {"enum", json::array({"fresh", "old"})}}},
       {"longitude_deg", real()},
       {"latitude_deg", real()},
       {"dead_reckoned", {{"type", "boolean"}}},
       {"age_s", real()},
       {"speed_m_s", nullable(real())},
       {"to_direction_deg", nullable(real())},
       {"heading_deg", nullable(real())},
       {"distance_m", real()},
       {"bearing_deg", real()},
       {"ahead", nullable(place)},
       {"to_site", nullable(approach)},
       {"to_turbine", nullable(approach)},
       {"told", nullable(approach)},
       {"alarm", nullable({{"type", "string"}, {"enum", json::array({"closing", "inside"})}})}});
  return object({{"site", text()},
                 {"at", text()},
                 {"in_words", text()},
                 {"sources", list_of(object({{"file", text()}, {"trouble", nullable(text())}}))},
                 {"last_heard", nullable(text())},
                 {"limits", object({{"cpa_m", real()}, {"tcpa_s", real()}})},
                 {"rule", {{"type", "object"}}},
                 {"vessels", list_of(vessel)},
                 {"too_old", {{"type", "integer"}}},
                 {"left_out", {{"type", "integer"}}}});
}

json schemas() {
  const json texts = object({{"site", text()},
                             {"tasks", {{"type", "object"}, {"additionalProperties", text()}}},
                             {"plan", {{"type", "string"}, {"nullable", true}}}});
  return {{"Sites", object({{"now", text()}, {"sites", list_of({{"type", "object"}})}})},
          {"Answer", {{"type", "object"}}},
          {"Skill", list_of({{"type", "object"}})},
          {"Texts", texts},
          {"Traffic", traffic_schema()},
          {"WhatIf", object({{"texts", texts}, {"query", text()}})},
          {"Decision", decision_schema()},
          {"WhatIfAnswer", object({{"windows", {{"type", "object"}}},
                                   {"plan", {{"type", "object"}, {"nullable", true}}},
                                   {"no_plan", {{"type", "string"}, {"nullable", true}}}})},
          {"Mission", object({{"mission", text()},
                              {"starts", list_of(text())},
                              {"members", {{"type", "integer"}}}})},
          {"MissionJob",
           object({{"id", text()},
                   {"state",
                    {{"type", "string"},
                     {"enum", json::array({"waiting", "flying", "done", "cancelled", "failed"})}}},
                   {"share", {{"type", "number"}}},
                   {"why", {{"type", "string"}, {"nullable", true}}},
                   {"result", {{"type", "object"}, {"nullable", true}}}})}};
}

}  // namespace

json interface_document() {
  return {
      {"info",
       {{"description",
         "Forecasts of current, wind and waves for offshore sites over OGC API-EDR 1.1, beside "
         "stored products (product-KIND-ID) and what instruments measured "
         "(instrument-KIND-NAME: good values alone, at their own place, times and levels); what "
         "the commands answer about a site, as the same JSON; and rehearsals of missions. "
         "Nothing but a decision is written to the store. Decisions, and what costs cores "
         "(what-if, missions), are for this machine, and for who shows the token of "
         "--token-file."}}},
      {"paths", paths()},
      {"components",
       {{"parameters",
         {{"siteId", path_parameter("siteId", "A site, by its id in /sites", "saint_brieuc")},
          {"missionId",
           path_parameter("missionId", "A rehearsal, by its id", "0123456789abcdef")}}},
        {"schemas", schemas()},
        {"securitySchemes", http::openapi::operator_scheme()}}}};
}

}  // namespace slackwater::api::desk
