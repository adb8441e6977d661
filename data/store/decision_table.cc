#include "data/store/decision_table.h"

#include "fields/base/check.h"
#include "fields/base/error.h"

namespace slackwater::store {
namespace {

std::optional<std::int64_t> milliseconds_of(const std::optional<Duration>& duration) {
  return duration ? std::optional<std::int64_t>(duration->count()) : std::nullopt;
}

DecisionRow decision_from(const Statement& row) {
  DecisionRow decision;
  int column = 0;
  decision.id = row.integer(column++);
  decision.site_id = row.name(column++);
  decision.task = row.name(column++);
  decision.turbine = row.name(column++);
  decision.start = row.time(column++);
  if (const auto work_ms = row.optional_integer(column++)) decision.work = Duration(*work_ms);
  decision.decided = row.parsed(column++, decided_from);
  decision.by = row.text(column++);
  decision.recorded_at = row.time(column++);
  decision.by_clock = row.integer(column++) != 0;
  decision.forecast = row.integer(column++);
  decision.probability = row.optional_real(column++);
  decision.verdict = row.text(column++);
  decision.unsaid = row.text(column++);
  decision.note = row.text(column++);
  decision.hand_over = row.text(column++);
  decision.forecast_sha256 = row.checksum(column++);
  decision.forecast_issued = row.time(column++);
  return decision;
}

}  // namespace

std::string_view name_of(Decided decided) noexcept {
  return decided == Decided::go ? "go" : "no_go";
}

Decided decided_from(std::string_view name) {
  for (const Decided decided : {Decided::go, Decided::no_go})
    if (name == name_of(decided)) return decided;
  refuse("found the decision '" + std::string(name) + "', expected go or no_go");
}

std::int64_t insert_decision(Database& database, const DecisionRow& row) {
  expects(!row.by.empty() && !row.task.empty() && !row.site_id.empty(),
          "a decision has a site, a task and a name");
  expects(row.probability.has_value() == !row.verdict.empty(),
          "a verdict stands beside a probability");
  Statement forecast = database.prepare("SELECT 1 FROM forecast WHERE id = ?");
  if (!forecast.bind(1, row.forecast).step())
    throw Error(ErrorKind::not_found, "forecast " + std::to_string(row.forecast) +
                                          ", which the decision rests on, is not in the store; "
                                          "it was pruned meanwhile: decide again");
  Statement insert = database.prepare(
      "INSERT INTO decision (site_id, task, turbine, start_ms, work_ms, decided, decided_by, "
      "recorded_at_ms, by_clock, forecast_id, probability, verdict, unsaid, note, "
      "hand_over) VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
  insert.bind_all(row.site_id, row.task, row.turbine, row.start, milliseconds_of(row.work),
                  name_of(row.decided), row.by, row.recorded_at, std::int64_t{row.by_clock},
                  row.forecast, row.probability, row.verdict, row.unsaid, row.note, row.hand_over);
  insert.run();
  return database.last_inserted_id();
}

std::vector<DecisionRow> select_decisions(Database& database, const DecisionQuery& query) {
  Statement select = database.prepare(
      "SELECT d.id, d.site_id, d.task, d.turbine, d.start_ms, d.work_ms, d.decided, d.decided_by, "
      "d.recorded_at_ms, d.by_clock, d.forecast_id, d.probability, d.verdict, d.unsaid, d.note, "
      "d.hand_over, f.content_sha256, f.issued_ms FROM decision d JOIN forecast f ON f.id = "
      "d.forecast_id "
      "WHERE (?1 = '' OR d.site_id = ?1) AND (?2 = '' OR d.task = ?2) "
      "AND (?3 IS NULL OR d.start_ms >= ?3) AND (?4 IS NULL OR d.start_ms < ?4) "
      "ORDER BY d.start_ms, d.id");
  select.bind_all(query.site_id, query.task, query.from, query.to);
  std::vector<DecisionRow> decisions;
  while (select.step()) decisions.push_back(decision_from(select));
  return decisions;
}

}  // namespace slackwater::store
