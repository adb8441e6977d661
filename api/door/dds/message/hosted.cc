#include "api/door/dds/message/hosted.h"

#include "api/door/dds/message/cdr.h"
#include "api/door/dds/message/path_message.h"
#include "slackwater_msgs.h"

namespace slackwater::dds {
namespace {

using geometry_msgs::msg::Vector3;

twin::Spatial<double> spatial_of(const geometry_msgs::msg::Twist& twist) {
  twin::Spatial<double> nu;
  nu.linear = flu_frd(triple_of(twist.linear()));
  nu.angular = flu_frd(triple_of(twist.angular()));
  return nu;
}

/// slackwater_msgs/msg/AgentCommand, its lists read one by one.
struct CommandAsked {
  AgentAsked asked;
  void deserialize(eprosima::fastcdr::Cdr& cdr) {
    geometry_msgs::msg::Twist velocity;
    cdr >> asked.step >> asked.kind;
    velocity.deserialize(cdr);
    asked.velocity = spatial_of(velocity);
    for_each_element<double>(cdr, [&](double share) { asked.thrusters.push_back(share); });
    PathAsked path;
    path.deserialize(cdr);
    asked.places_m = std::move(path.places_m);
  }
};

}  // namespace

HostAsked read_host_request(Payload request) {
  const auto asked = decoded<slackwater_msgs::msg::HostRequest>(request);
  return {asked.token(), asked.version(), asked.role(), asked.timeout_s()};
}

Bytes host_answer(std::uint64_t token, bool success, const std::string& message, double step_s) {
  slackwater_msgs::msg::HostAnswer reply;
  reply.token(token);
  reply.success(success);
  reply.message(message);
  reply.version(host_version);
  reply.step_s(step_s);
  return encoded(reply);
}

Bytes agent_observation(const twin::Agent& agent, const twin::AgentState& state, std::uint64_t step,
                        const std::string& name, const Stamp& stamp) {
  const twin::Measured known = twin::known_of(agent, state);
  slackwater_msgs::msg::AgentObservation message;
  message.header(header_message(stamp, name + "/base_link"));
  message.step(step);
  message.pose(pose_message(known.position_m, known.attitude));
  message.twist(twist_message(known.nu));
  message.state_of_charge(state.vehicle.battery.charge);
  message.voltage(state.vehicle.bus_voltage_v);
  message.altitude_m(known.altitude_m);
  message.doing(state.halt != twin::Halt::none ? "halted" : twin::name_of(state.helm.mode));
  return encoded(message);
}

AgentAsked read_agent_command(Payload message) { return decoded<CommandAsked>(message).asked; }

Bytes physics_input(const twin::HostedStep& step, const std::string& name, const Stamp& stamp) {
  const twin::BodyState<double>& body = step.state.vehicle.body;
  const twin::VehicleCommand<double>& command = step.input.command;
  const twin::FluidMotion<double>& water = step.input.around.water;
  slackwater_msgs::msg::PhysicsInput message;
  message.header(header_message(stamp, name + "/base_link"));
  message.step(step.time.step);
  message.dt_s(step.time.length_s);
  message.pose(pose_message(body.position_m, body.attitude));
  message.twist(twist_message(body.nu));
  message.thrusters().assign(
      command.thruster.begin(),
      command.thruster.begin() + static_cast<std::ptrdiff_t>(step.agent.vehicle->mounts));
  message.rudder_rad(command.rudder_rad);
  message.elevator_rad(command.elevator_rad);
  message.moving_mass_m(command.moving_mass_m);
  message.volume_m3(command.volume_m3);
  message.water_velocity(xyz_message<Vector3>(enu_ned(water.velocity_m_s)));
  message.water_acceleration(xyz_message<Vector3>(enu_ned(water.acceleration_m_s2)));
  message.wind(xyz_message<Vector3>(enu_ned(step.input.around.wind_m_s)));
  message.elevation_m(water.elevation_m);
  return encoded(message);
}

PhysicsMade read_physics_output(Payload message) {
  const auto made = decoded<slackwater_msgs::msg::PhysicsOutput>(message);
  PhysicsMade out;
  out.step = made.step();
  out.kind = made.kind();
  const geometry_msgs::msg::Quaternion& q = made.pose().orientation();
  out.body.position_m = enu_ned(triple_of(made.pose().position()));
  out.body.attitude = enu_flu_ned_frd({q.w(), q.x(), q.y(), q.z()});
  out.body.nu = spatial_of(made.twist());
  out.wrench.linear = flu_frd(triple_of(made.wrench().force()));
  out.wrench.angular = flu_frd(triple_of(made.wrench().torque()));
  out.power_w = made.power_w();
  return out;
}

}  // namespace slackwater::dds
