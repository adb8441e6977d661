#include "twin/helm/refusal.h"

#include <cmath>

#include "fields/base/text.h"
#include "twin/agent/agent.h"
#include "twin/control/velocity_range.h"
#include "twin/scene/structure.h"
#include "twin/vehicle/actuator_channels.h"

namespace slackwater::twin {
namespace {

using Answer = std::optional<Refusal>;

/// What a door gives in round numbers is meant.
constexpr double rounding = 1.005;
constexpr double touch_m = 1e-3;  ///< a way that touches a structure does not lead through it

Refusal no(RefusalReason reason, std::string text) { return {reason, std::move(text)}; }

/// Every number of a command in words of its own, to be looked at one by one.
template <typename Look>
Answer each_number(const CommandWhat& what, const Look& look) {
  if (const auto* set = std::get_if<SetVelocity>(&what)) {
    const HelmVelocity& v = set->velocity;
    for (const auto& [name, value] :
         {std::pair{"surge", v.surge_m_s}, std::pair{"sway", v.sway_m_s},
          std::pair{"heave", v.heave_m_s}, std::pair{"yaw rate", v.yaw_rate_rad_s}})
      if (Answer answer = look(std::string(name), value)) return answer;
  } else if (const auto* by_hand = std::get_if<SetThrusters>(&what)) {
    for (std::size_t i = 0; i < by_hand->share.size(); ++i)
      if (Answer answer = look("thruster " + std::to_string(i + 1), by_hand->share[i]))
        return answer;
  } else if (const auto* reroute = std::get_if<Reroute>(&what)) {
    for (std::size_t i = 0; i < reroute->waypoints.size(); ++i) {
      const auto& [at_m, speed_m_s, over_ground] = reroute->waypoints[i];
      for (const double value : {at_m.x, at_m.y, at_m.z, speed_m_s, over_ground})
        if (Answer answer = look("waypoint " + std::to_string(i + 1), value)) return answer;
    }
  }
  return std::nullopt;
}

Answer look_at_numbers(const CommandWhat& what) {
  return each_number(what, [](const std::string& name, double value) -> Answer {
    if (std::isfinite(value)) return std::nullopt;
    return no(RefusalReason::not_finite,
              formatted("{}: found {}, expected a finite number", name, value));
  });
}

Answer look_at_standing(const Command& command, const Agent& agent, const Standing& standing) {
  if (standing.halt != Halt::none)
    return no(RefusalReason::vehicle_halted,
              formatted("{} has stopped: {} at {:g} s of the run; command another vehicle",
                        agent.name, name_of(standing.halt), standing.halted_at_s));
  if (standing.is_aboard)
    return no(RefusalReason::vehicle_not_free,
              formatted("{} is aboard; wait until its mission launches it", agent.name));
  if (standing.must_come_home && leads_elsewhere(command.what))
    return no(
        RefusalReason::vehicle_not_free,
        formatted("{} must come home to keep its reserve: found {:.4g} J left, and the way home "
                  "takes {:.4g} J besides margin and reserve; wait until it is nearer to home",
                  agent.name, standing.energy_left_j, standing.energy_home_j));
  return std::nullopt;
}

Answer look_at_age(const Command& command, const Agent& agent,
                   std::optional<std::uint64_t> last_sequence, double now_s,
                   const RefusalLimits& limits) {
  if (last_sequence && command.sequence <= *last_sequence)
    return no(RefusalReason::stale, formatted("found sequence {}, expected more than {}, the last "
                                              "that {} had from this source; count upwards",
                                              command.sequence, *last_sequence, agent.name));
  constexpr std::uint64_t most_sequence = 9007199254740992;  // 2^53: what a log holds exactly
  if (command.sequence > most_sequence)
    return no(RefusalReason::out_of_range,
              formatted("found sequence {}, expected at most {}; count from 1", command.sequence,
                        most_sequence));
  if (!must_be_renewed(command.what) || std::abs(now_s - command.received_s) <= limits.oldest_s)
    return std::nullopt;
  return no(RefusalReason::stale,
            formatted("came in at {:g} s of the run, and now it is {:g} s: velocity, thrusters and "
                      "actuators are valid for {:g} s; send a new one",
                      command.received_s, now_s, limits.oldest_s));
}

Answer look_at_thrusters(const SetThrusters& set, const Agent& agent) {
  if (set.share.size() != agent.vehicle->mounts)
    return no(
        RefusalReason::wrong_count,
        formatted("found {} thrusters, expected {}: one for each of a {}, in the order of its "
                  "file",
                  set.share.size(), agent.vehicle->mounts, agent.vehicle->name));
  for (std::size_t i = 0; i < set.share.size(); ++i)
    if (std::abs(set.share[i]) > 1)
      return no(RefusalReason::out_of_range,
                formatted("thruster {}: found {:g}, expected -1 to 1", i + 1, set.share[i]));
  return std::nullopt;
}

Answer look_at_actuators(const SetActuators& set, const Agent& agent) {
  const Vehicle& vehicle = *agent.vehicle;
  const std::string has = formatted("a {} has {}", vehicle.name, channel_names(vehicle));
  bool has_any = false;
  for (std::size_t i = 0; i < most_channels; ++i) {
    if (!set.given.has(i)) continue;
    has_any = true;
    const auto channel = channel_of(vehicle, i);
    if (!channel)
      return no(RefusalReason::out_of_range,
                formatted("actuators: found channel {}, and {}; name those", i + 1, has));
    const double value = set.given.value[i];
    if (!std::isfinite(value))
      return no(RefusalReason::not_finite,
                formatted("{}: found {}, expected a finite number", channel->name, value));
    const double least = set.is_physical ? channel->least : -1;
    const double most = set.is_physical ? channel->most : 1;
    if (set.is_physical ? channel->reaches(value) : std::abs(value) <= 1) continue;
    return no(RefusalReason::out_of_range,
              formatted("{}: found {:g}, expected {:g} to {:g} {}", channel->name, value, least,
                        most, set.is_physical ? symbol_of(channel->unit) : "of its range"));
  }
  if (has_any) return std::nullopt;
  return no(RefusalReason::wrong_count,
            formatted("actuators: found none, expected one at least: {}", has));
}

Answer look_at_velocity(const SetVelocity& set, const Agent& agent) {
  const VelocityRange range = velocity_range(*agent.autopilot);
  const HelmVelocity& v = set.velocity;
  const auto within = [&](const char* name, double value, double low, double high,
                          const char* unit) -> Answer {
    if (value >= rounding * low && value <= rounding * high) return std::nullopt;
    return no(RefusalReason::out_of_range,
              formatted("{}: found {:g} {}, expected {:g} to {:g} {}, the limits of a {}", name,
                        value, unit, low, high, unit, agent.vehicle->name));
  };
  if (Answer answer =
          within("surge", v.surge_m_s, range.least_ahead_m_s, range.most_ahead_m_s, "m/s ahead"))
    return answer;
  if (Answer answer = within("sway", v.sway_m_s, -range.most_sideways_m_s, range.most_sideways_m_s,
                             "m/s to starboard"))
    return answer;
  if (Answer answer =
          within("heave", v.heave_m_s, -range.most_up_m_s, range.most_down_m_s, "m/s down"))
    return answer;
  if (Answer answer = within("surge and sway", std::hypot(v.surge_m_s, v.sway_m_s), 0,
                             range.most_along_m_s, "m/s together"))
    return answer;
  return within("yaw rate", v.yaw_rate_rad_s, -range.most_turn_rad_s, range.most_turn_rad_s,
                "rad/s to starboard");
}

/// Whether a vehicle can be at a place, and go to it.
class PlaceLooker {
 public:
  PlaceLooker(const Agent& agent, double now_s)
      : agent_(agent),
        now_s_(now_s),
        flies_(agent.vehicle->kind == VehicleKind::uav),
        floats_(agent.vehicle->body.hull.strips > 0) {}

  [[nodiscard]] Answer look(const Reroute& reroute) const {
    for (std::size_t i = 0; i < reroute.waypoints.size(); ++i) {
      const Waypoint& waypoint = reroute.waypoints[i];
      const std::string name = "waypoint " + std::to_string(i + 1);
      if (Answer answer = look_at_place(waypoint.position_m, name)) return answer;
      if (Answer answer = look_at_speed(waypoint, name)) return answer;
      if (i > 0 || reroute.loop) {
        const Waypoint& before = i > 0 ? reroute.waypoints[i - 1] : reroute.waypoints.back();
        if (Answer answer = look_at_way(before.position_m, waypoint.position_m, name))
          return answer;
      }
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] Triple<double> met(const Triple<double>& at_m) const {
    return {at_m.x, at_m.y, floats_ ? 0.0 : at_m.z};
  }

  [[nodiscard]] Answer refuse(const std::string& name, const Triple<double>& at_m,
                              const std::string& why) const {
    return no(RefusalReason::no_place,
              formatted("{}: {:.1f} m north, {:.1f} m east of the origin, {:.1f} m deep {}", name,
                        at_m.x, at_m.y, at_m.z, why));
  }

  [[nodiscard]] Answer look_at_place(const Triple<double>& at_m, const std::string& name) const {
    const Vehicle& vehicle = *agent_.vehicle;
    for (const double value : {at_m.x, at_m.y, at_m.z})
      if (std::abs(value) > farthest_from_origin_m)
        return no(RefusalReason::no_place,
                  formatted("{}: found {:g} m, expected at most {:g} m from the origin of the "
                            "scenario; move it nearer",
                            name, value, farthest_from_origin_m));
    if (flies_ && at_m.z > 0)
      return refuse(name, at_m,
                    "is below the sea surface, but this vehicle flies; give a height above it");
    if (!flies_ && !floats_ && at_m.z < 0)
      return refuse(name, at_m,
                    "is above the sea surface, but this vehicle swims; give a depth below it");
    if (vehicle.rated_depth_m && at_m.z > *vehicle.rated_depth_m)
      return refuse(
          name, at_m,
          formatted("is deeper than the {:g} m that a {} is rated for; give a smaller depth",
                    *vehicle.rated_depth_m, vehicle.name));
    const auto& structures = agent_.water->environment().structures;
    for (std::size_t i = 0; i < structures.size(); ++i)
      if (signed_distance_m(structures[i], met(at_m)) < -touch_m)
        return refuse(name, at_m,
                      formatted("lies in structure {} of the scenario; move it out", i + 1));
    const SampleStatus status =
        flies_ ? agent_.water->wind(at_m, now_s_).status
               : agent_.water->current(met(at_m), vehicle.body.height_m, now_s_).status;
    if (!has_value(status))
      return refuse(name, at_m,
                    formatted("is {} ({}); move it into the water of the forecast", name_of(status),
                              agent_.water->environment().field->range().text()));
    return std::nullopt;
  }

  [[nodiscard]] Answer look_at_way(const Triple<double>& from_m, const Triple<double>& to_m,
                                   const std::string& name) const {
    const auto& structures = agent_.water->environment().structures;
    for (std::size_t i = 0; i < structures.size(); ++i)
      if (least_distance_m(structures[i], met(from_m), met(to_m)) < -touch_m)
        return refuse(name, to_m,
                      formatted("is reached through structure {} of the scenario; give "
                                "waypoints round it",
                                i + 1));
    return std::nullopt;
  }

  [[nodiscard]] Answer look_at_speed(const Waypoint& waypoint, const std::string& name) const {
    if (waypoint.speed_m_s == 0) return std::nullopt;  // as the vehicle's settings say
    const bool is_over_ground = waypoint.over_ground > 0;
    const bool is_carried = is_over_ground && !flies_ && agent_.vehicle->kind != VehicleKind::rov;
    const double most_m_s = (is_carried ? 2 : 1) * agent_.mission.pursuit.most_speed_m_s;
    const bool must_have_way = agent_.vehicle->kind == VehicleKind::auv && !is_over_ground;
    const double least_m_s = must_have_way ? agent_.autopilot->settings.least_speed_m_s : 0.0;
    if (waypoint.speed_m_s >= least_m_s && waypoint.speed_m_s > 0 &&
        waypoint.speed_m_s <= rounding * most_m_s)
      return std::nullopt;
    return no(RefusalReason::out_of_range,
              formatted("{}: found {:g} m/s, expected {:g} to {:.3g} m/s of a {}, or 0 for its own "
                        "speed",
                        name, waypoint.speed_m_s, least_m_s, most_m_s, agent_.vehicle->name));
  }

  const Agent& agent_;
  double now_s_;
  bool flies_;
  bool floats_;
};

Answer look_at_waypoints(const Reroute& reroute, const Agent& agent, double now_s,
                         const RefusalLimits& limits) {
  if (reroute.waypoints.size() > limits.most_waypoints)
    return no(RefusalReason::too_many,
              formatted("found {} waypoints, expected at most {}; send the next part when this one "
                        "is done",
                        reroute.waypoints.size(), limits.most_waypoints));
  return PlaceLooker(agent, now_s).look(reroute);
}

}  // namespace

const char* name_of(RefusalReason reason) noexcept {
  switch (reason) {
    case RefusalReason::unknown_vehicle:
      return "unknown_vehicle";
    case RefusalReason::unauthorised:
      return "unauthorised";
    case RefusalReason::stale:
      return "stale";
    case RefusalReason::not_finite:
      return "not_finite";
    case RefusalReason::out_of_range:
      return "out_of_range";
    case RefusalReason::wrong_count:
      return "wrong_count";
    case RefusalReason::too_many:
      return "too_many";
    case RefusalReason::no_place:
      return "no_place";
    case RefusalReason::vehicle_halted:
      return "vehicle_halted";
    case RefusalReason::vehicle_not_free:
      return "vehicle_not_free";
    case RefusalReason::unknown_model:
      return "unknown_model";
    case RefusalReason::bad_name:
      return "bad_name";
    case RefusalReason::unreadable:
      return "unreadable";
  }
  return "unknown";
}

std::optional<RefusalReason> refusal_reason_of(std::string_view name) noexcept {
  for (int i = 0; i <= static_cast<int>(RefusalReason::unreadable); ++i)
    if (const auto reason = static_cast<RefusalReason>(i); name == name_of(reason)) return reason;
  return std::nullopt;
}

std::optional<Refusal> refusal_of(const Command& command, const Agent& agent,
                                  const Standing& standing,
                                  std::optional<std::uint64_t> last_sequence, double now_s,
                                  const RefusalLimits& limits) {
  if (Answer answer = look_at_standing(command, agent, standing)) return answer;
  if (Answer answer = look_at_age(command, agent, last_sequence, now_s, limits)) return answer;
  if (Answer answer = look_at_numbers(command.what)) return answer;
  if (const auto* set = std::get_if<SetThrusters>(&command.what))
    return look_at_thrusters(*set, agent);
  if (const auto* set = std::get_if<SetActuators>(&command.what))
    return look_at_actuators(*set, agent);
  if (const auto* set = std::get_if<SetVelocity>(&command.what))
    return look_at_velocity(*set, agent);
  if (const auto* reroute = std::get_if<Reroute>(&command.what))
    return look_at_waypoints(*reroute, agent, now_s, limits);
  if (std::holds_alternative<PointCamera>(command.what))
    if (const std::string_view problem = unsoundness_of(command, agent); !problem.empty())
      return no(RefusalReason::out_of_range, formatted("{}; turn the vehicle", problem));
  return std::nullopt;
}

}  // namespace slackwater::twin
