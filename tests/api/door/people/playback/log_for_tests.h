#pragma once
#include <vector>

#include "api/log/action_tables.h"
#include "fields/base/constants.h"
#include "ingest/cf/trajectory_file.h"

namespace slackwater::tests {

/// Of Ann, or of Sue, who supervises.
inline store::SessionAction logged_action(std::uint64_t number, double time_s, unsigned seat,
                                          std::string what, std::string before, std::string after) {
  store::SessionAction row;
  row.number = number;
  row.at = parse_utc("2026-11-27T05:00:00Z");
  row.time_s = time_s;
  row.seat = seat;
  row.who = seat == 1 ? "Ann" : "Sue";
  row.role = seat == 1 ? "operator" : "supervisor";
  row.what = std::move(what);
  row.vehicle = "first";
  row.before = std::move(before);
  row.after = std::move(after);
  return row;
}

/// Two vehicles, a row a second for a minute; the second one joins at 20 s, and is out of the log
/// from 40 to 44 s. The first one turns through north between its rows at 10 and 11 s.
inline ingest::TrajectoryFile made_up_log() {
  using ingest::TrajectoryFile;
  constexpr double nan = constants::nan;
  TrajectoryFile log;
  log.names = {"first", "second"};
  log.epoch = parse_utc("2026-11-27T05:00:00Z");
  TrajectoryFile::Variable x{"x", "", "m", "", 1, {}}, y = x, z = x, yaw = x, halt = x;
  y.name = "y";
  z.name = "z";
  yaw.name = "yaw";
  halt.name = "halt";
  for (int i = 0; i <= 60; ++i) log.t_s.push_back(i);
  for (int vehicle = 0; vehicle < 2; ++vehicle)
    for (int i = 0; i <= 60; ++i) {
      const bool is_there = vehicle == 0 || (i >= 20 && (i < 40 || i > 44));
      const auto put = [&](TrajectoryFile::Variable& column, double value) {
        column.values.push_back(is_there ? value : nan);
      };
      put(x, 0.37 * i + 10 * vehicle);
      put(y, -1.3 * i);
      put(z, -10 - 0.1 * i);
      put(yaw, (i <= 10 ? 359 : 1) * constants::degree);
      put(halt, i >= 50 && vehicle == 0 ? 4 : 0);
    }
  log.variables = {x, y, z, yaw, halt};
  const std::vector<store::SessionAction> actions{
      logged_action(1, 0, 1, "ask", "free", "held"),
      logged_action(2, 12.5, 1, "hold", "held", "hold"),
      logged_action(3, 12.5, 2, "ask", "held", "requested"),
      logged_action(4, 30, 1, "grant", "requested", "held"),
      logged_action(5, 60.7, 2, "give_back", "held", "free")};
  log.tables = api::action_tables(actions);
  log.attributes = {{"title", "made up"}, {"origin", "60.500000000 N, 4.250000000 E"}};
  return log;
}

}  // namespace slackwater::tests
