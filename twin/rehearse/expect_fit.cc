#include "twin/rehearse/expect_fit.h"

#include <algorithm>
#include <cmath>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/agent/conduct.h"

namespace slackwater::twin {
namespace {

bool has_instrument(const Sensors& sensors, const std::string& name) {
  if (name == "imu") return sensors.imu.has_value();
  if (name == "gnss") return sensors.gnss.has_value();
  if (name == "depth") return sensors.depth.has_value();
  if (name == "compass") return sensors.compass.has_value();
  if (name == "dvl") return sensors.dvl.has_value();
  if (name == "adcp") return sensors.adcp.has_value();
  if (name == "sonar") return sensors.sonar.has_value();
  if (name == "camera") return sensors.camera.has_value();
  refuse("needs: found " + name +
         ", expected imu, gnss, depth, compass, dvl, adcp, sonar or camera, which vehicles have");
}

void expect_kind(const Requirement& wanted, const Vehicle& vehicle) {
  const std::string kind = name_of(vehicle.kind);
  if (wanted.kinds.empty() ||
      std::find(wanted.kinds.begin(), wanted.kinds.end(), kind) != wanted.kinds.end())
    return;
  refuse("agent " + wanted.agent + ": a " + vehicle.name + " is of kind " + kind + ", expected " +
         joined(wanted.kinds, " or ") + "; choose another model");
}

void expect_instruments(const Requirement& wanted, const Vehicle& vehicle) {
  for (const std::string& name : wanted.needs)
    if (!has_instrument(vehicle.sensors, name))
      refuse("agent " + wanted.agent + ": a " + vehicle.name + " has no " + name +
             ", which its task needs; add it to the vehicle's file or choose another model");
}

void expect_depth(const Requirement& wanted, const Agent& agent) {
  const auto& rated_m = agent.vehicle->rated_depth_m;
  if (!rated_m) return;
  for (const ScenarioTask& task : agent.mission.tasks)
    for (const Waypoint& at : task.waypoints)
      if (at.position_m.z > *rated_m)
        refuse("agent " + wanted.agent +
               formatted(": its work is {:.0f} m deep, and a {} is rated for {:.0f} m; choose "
                         "another model",
                         at.position_m.z, agent.vehicle->name, *rated_m));
}

/// Where a carrier stands by, one place after the other.
std::vector<Triple<double>> stands_of(const Agent& carrier, const AgentState& start) {
  std::vector<Triple<double>> places_m;
  Triple<double> is_at_m = start.vehicle.body.position_m;
  for (const ScenarioTask& task : carrier.mission.tasks) {
    if (!task.waypoints.empty()) is_at_m = task.waypoints.back().position_m;
    if (task.kind == ScenarioTask::Kind::stand_by) places_m.push_back(is_at_m);
  }
  return places_m;
}

void expect_reach(const Requirement& wanted, const ReadyRun& ready, std::size_t place) {
  const Agent& agent = ready.agents[place];
  const AgentState& start = ready.states[place];
  if (!agent.tether) return;
  const double length_m = start.tether.length_m;
  std::vector<Triple<double>> stands_m;
  if (agent.carrier)
    stands_m = stands_of(ready.agents[*agent.carrier], ready.states[*agent.carrier]);
  std::size_t sortie = 0;
  Triple<double> top_m = start.top.place_m;
  for (const ScenarioTask& task : agent.mission.tasks) {
    // The deck as high and about where the vessel is, whichever way she heads.
    if (task.until_stand_by && sortie < stands_m.size()) {
      top_m = stands_m[sortie++];
      top_m.z += agent.deck_m.z;
    }
    for (const Waypoint& at : task.waypoints) {
      const double away_m = length_of(at.position_m - top_m);
      if (away_m > length_m)
        refuse("agent " + wanted.agent +
               formatted(": its work lies up to {:.0f} m from the top of its tether, which is "
                         "{:.0f} m long; take a longer one, or start it nearer",
                         away_m, length_m));
    }
  }
}

/// What a straight way at its speed takes in still water.
double way_j(const Agent& agent, double length_m, double asked_m_s) {
  const ReadyConduct& conduct = *agent.conduct;
  const double speed_m_s =
      std::min(asked_m_s > 0 ? asked_m_s : agent.mission.guidance.speed_m_s, conduct.top_speed_m_s);
  return length_m / speed_m_s * cruise_w_at(conduct, speed_m_s);
}

/// Sortie by sortie: from one battery to the next. Where its carrier takes it costs it nothing.
void expect_energy(const Requirement& wanted, const Agent& agent, const Triple<double>& start_m) {
  const ReadyConduct& conduct = *agent.conduct;
  if (!(conduct.full_j > 0)) return;
  const double most_j = (1 - conduct.plan.reserve.share) * conduct.full_j;
  double sortie_j = 0;
  Triple<double> here_m = start_m;
  bool is_carried = false;
  for (const ScenarioTask& task : agent.mission.tasks) {
    is_carried = is_carried || task.until_stand_by;
    if (task.kind == ScenarioTask::Kind::aboard && std::isinf(task.charger_w)) sortie_j = 0;
    if (task.kind == ScenarioTask::Kind::hold && std::isfinite(task.hold_s))
      sortie_j += task.hold_s * conduct.cruise_w.front();
    for (const Waypoint& at : task.waypoints) {
      if (!is_carried) sortie_j += way_j(agent, length_of(at.position_m - here_m), at.speed_m_s);
      here_m = at.position_m;
      is_carried = false;
    }
    if (sortie_j > most_j)
      refuse(
          "agent " + wanted.agent +
          formatted(": its way takes {:.0f} Wh in still water, and the battery of a {} gives "
                    "{:.0f} Wh above the reserve; shorten the work, let it come back for another "
                    "battery (swap), or choose another model",
                    sortie_j / 3600, agent.vehicle->name, most_j / 3600));
  }
}

}  // namespace

void expect_fit(const ExpandedMission& mission, const ReadyRun& ready) {
  for (const Requirement& wanted : mission.requirements)
    for (std::size_t i = 0; i < ready.agents.size(); ++i) {
      const Agent& agent = ready.agents[i];
      if (agent.name != wanted.agent) continue;
      expect_kind(wanted, *agent.vehicle);
      expect_instruments(wanted, *agent.vehicle);
      expect_depth(wanted, agent);
      expect_reach(wanted, ready, i);
      expect_energy(wanted, agent, ready.states[i].vehicle.body.position_m);
    }
}

}  // namespace slackwater::twin
