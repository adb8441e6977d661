#include "twin/run/expect_places.h"

#include <string>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/run/set_up.h"
#include "twin/scene/structure.h"

namespace slackwater::twin {
namespace {

/// A way that touches a structure does not lead through it.
bool leads_through(const ScenarioStructure& s, const Triple<double>& from_m,
                   const Triple<double>& to_m) {
  constexpr double touch_m = 1e-3;
  return least_distance_m(shape_of(s), from_m, to_m) < -touch_m;
}

}  // namespace

void expect_places(const Scenario& scenario, const ScenarioVehicle& entry, const Agent& agent,
                   double t_s, bool is_without_currents) {
  const bool flies = agent.vehicle->kind == VehicleKind::uav;
  const bool floats = agent.vehicle->body.hull.strips > 0;
  const auto on_water = [&](const Triple<double>& at_m) {
    return Triple<double>{at_m.x, at_m.y, floats ? 0.0 : at_m.z};
  };
  const auto expect_place = [&](const Triple<double>& at_m, const std::string& what) {
    const std::string named = "vehicle " + entry.name + ": " + what;
    if (flies && at_m.z > 0) refuse(named + " is below the sea; give a multirotor a height_m");
    if (!flies && !floats && at_m.z < 0) refuse(named + " is above the sea; give it a depth_m");
    // As deep as its hull reaches: what is looked at in each step.
    const SampleStatus status =
        flies ? agent.water->wind(at_m, t_s).status
              : agent.water->current(on_water(at_m), agent.vehicle->body.height_m, t_s).status;
    const bool is_there = is_without_currents && status == SampleStatus::missing;
    if (!has_value(status) && !is_there) {
      refuse(named + " is " + std::string(name_of(status)) + " (" +
             agent.water->environment().field->range().text() +
             "); move it into the water of the forecast");
    }
    for (const ScenarioStructure& s : scenario.structures)
      if (leads_through(s, on_water(at_m), on_water(at_m)))
        refuse(named + " lies in " + s.name + "; move it out");
  };
  expect_place(entry.start_m, "the start");
  std::size_t task = 0;
  Triple<double> before_m = entry.start_m;
  bool is_carried = false;  // it comes to the next waypoint from wherever its carrier is
  for (const ScenarioTask& t : entry.tasks) {
    ++task;
    is_carried = is_carried || t.until_stand_by;
    std::size_t number = 0;
    for (const Waypoint& waypoint : t.waypoints) {
      const std::string what =
          "waypoint " + std::to_string(++number) + " of task " + std::to_string(task);
      expect_place(waypoint.position_m, what);
      for (const ScenarioStructure& s : scenario.structures)
        if (!is_carried && leads_through(s, on_water(before_m), on_water(waypoint.position_m)))
          refuse("vehicle " + entry.name + ": the way to " + what + " leads through " + s.name +
                 "; give waypoints round it");
      before_m = waypoint.position_m;
      is_carried = false;
    }
    if (!t.manoeuvre) continue;
    for (const KeptStep& step : t.manoeuvre->steps)
      if (step.depth_m)
        expect_place({before_m.x, before_m.y, *step.depth_m},
                     "a step to " + formatted("{:g}", *step.depth_m) + " m, where task " +
                         std::to_string(task) + " begins,");
  }
}

}  // namespace slackwater::twin
