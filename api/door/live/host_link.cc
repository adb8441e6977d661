#include "api/door/live/host_link.h"

#include "api/door/dds/message/orders.h"
#include "api/door/dds/message/vehicle_messages.h"
#include "api/door/live/host_check.h"
#include "api/door/live/reroute.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::live {
namespace {

constexpr int most_missed = 5;
/// A run stands still for nobody longer than that.
constexpr double longest_s = 10;
constexpr double shortest_s = 0.001;

}  // namespace

std::optional<twin::CommandWhat> command_of(const dds::AgentAsked& asked) {
  const twin::Spatial<double>& v = asked.velocity;
  switch (asked.kind) {
    case 0:
      return std::nullopt;
    case 1:
      return twin::SetVelocity{{v.linear.x, v.linear.y, v.linear.z, v.angular.z}};
    case 2:
      return twin::SetThrusters{asked.thrusters};
    case 3:
      return reroute_to(asked.places_m);
    case 4:
      return twin::HoldHere{};
    case 5:
      return twin::GoHome{};
    case 6:
      return twin::Resume{};
    default:
      throw Error(ErrorKind::invalid_input,
                  formatted("a command of kind {}; kinds are from 0 to 6", int{asked.kind}));
  }
}

dds::Bytes heard_of(const dds::AgentAsked& asked) {
  switch (asked.kind) {
    case 1:
      return dds::velocity_order(asked.velocity);
    case 2:
      return dds::thrusters_order(asked.thrusters);
    case 3:
      return dds::active_waypoints(reroute_to(asked.places_m).waypoints, {});
    default:
      return {};
  }
}

HostLink::HostLink(dds::Participant& participant, twin::Run& run, twin::RunControl& control,
                   CommandDoor& command_door, const RunPlace& place, HostRule rule,
                   std::function<void(const std::string&)> on_trouble)
    : participant_(participant),
      run_(run),
      control_(control),
      command_door_(command_door),
      place_(place),
      rule_(rule),
      on_trouble_(std::move(on_trouble)) {
  participant_.on_lost([this](const std::string& client) { lose(client); });
  run_.at_opening([this](const twin::StepTime& time) { ask_agents(time); });
}

void HostLink::open(const std::string& name) {
  const std::size_t vehicle = hosts_.size();
  const auto topic = [&](const char* what, const char* type) {
    return bag::Channel{"/" + name + "/host/" + what, type, "", state_quality};
  };
  // Without the lock, for which clients' threads may wait that the library waits for.
  const auto answer = participant_.publish_on(topic("answer", "slackwater_msgs/msg/HostAnswer"));
  const auto observation =
      participant_.publish_on(topic("observation", "slackwater_msgs/msg/AgentObservation"));
  const auto input =
      participant_.publish_on(topic("physics_input", "slackwater_msgs/msg/PhysicsInput"));
  {
    const std::lock_guard lock(mutex_);
    Host& host = hosts_.emplace_back();
    host.name = name;
    host.answer = answer;
    host.observation = observation;
    host.input = input;
  }
  Host& host = hosts_[vehicle];
  // Who answers wrongly is dropped by who waits for it; what nobody waits for counts for nothing.
  const auto from = [this](const std::string& client, const std::string& hosting) {
    const std::lock_guard lock(mutex_);
    return !hosting.empty() && client == hosting;
  };
  participant_.subscribe(topic("command", "slackwater_msgs/msg/AgentCommand"),
                         [&host, from](dds::Payload message, const std::string& client) {
                           if (!from(client, host.agent)) return;
                           dds::AgentAsked asked = dds::read_agent_command(message);
                           const std::uint64_t step = asked.step;
                           (void)host.from_agent.answer(step, std::move(asked));
                         });
  participant_.subscribe(topic("physics_output", "slackwater_msgs/msg/PhysicsOutput"),
                         [&host, from](dds::Payload message, const std::string& client) {
                           if (!from(client, host.physics)) return;
                           const dds::PhysicsMade made = dds::read_physics_output(message);
                           (void)host.from_physics.answer(made.step, made);
                         });
  participant_.subscribe(
      topic("request", "slackwater_msgs/msg/HostRequest"),
      [this, vehicle, &host](dds::Payload message, const std::string& client) {
        const dds::HostAsked asked = dds::read_host_request(message);
        const auto refusal = take(vehicle, asked, client);
        const std::string words = refusal.value_or("hosted by " + client + " from now on");
        participant_.send(host.answer,
                          dds::host_answer(asked.token, !refusal, words, place_.step_s));
      });
  run_.host_physics(
      vehicle, [this, vehicle](const twin::HostedStep& step) { return ask_physics(vehicle, step); },
      "hosted physics");
}

void HostLink::tell(const std::string& text) const {
  if (on_trouble_) on_trouble_(text);
}

std::optional<std::string> HostLink::take(std::size_t vehicle, const dds::HostAsked& asked,
                                          const std::string& client) {
  if (asked.version != dds::host_version) {
    return formatted("version {} of the protocol was asked for, this is version {}", asked.version,
                     dds::host_version);
  }
  const bool is_agent = asked.role == static_cast<std::uint8_t>(dds::HostRole::agent);
  const double most_s = is_agent ? longest_s / most_missed : longest_s;
  if (!(asked.timeout_s >= shortest_s && asked.timeout_s <= most_s)) {
    return formatted(
        "time-out: found {:g} s, expected {:g} to {:g} s of {}: the whole run waits "
        "for it; ask for one within that",
        asked.timeout_s, shortest_s, most_s, is_agent ? "an agent" : "physics");
  }
  twin::CommandArbiter& arbiter = command_door_.arbiter();
  const std::lock_guard lock(mutex_);
  Host& host = hosts_[vehicle];
  if (is_agent) {
    if (!host.agent.empty() && host.agent != client)
      return host.name + " has an agent already: " + host.agent;
    if (const auto refusal = arbiter.ask(client, vehicle, arbiter.time_s())) return refusal->text;
    host.agent = client;
    host.agent_timeout_s = asked.timeout_s;
    host.missed = 0;
    return std::nullopt;
  }
  if (asked.role != static_cast<std::uint8_t>(dds::HostRole::physics))
    return formatted("role {}; 1 is an agent, 2 physics", int{asked.role});
  if (!host.physics.empty() && host.physics != client)
    return "the physics of " + host.name + " are made already by " + host.physics;
  host.physics = client;
  host.physics_timeout_s = asked.timeout_s;
  host.is_ending = false;
  twin::Command command;
  command.agent = vehicle;
  command.what = twin::HostPhysics{true};
  command.source = client;
  command.received_s = arbiter.time_s();
  run_.enqueue(std::move(command));
  return std::nullopt;
}

void HostLink::lose(const std::string& client) {
  for (std::size_t i = 0;; ++i) {
    bool was_agent = false, was_physics = false;
    {
      const std::lock_guard lock(mutex_);
      if (i >= hosts_.size()) return;
      was_agent = hosts_[i].agent == client;
      was_physics = hosts_[i].physics == client;
    }
    if (was_agent) drop_agent(i, "it is gone");
    if (was_physics) drop_physics(i, "it is gone");
  }
}

void HostLink::ask_agents(const twin::StepTime& time) {
  for (std::size_t i = 0; i < hosts_.size(); ++i) {
    bool is_hosted = false, is_ending = false;
    {
      const std::lock_guard lock(mutex_);
      is_hosted = !hosts_[i].agent.empty();
      is_ending = std::exchange(hosts_[i].is_ending, false);
    }
    if (is_ending) end_physics(i, time.step, time.start_s);
    if (is_hosted) ask_agent(i, time);
  }
}

void HostLink::ask_agent(std::size_t vehicle, const twin::StepTime& time) {
  Host& host = hosts_[vehicle];
  host.from_agent.ask(time.step);
  const dds::Stamp stamp = dds::stamp_of(place_.epoch, time.start_s);
  participant_.send(host.observation,
                    dds::agent_observation(run_.agents()[vehicle], run_.states()[vehicle],
                                           time.step, host.name, stamp));
  std::string client;
  double timeout_s = 0;
  {
    const std::lock_guard lock(mutex_);
    client = host.agent;
    timeout_s = host.agent_timeout_s;
  }
  const auto is_stopped = [this] { return control_.is_stopped(); };
  const auto asked = host.from_agent.wait(std::chrono::duration<double>(timeout_s), is_stopped);
  if (!asked && is_stopped()) return;
  if (const int missed = count_missed(host, !asked.has_value()); missed >= most_missed) {
    drop_agent(vehicle,
               formatted("{} answers in a row did not come within {:g} s", missed, timeout_s));
  }
  if (!asked) return;
  try {
    std::optional<twin::CommandWhat> what = command_of(*asked);
    if (!what) return;
    const Submitted submitted =
        command_door_.submit(client, vehicle, std::move(*what), heard_of(*asked));
    if (submitted.refusal) drop_agent(vehicle, *submitted.refusal);
  } catch (const Error& e) {
    drop_agent(vehicle, e.message());
  }
}

int HostLink::count_missed(Host& host, bool has_missed) {
  const std::lock_guard lock(mutex_);
  host.missed = has_missed ? host.missed + 1 : 0;
  return host.missed;
}

std::optional<twin::VehicleState<double>> HostLink::ask_physics(std::size_t vehicle,
                                                                const twin::HostedStep& step) {
  Host& host = hosts_[vehicle];
  double timeout_s = 0;
  {
    const std::lock_guard lock(mutex_);
    if (host.physics.empty()) return std::nullopt;
    timeout_s = host.physics_timeout_s;
  }
  host.from_physics.ask(step.time.step);
  participant_.send(host.input, dds::physics_input(step, host.name,
                                                   dds::stamp_of(place_.epoch, step.time.start_s)));
  const auto is_stopped = [this] { return control_.is_stopped(); };
  const auto made = host.from_physics.wait(std::chrono::duration<double>(timeout_s), is_stopped);
  if (!made) {
    drop_physics(vehicle, is_stopped()
                              ? "the run was stopped while it was asked"
                              : formatted("its answer did not come within {:g} s", timeout_s));
    return std::nullopt;
  }
  if (const auto why = unphysical(*made, step)) {
    drop_physics(vehicle, "it answered with " + *why);
    return std::nullopt;
  }
  return state_after(*made, step);
}

void HostLink::drop_agent(std::size_t vehicle, const std::string& why) {
  std::string client, name;
  {
    const std::lock_guard lock(mutex_);
    Host& host = hosts_[vehicle];
    client = std::exchange(host.agent, {});
    name = host.name;
  }
  if (client.empty()) return;
  tell("the agent of " + name + ", " + client + ", is taken off: " + why);
  twin::CommandArbiter& arbiter = command_door_.arbiter();
  arbiter.lost(client, arbiter.time_s());
  if (rule_ == HostRule::halt) control_.pause();
}

void HostLink::drop_physics(std::size_t vehicle, const std::string& why) {
  std::string client, name;
  {
    const std::lock_guard lock(mutex_);
    Host& host = hosts_[vehicle];
    client = std::exchange(host.physics, {});
    name = host.name;
    host.is_ending = !client.empty();
  }
  if (client.empty()) return;
  tell("the physics of " + name + " are ours again, " + client + " is taken off: " + why);
  if (rule_ == HostRule::halt) control_.pause();
}

void HostLink::end_physics(std::size_t vehicle, std::uint64_t step, double t_s) {
  twin::Command command;
  command.step = step;
  command.agent = vehicle;
  command.what = twin::HostPhysics{false};
  command.source = "hosted physics";
  command.received_s = t_s;
  run_.enqueue(std::move(command));
}

}  // namespace slackwater::live
