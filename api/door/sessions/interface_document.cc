#include "api/door/sessions/interface_document.h"

#include <nlohmann/json.hpp>
#include <string>

#include "api/door/http/interface_words.h"

namespace slackwater::sessions {
namespace {

using nlohmann::json;

namespace openapi = api::http::openapi;
using openapi::answer;
using openapi::list_of;
using openapi::object;
using openapi::reference;
using openapi::refusals;
using openapi::refused_for;
using openapi::text;
using openapi::whole;

json answer_of(const std::string& description, const std::string& schema) {
  return answer(description, reference("schemas", schema));
}

json with_token(json responses) {
  responses["401"] = refused_for("No token of these people, or one that has ended");
  return responses;
}

json operation(const std::string& id, const std::string& summary, json responses) {
  return openapi::operation(id, "Sessions", summary, json::array(), std::move(responses));
}

json of_session(json operation) {
  operation["parameters"] = json::array({reference("parameters", "sessionId")});
  return operation;
}

/// Whoever asks shows a token in its Authorization field.
json guarded(json operation) {
  operation["security"] = json::array({{{"people", json::array()}}});
  return operation;
}

json list_and_begin() {
  json listed = refusals();
  listed["200"] = answer_of("The sessions, and what may be begun", "Sessions");
  json begun = with_token(refusals({"404"}));
  begun["201"] = answer_of("It has begun; Location says where", "BegunSession");
  begun["403"] = refused_for("Sessions are begun by supervisors, and by no page of another origin");
  begun["409"] = refused_for("As many are under way as may be at once");
  begun["415"] = refused_for("The body is no application/json");
  json begin = guarded(operation("begin_session", "Begins a live session; of supervisors", begun));
  begin["requestBody"] = {
      {"required", true},
      {"content", {{"application/json", {{"schema", reference("schemas", "SessionToBegin")}}}}}};
  return {{"get", operation("get_sessions", "Live sessions, and what may be begun", listed)},
          {"post", begin}};
}

json of_one(json responses) {
  responses["410"] = refused_for("Its run is over");
  return with_token(std::move(responses));
}

json paths() {
  json one = refusals({"404"});
  one["200"] = answer_of("The session", "Session");
  json checked = of_one(refusals({"404"}));
  checked["204"] = {{"description", "The token opens a seat now"}};
  checked["409"] = refused_for("All seats of the token are taken");
  json record = of_one(refusals({"404"}));
  record["200"] = answer_of("What was done and refused, in order", "SessionActions");
  json ended = with_token(refusals({"404"}));
  ended["202"] = answer_of("It ends, and its log is written", "BegunSession");
  ended["403"] = refused_for("Sessions are ended by supervisors, and by no page of another origin");
  json socket = of_one(refusals({"404"}));
  socket["101"] = {{"description", "WebSocket, slackwater.session.v1: api/docs/session_wire.md"}};
  socket["403"] = refused_for("A page of another origin");
  socket["409"] = refused_for("All seats of the token are taken");
  socket["426"] = refused_for("The path speaks WebSocket");
  const std::string at = "/sessions/{sessionId}";
  const auto get = [](const char* id, const char* summary, const json& responses) {
    return of_session(operation(id, summary, responses));
  };
  return {
      {"/sessions", list_and_begin()},
      {at, {{"get", get("get_session", "One live session", one)}}},
      {at + "/check",
       {{"get", guarded(get("check_token", "Whether a token opens a seat", checked))}}},
      {at + "/actions",
       {{"get", guarded(get("get_session_actions", "The record of a session", record))}}},
      {at + "/socket", {{"get", get("open_session_socket", "Where people take part", socket)}}},
      {at + "/end",
       {{"post",
         guarded(of_session(operation("end_session", "Ends a session; of supervisors", ended)))}}}};
}

json schemas() {
  return {{"Session", object({{"id", text()},
                              {"of", text()},
                              {"name", text()},
                              {"state", text()},
                              {"why", text()},
                              {"seats", whole()},
                              {"begun", {{"type", "string"}, {"format", "date-time"}}}})},
          {"Sessions", object({{"sessions", list_of(reference("schemas", "Session"))},
                               {"may_begin", list_of(object({{"id", text()}, {"name", text()}}))},
                               {"under_way", whole()},
                               {"most_at_once", whole()}})},
          {"SessionToBegin", object({{"begin", text()}})},
          {"BegunSession", object({{"id", text()}, {"state", text()}})},
          {"SessionActions", object({{"actions", list_of({{"type", "object"}})}})}};
}

}  // namespace

json interface_document() {
  const json id{{"name", "sessionId"}, {"in", "path"},
                {"required", true},    {"description", "A session, by its id in /sessions"},
                {"schema", text()},    {"example", "night-cp"}};
  return {
      {"info",
       {{"description",
         "Forecasts of current, wind and waves for offshore sites over OGC API-EDR 1.1: nothing "
         "of them writes, and nothing is access-controlled. Beside them live sessions, which "
         "people begin and take part in with tokens."}}},
      {"paths", paths()},
      {"components",
       {{"parameters", {{"sessionId", id}}},
        {"schemas", schemas()},
        {"securitySchemes", {{"people", {{"type", "http"}, {"scheme", "bearer"}}}}}}}};
}

}  // namespace slackwater::sessions
