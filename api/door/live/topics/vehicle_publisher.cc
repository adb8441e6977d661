#include "api/door/live/topics/vehicle_publisher.h"

#include <nlohmann/json.hpp>

#include "twin/agent/conduct.h"

namespace slackwater::live {
namespace {

using twin::Agent;
using twin::AgentState;

/// Steps of the instruments between which it spoke, so far.
std::uint64_t times_spoken(std::uint64_t every, std::uint64_t steps) {
  return every == 0 || steps == 0 ? 0 : (steps - 1) / every + 1;
}

const twin::Route& route_of(const AgentState& state) {
  return state.helm.is_helmed() ? state.helm.way.route : twin::way_of(state).route;
}

WayAhead way_ahead(const AgentState& state) {
  const twin::Route& route = route_of(state);
  WayAhead way{state.helm.mode, state.conduct.doing, 0, state.mission.task,
               route.next(),    route.is_done(),     {}};
  if (state.helm.mode == twin::HelmMode::waypoints) way.since_s = state.helm.renewed_s;
  if (!route.is_done()) {
    const twin::Triple<double>& to_m = route.to().position_m;
    way.to_m = {to_m.x, to_m.y, to_m.z};
  }
  return way;
}

const char* doing_of(const Agent& agent, const AgentState& state) {
  if (state.halt != twin::Halt::none) return "halted";
  if (state.helm.is_helmed()) return twin::name_of(state.helm.mode);
  if (state.conduct.is_aboard) return "aboard";
  if (agent.conduct && state.conduct.has_ended) return "ended";
  if (state.mission.is_done) return "done";
  switch (state.conduct.doing) {
    case twin::Doing::hold:
      return "hold";
    case twin::Doing::way_back:
      return "way_back";
    case twin::Doing::way_home:
      return "home";
    default:
      return "task";
  }
}

}  // namespace

MissionWords mission_words(const Agent& agent, const AgentState& state, const std::string& holder) {
  MissionWords words;
  words.doing = doing_of(agent, state);
  words.authority = holder;
  words.task = state.mission.task;
  words.tasks = agent.mission.tasks.size();
  words.waypoints_taken =
      state.helm.is_helmed() ? state.helm.way.waypoints_taken : state.mission.waypoints_taken;
  words.halt = twin::name_of(state.halt);
  if (state.helm.is_helmed())
    words.cause = twin::name_of(state.helm.cause);
  else if (agent.conduct)
    words.cause = twin::name_of(state.conduct.cause);
  if (agent.conduct) words.phase = twin::name_of(state.conduct.phase);
  return words;
}

std::string MissionWords::json() const {
  nlohmann::json json{{"doing", doing}, {"authority", authority},
                      {"task", task},   {"tasks", tasks},
                      {"halt", halt},   {"waypoints_taken", waypoints_taken}};
  if (!cause.empty()) json["cause"] = cause;
  if (!phase.empty()) json["phase"] = phase;
  return json.dump();
}

std::vector<twin::Waypoint> waypoints_left(const AgentState& state) {
  twin::Route route = route_of(state);
  std::vector<twin::Waypoint> left;
  for (; !route.is_done(); route.skip()) left.push_back(route.to());
  return left;
}

VehiclePublisher::VehiclePublisher(Stream& stream, const RunPlace& place, std::string name,
                                   const Agent& agent, const AgentState& at_start, double t_s)
    : stream_(stream), place_(place), name_(std::move(name)), advice_(at_start, t_s) {
  const auto open = [&](const char* what, const char* type, const bag::Quality& quality) {
    return stream.open("/" + name_ + "/" + what, type, quality);
  };
  odometry_ = open("odometry", "nav_msgs/msg/Odometry", state_quality);
  pose_ = open("pose", "geometry_msgs/msg/PoseStamped", state_quality);
  battery_ = open("battery_state", "sensor_msgs/msg/BatteryState", latched_quality);
  reserve_ = open("reserve", "slackwater_msgs/msg/Reserve", state_quality);
  mission_ = open("mission_state", "std_msgs/msg/String", latched_quality);
  waypoints_ = open("active_waypoints", "nav_msgs/msg/Path", latched_quality);
  if (agent.navigation) {
    const twin::SensorSuite& has = agent.navigation->instruments;
    constexpr const char* twist = "geometry_msgs/msg/TwistWithCovarianceStamped";
    imu_ = open("imu", "sensor_msgs/msg/Imu", state_quality);
    if (has.gnss_every > 0) fix_ = open("nav_sat_fix", "sensor_msgs/msg/NavSatFix", state_quality);
    if (has.depth_every > 0)
      pressure_ = open("fluid_pressure", "sensor_msgs/msg/FluidPressure", state_quality);
    if (has.dvl_every > 0) {
      dvl_ = open("dvl", twist, state_quality);
      dvl_water_ = open("dvl_water", twist, state_quality);
    }
    looked_ = at_start.navigation.instruments.steps;
  }
}

void VehiclePublisher::speak(const Agent& agent, const AgentState& state, const std::string& holder,
                             double t_s) {
  const dds::Stamp stamp = dds::stamp_of(place_.epoch, t_s);
  const auto say = [&](ChannelId channel, const auto& message) {
    if (stream_.is_wanted(channel)) stream_.publish(channel, stamp, message());
  };
  say(odometry_, [&] { return dds::odometry(agent, state, name_, stamp); });
  say(pose_, [&] { return dds::pose(state, stamp); });
  if (agent.navigation) speak_of_instruments(agent, state, stamp);
  const int status = dds::battery_status(state);
  const bool is_second = second_s_ < 0 || t_s >= second_s_ + 1 - 1e-6;
  if (is_second || status != battery_status_) {
    say(battery_, [&] { return dds::battery_state(agent, state, name_, stamp); });
    battery_status_ = status;
  }
  if (is_second) {
    second_s_ = t_s;
    say(reserve_, [&] {
      return dds::reserve(advice_.look(agent, state, dds::time_of(stamp), t_s), name_, stamp);
    });
  }
  speak_of_changes(agent, state, holder, stamp);
}

void VehiclePublisher::speak_of_instruments(const Agent& agent, const AgentState& state,
                                            const dds::Stamp& stamp) {
  const twin::SensorSuite& has = agent.navigation->instruments;
  const std::uint64_t steps = state.navigation.instruments.steps;
  const auto say = [&](std::uint64_t every, ChannelId channel, const auto& message) {
    if (times_spoken(every, steps) > times_spoken(every, looked_) && stream_.is_wanted(channel))
      stream_.publish(channel, stamp, message());
  };
  say(1, imu_, [&] { return dds::imu(agent, state, name_, stamp); });
  say(has.gnss_every, fix_,
      [&] { return dds::nav_sat_fix(state, place_.origin, place_.geoid_m, name_, stamp); });
  say(has.depth_every, pressure_, [&] {
    return dds::fluid_pressure(state, agent.vehicle->body.fluid_density_kg_m3, name_, stamp);
  });
  say(has.dvl_every, dvl_, [&] { return dds::dvl(agent, state, name_, stamp); });
  say(has.dvl_every, dvl_water_, [&] { return dds::dvl_water(agent, state, name_, stamp); });
  looked_ = steps;
}

void VehiclePublisher::speak_of_changes(const Agent& agent, const AgentState& state,
                                        const std::string& holder, const dds::Stamp& stamp) {
  if (MissionWords now = mission_words(agent, state, holder); now != mission_said_) {
    stream_.publish(mission_, stamp, dds::text(now.json()));
    mission_said_ = std::move(now);
  }
  if (const WayAhead now = way_ahead(state); now != way_said_) {
    way_said_ = now;
    stream_.publish(waypoints_, stamp, dds::active_waypoints(waypoints_left(state), stamp));
  }
}

}  // namespace slackwater::live
