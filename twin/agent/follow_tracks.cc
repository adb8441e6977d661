#include "twin/agent/follow_tracks.h"

#include <algorithm>
#include <cmath>

#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

std::string called(std::uint32_t mmsi, const std::string& name) {
  return std::to_string(mmsi) + (name.empty() ? "" : " (" + name + ")");
}

std::string some_of(std::span<const TrafficVessel> vessels) {
  constexpr std::size_t most = 8;
  if (vessels.empty())
    return "there are none: check the logs of the traffic, their `starts` and the origin";
  std::string text = "known are ";
  for (std::size_t i = 0; i < std::min(most, vessels.size()); ++i)
    text += (i > 0 ? ", " : "") + called(vessels[i].id, vessels[i].name);
  if (vessels.size() > most) text += " and " + std::to_string(vessels.size() - most) + " more";
  return text;
}

/// The one piece of a vessel's track that has something of the run's time.
const TrafficVessel& vessel_of(const TrackToFollow& follow, std::span<const TrafficVessel> vessels,
                               double duration_s) {
  std::vector<const TrafficVessel*> all, during;
  for (const TrafficVessel& vessel : vessels) {
    if (vessel.id != follow.mmsi) continue;
    all.push_back(&vessel);
    const auto points = vessel.track.points();
    if (points.front().t_s <= duration_s && points.back().t_s > 0) during.push_back(&vessel);
  }
  if (all.empty()) {
    refuse("found no vessel " + std::to_string(follow.mmsi) +
           " near the origin at the run's time; " + some_of(vessels));
  }
  const std::string name = called(follow.mmsi, all.front()->name);
  if (during.empty()) {
    const auto points = all.front()->track.points();
    refuse("the track of " + name +
           formatted(" lasts from {:.0f} to {:.0f} s of the run's time and the run to {:.0f} s; "
                     "set `starts`: the time in the log at which the run starts",
                     points.front().t_s, points.back().t_s, duration_s));
  }
  if (during.size() > 1) {
    const TrackPoint& from = during[0]->track.points().back();
    const TrackPoint& to = during[1]->track.points().front();
    refuse("the track of " + name +
           formatted(
               " jumps by {:.0f} m between {:.0f} and {:.0f} s of the run, which no vehicle can "
               "follow; let the run start after it or end before it",
               std::hypot(to.position_m.x - from.position_m.x, to.position_m.y - from.position_m.y),
               from.t_s, to.t_s));
  }
  return *during.front();
}

/// Where a track is at the start of the run, with its way on; or where it is first, at rest.
void start_on(const Track& track, ScenarioVehicle& entry) {
  const double t_s = std::max(track.points().front().t_s, 0.0);
  TrackState state = track.at(t_s);
  if (!state.is_known()) {
    // Silent over the start: from its next report on.
    const auto points = track.points();
    const auto next = std::find_if(points.begin(), points.end(),
                                   [&](const TrackPoint& point) { return point.t_s >= t_s; });
    state = track.at(next->t_s);
  }
  const Triple<double>& v = state.velocity_m_s;
  entry.start_m = {state.position_m.x, state.position_m.y, 0};
  if (track.at(0).is_known()) entry.start_speed_m_s = std::hypot(v.x, v.y);
  entry.heading_rad =
      std::hypot(v.x, v.y) > 0.2 ? std::atan2(v.y, v.x) : state.heading_rad.value_or(0);
}

/// The fastest way between two reports of the run's time, neither of which the rule calls apart.
double fastest_m_s(const Track& track, double duration_s) {
  double most = 0;
  const auto points = track.points();
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double period_s = points[i].t_s - points[i - 1].t_s;
    // Reports within seconds of each other tell of the receiver's noise, not of the way.
    constexpr double shortest_s = 10;
    if (points[i].t_s < 0 || points[i - 1].t_s > duration_s || period_s < shortest_s ||
        period_s > TrackRule{}.longest_gap_s)
      continue;
    const Triple<double> way = points[i].position_m - points[i - 1].position_m;
    most = std::max(most, std::hypot(way.x, way.y) / period_s);
  }
  return most;
}

}  // namespace

ScenarioVehicle with_tracks(const ScenarioVehicle& listed, const Vehicle& vehicle,
                            std::span<const TrafficVessel> vessels, double duration_s) {
  ScenarioVehicle entry = listed;
  for (ScenarioTask& task : entry.tasks) {
    if (!task.follow) continue;
    const TrafficVessel& vessel = vessel_of(*task.follow, vessels, duration_s);
    task.follow->name = vessel.name;
    task.follow->track = std::make_shared<const Track>(vessel.track);
  }
  if (entry.starts_on_track) {
    if (vehicle.body.hull.strips == 0)
      refuse("start: a " + vehicle.name +
             " does not float; give it a start with its depth or height");
    start_on(*entry.tasks.front().follow->track, entry);
  }
  return entry;
}

std::vector<std::string> too_fast_tracks(const Agent& agent, double duration_s) {
  std::vector<std::string> out;
  const double most_m_s = agent.mission.pursuit.most_speed_m_s;
  for (const ScenarioTask& task : agent.mission.tasks) {
    if (!task.follow) continue;
    const double fastest = fastest_m_s(*task.follow->track, duration_s);
    if (fastest <= most_m_s) continue;
    out.push_back(
        "vehicle " + agent.name + ": the track of " + called(task.follow->mmsi, task.follow->name) +
        formatted(" goes up to {:.2f} m/s and the vehicle {:.2f} m/s through the water: it will "
                  "fall behind",
                  fastest, most_m_s));
  }
  return out;
}

std::vector<std::uint32_t> followed_by(const Agent& agent) {
  std::vector<std::uint32_t> out;
  for (const ScenarioTask& task : agent.mission.tasks)
    if (task.follow) out.push_back(task.follow->mmsi);
  return out;
}

}  // namespace slackwater::twin
