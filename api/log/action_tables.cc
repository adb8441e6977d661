#include "api/log/action_tables.h"

#include "fields/base/error.h"

namespace slackwater::api {
namespace {

using ingest::TrajectoryTable;
using store::SessionAction;

const auto& expected(const auto* column, const TrajectoryTable& table, const char* name) {
  if (column != nullptr && column->size() == table.rows()) return *column;
  throw Error(ErrorKind::invalid_input, std::string("found no column ") + name +
                                            " in the table action; give a log that `slackwater "
                                            "live` wrote");
}

}  // namespace

std::vector<TrajectoryTable> action_tables(std::span<const SessionAction> actions) {
  if (actions.empty()) return {};
  std::vector<double> number, time, step, seat, taken, count;
  std::vector<std::string> at, who, role, what, vehicle, before, after, reason, why;
  for (const SessionAction& action : actions) {
    number.push_back(static_cast<double>(action.number));
    time.push_back(action.time_s);
    step.push_back(static_cast<double>(action.step));
    seat.push_back(action.seat);
    taken.push_back(action.is_taken ? 1 : 0);
    at.push_back(format_utc(action.at));
    who.push_back(action.who);
    role.push_back(action.role);
    what.push_back(action.what);
    vehicle.push_back(action.vehicle);
    before.push_back(action.before);
    after.push_back(action.after);
    reason.push_back(action.reason);
    why.push_back(action.why);
    count.push_back(static_cast<double>(action.count));
  }
  return {{"action",
           {{"number", "1", "within the session", number},
            {"time", "s", "since the start of the run", time},
            {"step", "1", "of the run, the last that was made", step},
            {"seat", "1", "of the session", seat},
            {"taken", "1", "1: it was done; 0: refused", taken},
            {"count", "1", "at the end of sticks that followed on each other: how many", count}},
           {{"at", "UTC, on the clock of the wall", at},
            {"who", "the name of the seat", who},
            {"role", "spectator, operator or supervisor", role},
            {"what", "was asked for", what},
            {"vehicle", "whom it was for; empty: the run or the session", vehicle},
            {"before", "as it was", before},
            {"after", "as it became", after},
            {"reason", "of a refusal", reason},
            {"why", "it was refused, in words, or done", why}}}};
}

std::vector<SessionAction> actions_in(const ingest::TrajectoryFile& log) {
  const TrajectoryTable* table = log.find_table("action");
  if (table == nullptr) return {};
  const auto numbers = [&](const char* name) -> const std::vector<double>& {
    return expected(table->column(name), *table, name);
  };
  const auto texts = [&](const char* name) -> const std::vector<std::string>& {
    return expected(table->text(name), *table, name);
  };
  // Logs of earlier versions have neither.
  const std::vector<std::string>* reasons = table->text("reason");
  const std::vector<double>* counts = table->column("count");
  std::vector<SessionAction> actions(table->rows());
  for (std::size_t i = 0; i < actions.size(); ++i) {
    SessionAction& action = actions[i];
    action.number = static_cast<std::uint64_t>(numbers("number")[i]);
    action.time_s = numbers("time")[i];
    action.step = static_cast<std::uint64_t>(numbers("step")[i]);
    action.seat = static_cast<unsigned>(numbers("seat")[i]);
    action.is_taken = numbers("taken")[i] != 0;
    action.at = parse_utc(texts("at")[i]);
    action.who = texts("who")[i];
    action.role = texts("role")[i];
    action.what = texts("what")[i];
    action.vehicle = texts("vehicle")[i];
    action.before = texts("before")[i];
    action.after = texts("after")[i];
    if (reasons != nullptr) action.reason = texts("reason")[i];
    action.why = texts("why")[i];
    if (counts != nullptr) action.count = static_cast<std::uint64_t>(numbers("count")[i]);
  }
  return actions;
}

}  // namespace slackwater::api
