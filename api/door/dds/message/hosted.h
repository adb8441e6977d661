#pragma once
#include <string>
#include <vector>

#include "api/door/dds/message/bytes.h"
#include "twin/run/run.h"

namespace slackwater::dds {

// The protocol with processes that host an agent or the physics of a vehicle, version 1. In each
// step they are told once and answer once, with the number of the step.

inline constexpr std::uint32_t host_version = 1;
/// Who leaves gives back all that it hosts of the vehicle.
enum class HostRole : std::uint8_t { leave = 0, agent = 1, physics = 2 };

/// slackwater_msgs/msg/HostRequest; all readers throw Error(invalid_input) for bytes that are none.
struct HostAsked {
  std::uint64_t token = 0;  ///< of the client's choice, in the answer too
  std::uint32_t version = 0;
  std::uint8_t role = 0;
  double timeout_s = 0;  ///< for each answer, by the clock on the wall
};
[[nodiscard]] HostAsked read_host_request(Payload request);
/// slackwater_msgs/msg/HostAnswer.
[[nodiscard]] Bytes host_answer(std::uint64_t token, bool success, const std::string& message,
                                double step_s);

/// slackwater_msgs/msg/AgentObservation.
[[nodiscard]] Bytes agent_observation(const twin::Agent& agent, const twin::AgentState& state,
                                      std::uint64_t step, const std::string& name,
                                      const Stamp& stamp);
/// What an agent asks for; body axes forward, right, down, places NED.
struct AgentAsked {
  std::uint64_t step = 0;
  std::uint8_t kind = 0;
  twin::Spatial<double> velocity;
  std::vector<double> thrusters;
  std::vector<twin::Triple<double>> places_m;
};
[[nodiscard]] AgentAsked read_agent_command(Payload message);

/// slackwater_msgs/msg/PhysicsInput.
[[nodiscard]] Bytes physics_input(const twin::HostedStep& step, const std::string& name,
                                  const Stamp& stamp);
/// What hosted physics made of a step; NED and body axes forward, right, down.
struct PhysicsMade {
  std::uint64_t step = 0;
  std::uint8_t kind = 0;  ///< 1: a state, 2: a wrench
  twin::BodyState<double> body;
  twin::Spatial<double> wrench;
  double power_w = 0;
};
[[nodiscard]] PhysicsMade read_physics_output(Payload message);

}  // namespace slackwater::dds
