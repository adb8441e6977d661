#include "api/show/decisions/decision_words.h"

#include <filesystem>

#include "fields/base/text.h"

namespace slackwater::api {
namespace {

/// Times of a start are told to the minute: "2025-03-10 07:30 UTC".
std::string minute_text(UtcTime time) {
  const std::string text = format_utc(time);
  return text.substr(0, 10) + " " + text.substr(11, 5) + " UTC";
}

std::string both_clocks(UtcTime time, const std::optional<TimeZone>& zone) {
  return minute_text(time) + (zone ? " (" + zone->text(time) + ")" : std::string());
}

std::string forecast_text(const store::DecisionRow& row) {
  return "forecast " + std::to_string(row.forecast) + ", issued " +
         format_utc(row.forecast_issued) + ", " + row.forecast_sha256.substr(0, 12);
}

std::string late_text(const store::DecisionRow& row) {
  return formatted("recorded late, {:.1f} h after the start",
                   hours_between(row.start, row.recorded_at));
}

std::string stated_text(const store::DecisionRow& row) {
  return row.by_clock ? "" : " (a time that was stated with --at)";
}

/// "3 goes", "1 go".
std::string goes_text(std::size_t n) { return std::to_string(n) + (n == 1 ? " go" : " goes"); }

std::string paragraph(const DecisionAnswer& one, const std::optional<TimeZone>& zone) {
  const store::DecisionRow& row = one.row;
  std::string text = formatted("{:>5}  {:<5}  ", row.id, word_of(row.decided)) +
                     task_and_place(row) + ", start " + both_clocks(row.start, zone) + "\n";
  const auto line = [&](const std::string& words) { text += "       " + words + "\n"; };
  line("by " + row.by + ", recorded " + format_utc(row.recorded_at) + stated_text(row));
  if (one.is_late) line(late_text(row));
  line("said: " + said_text(row) + " (" + forecast_text(row) + ")");
  line("came: " + came_text(one));
  if (!row.note.empty()) line("note: " + row.note);
  if (!row.hand_over.empty()) line("for the next shift: " + row.hand_over);
  if (!one.counts) line("a later record counts in its place");
  return text;
}

}  // namespace

std::string word_of(store::Decided decided) {
  return decided == store::Decided::go ? "go" : "no-go";
}

std::string task_and_place(const store::DecisionRow& row) {
  const bool is_file = row.task.find('/') != std::string::npos;
  return (is_file ? std::filesystem::path(row.task).stem().string() : row.task) +
         (row.turbine.empty() ? std::string() : " at " + row.turbine);
}

std::string said_text(const store::DecisionRow& row) {
  if (!row.probability) return "nothing: " + row.unsaid;
  return row.verdict + formatted(", {:.0f} %", 100 * *row.probability);
}

std::string came_text(const DecisionAnswer& decision) {
  const WhatCame& what = decision.what;
  const bool is_go = decision.row.decided == store::Decided::go;
  std::string text;
  switch (what.came) {
    case Came::held:
      text = is_go ? "held" : "would have held";
      break;
    case Came::did_not_hold:
      text = is_go ? "did not hold" : "would not have held";
      break;
    case Came::not_known_yet:
      return "not known yet" + (what.why.empty() ? std::string() : ": " + what.why);
    case Came::cannot_be_known:
      return "cannot be known" + (what.why.empty() ? std::string() : ": " + what.why);
  }
  if (!what.broken.empty()) text += ": " + what.broken;
  if (what.broken_at) text += ", not kept at " + minute_text(*what.broken_at);
  if (!what.not_checked.empty())
    text += " (" + counted(what.not_checked.size(), "limit") + " not checked)";
  return text;
}

std::string record_text(const DecisionsRecord& record) {
  if (record.tasks == 0) return {};
  std::vector<std::string> parts;
  if (record.goes_known > 0)
    parts.push_back(formatted("of {} {} held", goes_text(record.goes_known), record.goes_held));
  // A day of two tasks is two.
  const std::string days = record.tasks > 1 ? " of a task" : "";
  if (record.days_lost > 0)
    parts.push_back(formatted("{} workable {}{} {} lost", record.days_lost,
                              record.days_lost == 1 ? "day" : "days", days,
                              record.days_lost == 1 ? "was" : "were"));
  std::vector<std::string> open;
  if (record.goes_open > 0) open.push_back(goes_text(record.goes_open));
  if (record.days_open > 0)
    open.push_back(counted(record.days_open, "day") + days + " with a no-go");
  if (!open.empty())
    parts.push_back("what came of " + joined(open, " and ") + " is not known so far");
  return parts.empty() ? "no go was decided, and no workable day was lost" : joined(parts, "; ");
}

std::string recorded_text(const DecisionMade& made) {
  const store::DecisionRow& row = made.row;
  std::string text = "decision " + std::to_string(row.id) + " recorded: " + word_of(row.decided) +
                     " for " + task_and_place(row) + ", start " + minute_text(row.start) + ", by " +
                     row.by + "\n";
  text += "the program says: " + said_text(row) + " (" + forecast_text(row) + ")\n";
  if (made.is_late) text += late_text(row) + "\n";
  if (made.before)
    text += "it counts in place of decision " + std::to_string(made.before->id) + ", " +
            word_of(made.before->decided) + " by " + made.before->by + ", which is kept\n";
  return text;
}

std::string decisions_text(const DecisionsAnswer& answer) {
  std::string text = answer.site_name + ": " + counted(answer.decisions.size(), "decision") + "\n";
  for (const DecisionAnswer& one : answer.decisions) text += paragraph(one, answer.zone);
  const std::string record = record_text(answer.record);
  if (!record.empty()) text += "the record: " + record + "\n";
  return text;
}

}  // namespace slackwater::api
