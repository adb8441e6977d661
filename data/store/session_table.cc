#include "data/store/session_table.h"

#include "fields/base/error.h"

namespace slackwater::store {
namespace {

SessionAction action_from(const Statement& row) {
  SessionAction action;
  int column = 0;
  action.number = static_cast<std::uint64_t>(row.integer(column++));
  action.at = row.time(column++);
  action.time_s = row.real(column++);
  action.step = static_cast<std::uint64_t>(row.integer(column++));
  action.seat = static_cast<unsigned>(row.integer(column++));
  action.who = row.text(column++);
  action.role = row.text(column++);
  action.what = row.text(column++);
  action.vehicle = row.text(column++);
  action.before = row.text(column++);
  action.after = row.text(column++);
  action.is_taken = row.integer(column++) != 0;
  action.reason = row.text(column++);
  action.why = row.text(column++);
  action.count = static_cast<std::uint64_t>(row.integer(column++));
  return action;
}

}  // namespace

std::int64_t insert_session(Database& database, const std::string& name, UtcTime begun) {
  Statement insert = database.prepare("INSERT INTO session (name, begun_ms) VALUES (?,?)");
  insert.bind_all(name, begun);
  insert.run();
  return database.last_inserted_id();
}

void insert_actions(Database& database, std::int64_t session,
                    std::span<const SessionAction> actions) {
  for (const SessionAction& action : actions) {
    Statement insert = database.prepare(
        "INSERT INTO session_action (session_id, number, at_ms, time_s, step, seat, who, role, "
        "what, vehicle, was, became, taken, reason, why, count) VALUES "
        "(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
    insert.bind_all(session, static_cast<std::int64_t>(action.number), action.at, action.time_s,
                    static_cast<std::int64_t>(action.step), std::int64_t{action.seat}, action.who,
                    action.role, action.what, action.vehicle, action.before, action.after,
                    std::int64_t{action.is_taken}, action.reason, action.why,
                    static_cast<std::int64_t>(action.count));
    insert.run();
  }
}

std::vector<SessionRow> select_sessions(Database& database) {
  Statement select = database.prepare(
      "SELECT s.id, s.name, s.begun_ms, (SELECT count(*) FROM session_action a WHERE "
      "a.session_id = s.id) FROM session s ORDER BY s.id");
  std::vector<SessionRow> sessions;
  while (select.step())
    sessions.push_back({select.integer(0), select.text(1), select.time(2),
                        static_cast<std::uint64_t>(select.integer(3))});
  return sessions;
}

std::vector<SessionAction> select_actions(Database& database, std::int64_t session) {
  Statement known = database.prepare("SELECT 1 FROM session WHERE id = ?");
  if (!known.bind(1, session).step())
    throw Error(ErrorKind::not_found, "session " + std::to_string(session) +
                                          " is not in the store; `slackwater sessions` lists "
                                          "those that are");
  Statement select = database.prepare(
      "SELECT number, at_ms, time_s, step, seat, who, role, what, vehicle, was, became, taken, "
      "reason, why, count FROM session_action WHERE session_id = ? ORDER BY number");
  select.bind_all(session);
  std::vector<SessionAction> actions;
  while (select.step()) actions.push_back(action_from(select));
  return actions;
}

}  // namespace slackwater::store
