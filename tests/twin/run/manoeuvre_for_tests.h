#pragma once
#include <map>

#include "tests/twin/run/helm_for_tests.h"
#include "twin/account/vehicle_account.h"

namespace slackwater::tests {

/// A vehicle in still water with these tasks, which are on line 9.
inline std::string doing(const std::string& model, const std::string& tasks,
                         const std::string& start = "depth_m: 20, heading_deg: 40",
                         const std::string& more = "") {
  return "name: test\nseed: 7\nduration: 60min\nstep_s: 0.05\nlog_every_s: 0.1\n"
         "water: {made_up: {depth_m: 60}}\n" +
         more + "vehicles:\n  - {name: it, model: " + model + ", start: {north_m: 0, east_m: 0, " +
         start + "}, tasks: [\n      " + tasks + "]}\n";
}
inline const std::string afloat = "depth_m: 0, heading_deg: 40";

/// The rows of one vehicle of a log.
class LogRows {
 public:
  LogRows(const twin::RunLog& log, std::size_t vehicle) : log_(log), vehicle_(vehicle) {}
  [[nodiscard]] twin::VehicleRows rows() {
    twin::VehicleRows rows;
    rows.t_s = log_.t_s;
    rows.column = [this](std::string_view name) -> std::span<const double> {
      const std::string key(name);
      const auto has = twin::log_variables();
      if (std::none_of(has.begin(), has.end(), [&](const auto& one) { return one.name == name; }))
        return {};
      if (!columns_.contains(key)) columns_[key] = log_.column(vehicle_, name);
      return columns_.at(key);
    };
    return rows;
  }

 private:
  const twin::RunLog& log_;
  std::size_t vehicle_;
  std::map<std::string, std::vector<double>, std::less<>> columns_;
};

inline twin::VehicleAccount account_of_rows(twin::Run& run, const twin::RunLog& log,
                                            std::size_t vehicle = 0) {
  const twin::EndedRun ended{run.agents(), run.states(), {}, run.time_s()};
  twin::VehicleAccount account = twin::account_of(ended, vehicle);
  LogRows rows(log, vehicle);
  twin::add_rows(rows.rows(), account);
  return account;
}

/// A lone vehicle's run with its log, a row every two steps.
struct Flown {
  std::unique_ptr<twin::Run> run;
  twin::RunLog log;

  [[nodiscard]] const twin::AgentState& state() { return state_of_lone(*run); }
  void until(double time_s) {
    while (run->time_s() < time_s - 1e-6 && !run->all_halted()) {
      for (int i = 0; i < 2; ++i) run->step();
      log.append(run->time_s(), run->agents(), run->states());
    }
  }
  [[nodiscard]] twin::VehicleAccount account() { return account_of_rows(*run, log); }
};

inline Flown begun_flight(const std::string& yaml) {
  Flown flown{lone_run(yaml), {}};
  flown.log.append(0, flown.run->agents(), flown.run->states());
  return flown;
}

/// Of the only manoeuvre of a vehicle that goes on for so long.
inline twin::ManoeuvreAccount flown_manoeuvre(const std::string& yaml, double lasts_s) {
  Flown flown = begun_flight(yaml);
  flown.until(lasts_s);
  const twin::VehicleAccount account = flown.account();
  EXPECT_EQ(account.manoeuvres.size(), 1U);
  EXPECT_EQ(account.halt, twin::Halt::none);
  return account.manoeuvres.at(0);
}

}  // namespace slackwater::tests
