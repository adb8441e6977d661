#include "twin/scenario/read_task.h"

#include <limits>
#include <string>
#include <vector>

#include "fields/base/constants.h"
#include "twin/control/patterns.h"
#include "twin/mission/reach.h"
#include "twin/mission/read_seconds.h"
#include "twin/scenario/read_place.h"

namespace slackwater::twin {
namespace {

using constants::degree;

std::vector<Waypoint> read_waypoints(const Config& config) {
  std::vector<Waypoint> out;
  for (const Config& at : config.children("waypoints")) {
    Waypoint waypoint;
    waypoint.position_m = read_place(at);
    put_speed(read_speed(at), waypoint);
    out.push_back(waypoint);
  }
  if (out.empty() || out.size() > most_waypoints)
    config.refuse("waypoints", "found " + std::to_string(out.size()) +
                                   " waypoints, expected 1 to " + std::to_string(most_waypoints));
  return out;
}

/// `battery` of a time on board: keep, swap, or charge with `charger_w`.
double read_charger(const Config& config) {
  const std::string word = config.optional_text("battery").value_or("keep");
  if (word == "charge") return config.number("charger_w", {0.1, 1e6});
  if (word == "swap") return std::numeric_limits<double>::infinity();
  if (word != "keep") config.refuse("battery", "found " + word + ", expected keep, swap or charge");
  return 0;
}

/// `until` of a time on board: stand_by, or none.
bool read_until(const Config& config) {
  const auto word = config.optional_text("until");
  if (word && *word != "stand_by") config.refuse("until", "found " + *word + ", expected stand_by");
  return word.has_value();
}

}  // namespace

ScenarioTask read_task(const Config& config) {
  const std::string kind = config.text("do");
  const auto course = [&] { return config.number("course_deg", {-360, 360}) * degree; };
  ScenarioTask task;
  if (kind == "route") {
    task.waypoints = read_waypoints(config);
  } else if (kind == "hold") {
    task.kind = ScenarioTask::Kind::hold;
    task.hold_s = has_seconds(config, "duration")
                      ? read_seconds(config, "duration", {0, 30 * 86400.0})
                      : std::numeric_limits<double>::infinity();
  } else if (kind == "lawn_mower") {
    task.waypoints = lawn_mower(
        read_place(config.child("corner")), course(), config.number("length_m", {1, farthest_m}),
        config.number("spacing_m", {0.1, farthest_m}), config.integer("lines", 1, 1000), 0);
  } else if (kind == "orbit") {
    const Config centre = config.child("centre");
    const Triple<double> at = read_place(centre);
    const double radius_m = config.number("radius_m", {0.5, 5000});
    task.waypoints =
        orbit(at, radius_m, config.optional_number("from_deg", {-360, 360}).value_or(0) * degree,
              config.number("turns", {0.1, 1000}),
              config.optional_number("end_depth_m", {-1000, 12000}).value_or(at.z),
              config.optional_number("chord_m", {0.1, 1000}).value_or(0.5 * radius_m), 0);
  } else if (kind == "depth_sweep") {
    task.waypoints = depth_sweep(
        read_place(config.child("from")), course(), config.number("length_m", {1, farthest_m}),
        config.number("shallow_m", reached_depth_m), config.number("deep_m", reached_depth_m),
        config.number("wavelength_m", {1, farthest_m}),
        config.optional_number("spacing_m", {0.1, 1000}).value_or(2), 0);
  } else if (kind == "aboard") {
    task.kind = ScenarioTask::Kind::aboard;
    task.until_stand_by = read_until(config);
    if (!task.until_stand_by || has_seconds(config, "duration"))
      task.hold_s = read_seconds(config, "duration", {0, 30 * 86400.0});
    task.charger_w = read_charger(config);
  } else if (kind == "stand_by") {
    task.kind = ScenarioTask::Kind::stand_by;
    task.hold_s = std::numeric_limits<double>::infinity();
  } else if (kind == "follow_track") {
    task.kind = ScenarioTask::Kind::follow_track;
    task.follow = read_track_to_follow(config);
  } else if (kind == "actuators") {
    task.kind = ScenarioTask::Kind::actuators;
    task.hold_s = read_seconds(config, "duration", {0.001, 30 * 86400.0});
    task.table = read_actuator_table(config, task.hold_s);
  } else if (const auto manoeuvre = manoeuvre_named(kind)) {
    task.kind = ScenarioTask::Kind::manoeuvre;
    task.manoeuvre = read_manoeuvre(config, *manoeuvre);
    task.hold_s = longest_s(*task.manoeuvre);
  } else {
    config.refuse("do", "found " + kind +
                            ", expected route, hold, lawn_mower, orbit, depth_sweep, "
                            "follow_track, aboard, stand_by, actuators, steps, turning_circle, "
                            "zig_zag, spiral or pull_out");
  }
  if (const auto word = config.optional_text("phase")) {
    const auto phase = phase_of(*word);
    if (!phase)
      config.refuse("phase",
                    "found " + *word + ", expected transit, launch, work, recovery or return");
    task.phase = *phase;
  }
  if (const auto frame = config.optional_text("frame")) {
    if (*frame != "fixed" && *frame != "drifting")
      config.refuse("frame", "found " + *frame + ", expected fixed or drifting");
    if (task.waypoints.empty())
      config.refuse("frame", "found at a task without waypoints, which have a frame; leave it out");
    task.drifts = *frame == "drifting";
  }
  if (!task.waypoints.empty()) {
    const AskedSpeed asked = read_speed(config);
    for (Waypoint& waypoint : task.waypoints)
      if (!(waypoint.speed_m_s > 0)) put_speed(asked, waypoint);
  }
  return task;
}

}  // namespace slackwater::twin
