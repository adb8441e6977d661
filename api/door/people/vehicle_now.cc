#include "api/door/people/vehicle_now.h"

#include <algorithm>
#include <cmath>

#include "twin/agent/conduct.h"
#include "twin/agent/hung_line.h"
#include "twin/body/attitude.h"

namespace slackwater::people {
namespace {

constexpr std::size_t most_waypoints = 200;  ///< that are shown
constexpr double reserve_every_s = 1;

float narrow(double value) { return static_cast<float>(value); }

bool flies(const twin::Agent& agent) { return agent.vehicle->kind == twin::VehicleKind::uav; }

/// Of the water where it is, without waves; of the air for what flies. NED.
twin::Triple<double> stream_at(const twin::Agent& agent, const twin::AgentState& state,
                               double t_s) {
  if (flies(agent)) return state.wind_m_s;
  const twin::Triple<double>& at_m = state.vehicle.body.position_m;
  const twin::Triple<double> wet_m{at_m.x, at_m.y, std::max(at_m.z, 0.0)};
  return agent.water->current(wet_m, agent.vehicle->body.height_m, t_s).current_m_s;
}

/// What carries it beside what a stick asks for: one that flies is asked over ground, all else
/// through the water. Who steers by instruments knows the current by these alone.
twin::Measured known_with_stream(const twin::Agent& agent, const twin::AgentState& state,
                                 const twin::Triple<double>& stream_m_s) {
  twin::Measured known = twin::known_of(agent, state);
  if (flies(agent))
    known.water_m_s = {};
  else if (!agent.navigation || !agent.navigation->steers)
    known.water_m_s = stream_m_s;
  return known;
}

Pose pose_of(const twin::Agent& agent, const twin::AgentState& state, std::size_t place,
             const twin::Triple<double>& stream_m_s) {
  const twin::Triple<double>& at_m = state.vehicle.body.position_m;
  const twin::EulerAngles turned = twin::euler_angles(state.vehicle.body.attitude);
  const auto over_ground =
      twin::rotation_of(state.vehicle.body.attitude).to_ned(state.vehicle.body.nu.linear);
  const BedSample bed = agent.water->bed(at_m);
  Pose pose;
  pose.east_m = narrow(at_m.y);
  pose.north_m = narrow(at_m.x);
  pose.up_m = narrow(-at_m.z);
  pose.roll_rad = narrow(turned.roll_rad);
  pose.pitch_rad = narrow(turned.pitch_rad);
  pose.heading_rad = narrow(turned.yaw_rad);
  pose.east_m_s = narrow(over_ground.y);
  pose.north_m_s = narrow(over_ground.x);
  pose.up_m_s = narrow(-over_ground.z);
  pose.current_east_m_s = narrow(stream_m_s.y);
  pose.current_north_m_s = narrow(stream_m_s.x);
  pose.bed_m = bed.status == SampleStatus::ok ? narrow(bed.water_depth_m - at_m.z) : std::nanf("");
  pose.charge = agent.vehicle->battery ? narrow(state.vehicle.battery.charge) : std::nanf("");
  pose.vehicle = static_cast<std::uint16_t>(place);
  pose.is_halted = state.halt != twin::Halt::none;
  return pose;
}

/// What each thruster gave in the last step, as a share of what it can.
std::vector<double> thrust_of(const twin::Agent& agent, const twin::AgentState& state) {
  const twin::Allocation& can = agent.autopilot->allocation;
  std::vector<double> shares;
  for (std::size_t i = 0; i < agent.vehicle->mounts; ++i) {
    const double thrust_n = state.vehicle.thrust_n[i];
    const double most_n = thrust_n < 0 ? -can.least_n[i] : can.most_n[i];
    shares.push_back(most_n > 0 ? std::clamp(thrust_n / most_n, -1.0, 1.0) : 0);
  }
  return shares;
}

/// When a hold for want of a helm becomes the way home.
std::optional<double> home_at_s(const twin::Agent& agent, const twin::HelmState& helm) {
  const bool is_for_want =
      helm.mode == twin::HelmMode::hold &&
      (helm.cause == twin::HelmCause::not_renewed || helm.cause == twin::HelmCause::client_lost);
  if (!is_for_want || !(agent.helm.home_after_s > 0)) return std::nullopt;
  return helm.since_s + agent.helm.home_after_s;
}

}  // namespace

RunNow RunLook::look() {
  twin::Run& run = hand_.run;
  const auto agents = run.agents();
  const auto states = run.states();
  RunNow now{run.time_s(), run.steps_made(), agents.data(), {}, {}};
  for (std::size_t i = advice_.size(); i < agents.size(); ++i) {
    advice_.emplace_back(states[i], now.time_s);
    reserve_.emplace_back();
    looks_.emplace_back();
    reserve_at_s_ = -1;
  }
  const bool looks_at_reserve =
      reserve_at_s_ < 0 || now.time_s >= reserve_at_s_ + reserve_every_s - 1e-6;
  if (looks_at_reserve) {
    reserve_at_s_ = now.time_s;
    around_ = std::make_shared<const Surroundings>(
        surroundings_of(run_place(hand_), now.time_s, places_of(states)));
  }
  now.around = around_;
  const auto& alarms = hand_.watch.state().alarms;
  now.vehicles.resize(agents.size());
  for (std::size_t i = 0; i < agents.size(); ++i) {
    const twin::Agent& agent = agents[i];
    const twin::AgentState& state = states[i];
    VehicleNow& vehicle = now.vehicles[i];
    const twin::Triple<double> stream_m_s = stream_at(agent, state, now.time_s);
    vehicle.pose = pose_of(agent, state, i, stream_m_s);
    vehicle.known = known_with_stream(agent, state, stream_m_s);
    vehicle.home_m = agent.carrier   ? state.conduct.boarding_m
                     : agent.conduct ? agent.conduct->home_m
                                     : state.helm.start_m;
    vehicle.mode = state.helm.mode;
    vehicle.cause = state.helm.cause;
    vehicle.home_at_s = home_at_s(agent, state.helm);
    vehicle.words = live::mission_words(agent, state, "");
    vehicle.waypoints = live::waypoints_left(state);
    if (vehicle.waypoints.size() > most_waypoints) vehicle.waypoints.resize(most_waypoints);
    if (looks_at_reserve) {
      if (agent.inspection)
        looks_[i] = std::make_shared<const twin::InspectionState>(state.inspection);
      const auto at = hand_.start + Duration(static_cast<Duration::rep>(1000 * now.time_s));
      reserve_[i] = advice_[i].look(agent, state, at, now.time_s);
    }
    vehicle.margin_s = reserve_[i].margin_s;
    vehicle.advice = reserve_[i].advice;
    vehicle.camera = state.helm.camera;
    if (agent.conduct && agent.conduct->plan.mammals)
      vehicle.zone = {state.conduct.mammals.noise_m, agent.conduct->plan.mammals->noise.radius_m};
    if (twin::has_line_out(agent, state)) {
      const auto line = twin::hung_line(agent, state);
      vehicle.line_m.assign(line.begin(), line.end());
    }
    vehicle.thrust = thrust_of(agent, state);
    vehicle.looks = looks_[i];
    if (i >= alarms.size()) continue;
    for (const twin::Alarm& alarm : alarms[i])
      vehicle.alarms.push_back({alarm, twin::name_of_vessel(hand_.vessels, alarm.id), {}});
  }
  return now;
}

}  // namespace slackwater::people
