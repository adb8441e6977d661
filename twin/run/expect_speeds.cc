#include "twin/run/expect_speeds.h"

#include <cmath>

#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

struct AskedPace {
  double m_s = 0;
  bool is_over_ground = false;
};

/// Found, expected, what to do; `where` is of the scenario.
void expect_speed(const Agent& agent, const AskedPace& asked, const std::string& where) {
  const Vehicle& vehicle = *agent.vehicle;
  const double top_m_s = agent.mission.pursuit.most_speed_m_s;
  const bool flies = vehicle.kind == VehicleKind::uav;
  const bool is_carried = !flies && vehicle.kind != VehicleKind::rov;
  const bool is_over_ground = is_carried && asked.is_over_ground;
  const double most_m_s = (is_over_ground ? 2 : 1) * top_m_s;
  const char* key = asked.is_over_ground ? "ground_speed_m_s" : "speed_m_s";
  // What a file says of itself in round numbers is meant.
  constexpr double rounding = 1.005;
  if (asked.m_s > rounding * most_m_s) {
    throw Error(
        ErrorKind::invalid_input,
        where +
            formatted("{}: found {:g} m/s, expected at most {:.3g} m/s: a {} makes "
                      "{:.3g} m/s through still {} by its own {} and the bound of its autopilot{}. "
                      "Ask for less",
                      key, asked.m_s, most_m_s, vehicle.name, top_m_s, flies ? "air" : "water",
                      flies ? "rotors and tilt" : "thrust and drag",
                      is_over_ground ? ", and water as fast as itself carries it on" : ""));
  }
  const double least_m_s = agent.autopilot->settings.least_speed_m_s;
  if (vehicle.kind == VehicleKind::auv && !asked.is_over_ground && asked.m_s < least_m_s)
    throw Error(ErrorKind::invalid_input,
                where + formatted("{}: found {:g} m/s, expected at least {:g} m/s, below which the "
                                  "fins of a {} do not steer it (least_speed_m_s of its autopilot)",
                                  key, asked.m_s, least_m_s, vehicle.name));
}

void expect_speeds(const ManoeuvreTask& manoeuvre, const Agent& agent) {
  if (manoeuvre.speed_m_s)
    expect_speed(agent, {*manoeuvre.speed_m_s, false}, manoeuvre.place.text + ": ");
  for (const KeptStep& step : manoeuvre.steps)
    if (step.speed_m_s) expect_speed(agent, {*step.speed_m_s, false}, step.place.text + ": ");
}

}  // namespace

void expect_speeds(const ScenarioVehicle& entry, const Agent& agent) {
  expect_speed(
      agent,
      {entry.speed_m_s.value_or(agent.vehicle->cruise_speed_m_s), entry.is_speed_over_ground},
      entry.speed_m_s ? "" : "without a speed of its own it goes at its cruise_speed_m_s; ");
  std::size_t task = 0;
  for (const ScenarioTask& t : entry.tasks) {
    ++task;
    if (t.table && t.table->speed_m_s)
      expect_speed(agent, {*t.table->speed_m_s, false}, t.table->place.text + ": ");
    if (t.manoeuvre) expect_speeds(*t.manoeuvre, agent);
    std::size_t number = 0;
    for (const Waypoint& waypoint : t.waypoints) {
      ++number;
      if (waypoint.speed_m_s > 0)
        expect_speed(agent, {waypoint.speed_m_s, waypoint.over_ground > 0},
                     formatted("waypoint {} of task {}: ", number, task));
    }
  }
}

}  // namespace slackwater::twin
