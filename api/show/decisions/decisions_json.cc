#include "api/show/decisions/decisions_json.h"

#include <nlohmann/json.hpp>

#include "api/show/decisions/decision_words.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

json text_or_null(const std::string& text) { return text.empty() ? json(nullptr) : json(text); }

json row_json(const store::DecisionRow& row) {
  return {{"id", row.id},
          {"site", row.site_id},
          {"task", row.task},
          {"turbine", text_or_null(row.turbine)},
          {"start", format_utc(row.start)},
          {"work_h", row.work ? json(hours_of(*row.work)) : json(nullptr)},
          {"decided", name_of(row.decided)},
          {"by", row.by},
          {"recorded_at", format_utc(row.recorded_at)},
          {"recorded_by_clock", row.by_clock},
          {"late", row.recorded_at > row.start},
          {"forecast",
           {{"id", row.forecast},
            {"sha256", row.forecast_sha256},
            {"issued", format_utc(row.forecast_issued)}}},
          {"said",
           {{"probability", row.probability ? json(*row.probability) : json(nullptr)},
            {"verdict", text_or_null(row.verdict)},
            {"why_nothing", text_or_null(row.unsaid)}}},
          {"note", text_or_null(row.note)},
          {"hand_over", text_or_null(row.hand_over)}};
}

}  // namespace

json decision_json(const DecisionAnswer& decision) {
  json out = row_json(decision.row);
  const WhatCame& what = decision.what;
  out["counts"] = decision.counts;
  out["came"] = {{"outcome", name_of(what.came)},
                 {"broken", text_or_null(what.broken)},
                 {"broken_at", what.broken_at ? json(format_utc(*what.broken_at)) : json(nullptr)},
                 {"why", text_or_null(what.why)},
                 {"not_checked", what.not_checked}};
  return out;
}

json record_json(const DecisionsRecord& record) {
  return {{"goes_known", record.goes_known},    {"goes_held", record.goes_held},
          {"goes_not_known", record.goes_open}, {"days_lost", record.days_lost},
          {"days_not_known", record.days_open}, {"text", text_or_null(record_text(record))}};
}

json decisions_json(const DecisionsAnswer& answer) {
  json decisions = json::array();
  for (const DecisionAnswer& one : answer.decisions) decisions.push_back(decision_json(one));
  return {{"schema", "decisions/1"},       {"site", answer.site_id},
          {"site_name", answer.site_name}, {"known_by", format_utc(answer.known_by)},
          {"decisions", decisions},        {"record", record_json(answer.record)}};
}

json recorded_json(const DecisionMade& made) {
  json out = row_json(made.row);
  out["in_place_of"] = made.before ? json(made.before->id) : json(nullptr);
  return out;
}

}  // namespace slackwater::api
