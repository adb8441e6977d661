#include "api/door/desk/decision_record.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "api/ask/decisions/decide.h"
#include "api/ask/decisions/decisions.h"
#include "api/door/desk/asked_words.h"
#include "api/door/desk/site_list.h"
#include "api/door/http/problem.h"
#include "api/show/decisions/decision_words.h"
#include "api/show/decisions/decisions_json.h"
#include "fields/base/attempt.h"
#include "fields/base/error.h"

namespace slackwater::api::desk {
namespace {

using nlohmann::json;

/// What a body says, beside the decision: what was on the page.
struct Signed {
  DecideQuestion question;
  std::string seen_forecast;          ///< empty: it does not say
  std::optional<json> seen_to_count;  ///< an id, or null
};

Error no_decision_in(const std::string& found) {
  return {ErrorKind::usage,
          "found " + found +
              R"(, expected {"task": ID, "start": TIME, "decided": "go" or "no_go", "by": NAME}, )"
              R"(and perhaps "turbine", "note", "hand_over", "at", "forecast" and "in_place_of")"};
}

std::string word_in(const std::string& name, const json& value) {
  if (!value.is_string()) throw no_decision_in("'" + name + "' that is no text");
  return value.get<std::string>();
}

store::Decided decided_in(const std::string& text) {
  if (text != "go" && text != "no_go") throw no_decision_in("the decision '" + text + "'");
  return store::decided_from(text);
}

Signed signed_in(const std::string& body) {
  const json said = json::parse(body, nullptr, false);
  if (!said.is_object()) throw no_decision_in("a body that is no JSON object");
  for (const char* name : {"task", "start", "decided", "by"})
    if (!said.contains(name)) throw no_decision_in(std::string("no ") + name);
  Signed out;
  DecideQuestion& question = out.question;
  for (const auto& [name, value] : said.items()) {
    if (name == "in_place_of" && (value.is_null() || value.is_number_integer())) {
      out.seen_to_count = value;
      continue;
    }
    const std::string text = word_in(name, value);
    if (name == "task") {
      expect_id("task", text);
      question.task = text;
    } else if (name == "turbine") {
      question.turbine = text;
    } else if (name == "start") {
      question.start = read_word("start", text, parse_utc);
    } else if (name == "decided") {
      question.decided = decided_in(text);
    } else if (name == "by") {
      question.by = text;
    } else if (name == "note") {
      question.note = text;
    } else if (name == "hand_over") {
      question.hand_over = text;
    } else if (name == "at") {
      question.recorded_at = read_word("at", text, parse_utc);
      question.by_clock = false;
    } else if (name == "forecast") {
      out.seen_forecast = text;
    } else {
      throw no_decision_in("another part, '" + name + "'");
    }
  }
  return out;
}

/// Why what was on the page is no longer so; empty where it is.
std::string changed_since(const Signed& said, const DecisionMade& made) {
  const store::DecisionRow& row = made.row;
  if (!said.seen_forecast.empty() && said.seen_forecast != row.forecast_sha256)
    return "found a decision on another forecast than the one in force, issued " +
           format_utc(row.forecast_issued) + "; look at that one, then decide";
  if (!said.seen_to_count) return {};
  const json counts = made.before ? json(made.before->id) : json(nullptr);
  if (counts == *said.seen_to_count) return {};
  if (!made.before) return "found a record to replace, and none counts for this start; look again";
  return "found decision " + std::to_string(made.before->id) + " on this start meanwhile, " +
         word_of(made.before->decided) + " by " + made.before->by +
         "; read it, and decide again where yours is another";
}

/// As the list has it; what came may be unknown, what was filed is filed.
json listed(const Answers& from, const DecisionMade& made, const WindowsQuestion& windows) {
  DecisionAnswer one;
  one.row = made.row;
  one.is_late = made.is_late;
  const auto failure = attempt([&] {
    DecisionsQuestion question;
    question.windows = windows;
    question.task = made.row.task;
    question.from = made.row.start;
    question.known_by = from.now();
    for (DecisionAnswer& other : decisions_of(question, from.store_folder).decisions)
      if (other.row.id == made.row.id) one = std::move(other);
  });
  if (failure) one.what.why = failure->why;
  return decision_json(one);
}

}  // namespace

http::Response DecisionRecord::file(const std::string& id, const std::string& body) {
  const Site site = described_site(id, from_.store_folder);
  Signed said = signed_in(body);
  DecideQuestion& question = said.question;
  question.windows = plain_question(site, id);
  if (question.by_clock) {
    question.recorded_at = std::chrono::floor<std::chrono::seconds>(from_.now());
    question.by_clock = from_.by_clock;
  }
  const std::lock_guard lock(mutex_);
  DecisionMade made = decision_made(question, from_.store_folder);
  if (const std::string why = changed_since(said, made); !why.empty())
    return http::problem(409, why, "/sites/" + id + "/decisions");
  file_decision(made, from_.store_folder);
  http::Response response;
  response.status = 201;
  response.media_type = "application/json";
  response.body = listed(from_, made, question.windows).dump();
  return response;
}

}  // namespace slackwater::api::desk
