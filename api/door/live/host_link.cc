#include "api/door/live/host_link.h"

#include <cmath>

#include "api/door/live/command_topics.h"
#include "api/door/live/host_check.h"
#include "api/door/live/reroute.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/vehicle/actuator_channels.h"

namespace slackwater::live {
namespace {

constexpr int most_missed = 5;
/// A run stands still for nobody longer than that.
constexpr double longest_s = 10;
constexpr double shortest_s = 0.001;
/// How long who was taken may listen to nothing.
constexpr std::chrono::seconds longest_deaf{5};

twin::SetActuators actuators_of(const dds::AgentAsked& asked, const twin::Vehicle& vehicle) {
  const std::vector<double>& values = asked.thrusters;
  twin::SetActuators set;
  set.is_physical = asked.kind == 8;
  std::size_t there = 0;
  for (std::size_t i = 0; i < twin::most_channels; ++i) {
    if (!twin::channel_of(vehicle, i)) continue;
    if (there < values.size() && !std::isnan(values[there])) set.given.give(i, values[there]);
    ++there;
  }
  if (there != values.size())
    throw Error(ErrorKind::invalid_input,
                formatted("a command of {} actuators; expected one number for each of {}, in that "
                          "order, NaN for what is left out",
                          values.size(), twin::channel_names(vehicle)));
  return set;
}

}  // namespace

std::optional<twin::CommandWhat> command_of(const dds::AgentAsked& asked,
                                            const twin::Vehicle& vehicle) {
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
    case 7:
    case 8:
      return actuators_of(asked, vehicle);
    default:
      throw Error(ErrorKind::invalid_input,
                  formatted("a command of kind {}; kinds are from 0 to 8", int{asked.kind}));
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
  participant_.subscribe(
      topic("command", "slackwater_msgs/msg/AgentCommand"),
      [this, &host](dds::Payload message, const std::string& client) {
        take_command(host, message, client);
      },
      [this, vehicle, from, &host](const std::string& client) {
        if (from(client, host.agent)) drop_agent(vehicle, {"it is gone"});
      });
  participant_.subscribe(
      topic("physics_output", "slackwater_msgs/msg/PhysicsOutput"),
      [&host, from](dds::Payload message, const std::string& client) {
        if (!from(client, host.physics)) return;
        const dds::PhysicsMade made = dds::read_physics_output(message);
        (void)host.from_physics.answer(made.step, made);
      },
      [this, vehicle, from, &host](const std::string& client) {
        if (from(client, host.physics)) drop_physics(vehicle, {"it is gone"});
      });
  participant_.subscribe(
      topic("request", "slackwater_msgs/msg/HostRequest"),
      [this, vehicle, &host](dds::Payload message, const std::string& client) {
        const dds::HostAsked asked = dds::read_host_request(message);
        const auto refusal = take(vehicle, asked, client);
        const bool is_leaving = asked.role == static_cast<std::uint8_t>(dds::HostRole::leave);
        const auto taken = [&] {
          return "hosted by " + client +
                 " from now on; actuators: " + twin::channel_names(*command_door_.model(vehicle));
        };
        const std::string words = refusal ? *refusal : is_leaving ? "given back" : taken();
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
  if (asked.role == static_cast<std::uint8_t>(dds::HostRole::leave)) return leave(vehicle, client);
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
    if (host.agent.empty()) host.of_agent = {std::chrono::steady_clock::now()};
    host.agent = client;
    host.agent_timeout_s = asked.timeout_s;
    host.missed = 0;
    host.behind_since.reset();
    return std::nullopt;
  }
  if (asked.role != static_cast<std::uint8_t>(dds::HostRole::physics))
    return formatted("role {}; 0 leaves, 1 is an agent, 2 physics", int{asked.role});
  if (!host.physics.empty() && host.physics != client)
    return "the physics of " + host.name + " are made already by " + host.physics;
  if (host.physics.empty()) host.of_physics = {std::chrono::steady_clock::now()};
  host.physics = client;
  host.physics_timeout_s = asked.timeout_s;
  return std::nullopt;
}

std::optional<std::string> HostLink::leave(std::size_t vehicle, const std::string& client) {
  bool is_agent = false, is_physics = false;
  std::string name;
  {
    const std::lock_guard lock(mutex_);
    is_agent = hosts_[vehicle].agent == client;
    is_physics = hosts_[vehicle].physics == client;
    name = hosts_[vehicle].name;
  }
  if (is_agent) drop_agent(vehicle, {"it left", false});
  if (is_physics) drop_physics(vehicle, {"it left", false});
  if (is_agent || is_physics) return std::nullopt;
  return client + " hosts nothing of " + name;
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
    if (was_agent) drop_agent(i, {"it is gone"});
    if (was_physics) drop_physics(i, {"it is gone"});
  }
}

void HostLink::take_command(Host& host, dds::Payload message, const std::string& client) {
  {
    const std::lock_guard lock(mutex_);
    if (host.agent.empty() || host.agent != client) return;
    // To whatever step: it is awake.
    host.behind_since.reset();
  }
  dds::AgentAsked asked = dds::read_agent_command(message);
  const std::uint64_t step = asked.step;
  (void)host.from_agent.answer(step, std::move(asked));
}

HostLink::Ear HostLink::ear_of(dds::Participant::WriterId writer, const std::string& client,
                               Beginning& beginning) const {
  if (!beginning.listens) beginning.listens = participant_.is_heard_by(writer, client);
  if (beginning.listens) return Ear::listens;
  const auto deaf = std::chrono::steady_clock::now() - beginning.taken;
  return deaf < longest_deaf ? Ear::not_yet : Ear::never;
}

/// All are asked before the first is waited for, so that two that are late take no longer than one.
void HostLink::ask_agents(const twin::StepTime& time) {
  std::vector<std::size_t> asked;
  for (std::size_t i = 0; i < hosts_.size(); ++i) {
    bool is_ending = false;
    {
      const std::lock_guard lock(mutex_);
      is_ending = std::exchange(hosts_[i].is_ending, false);
    }
    if (is_ending) hand_physics(i, "hosted physics", false, time);
    begin_physics(i, time);
    if (ask_agent(i, time)) asked.push_back(i);
  }
  const WallTime now = std::chrono::steady_clock::now();
  for (const std::size_t vehicle : asked) wait_for_agent(vehicle, now);
}

bool HostLink::ask_agent(std::size_t vehicle, const twin::StepTime& time) {
  Host& host = hosts_[vehicle];
  // First, so that who is dropped from now on is not waited for.
  host.from_agent.ask(time.step);
  bool is_behind = false, is_too_late = false;
  double timeout_s = 0;
  Ear ear = Ear::listens;
  {
    const std::lock_guard lock(mutex_);
    if (host.agent.empty()) return false;
    ear = ear_of(host.observation, host.agent, host.of_agent);
    timeout_s = host.agent_timeout_s;
    is_behind = host.behind_since.has_value();
    const std::chrono::duration<double> most(timeout_s * (most_missed - host.missed));
    is_too_late = is_behind && std::chrono::steady_clock::now() - *host.behind_since >= most;
  }
  if (ear == Ear::never)
    drop_agent(vehicle, {"it does not read /" + host.name + "/host/observation"});
  if (ear != Ear::listens) return false;
  if (is_too_late) {
    drop_agent(vehicle, {formatted("no answer came within {:g} s", timeout_s * most_missed)});
    return false;
  }
  participant_.send(host.observation, dds::agent_observation(
                                          run_.agents()[vehicle], run_.states()[vehicle], time.step,
                                          host.name, dds::stamp_of(place_.epoch, time.start_s)));
  return !is_behind;
}

void HostLink::wait_for_agent(std::size_t vehicle, WallTime asked_at) {
  Host& host = hosts_[vehicle];
  std::string client, name;
  std::chrono::duration<double> left{};
  {
    const std::lock_guard lock(mutex_);
    if (host.agent.empty()) return;
    client = host.agent;
    name = host.name;
    left = std::chrono::duration<double>(host.agent_timeout_s) -
           (std::chrono::steady_clock::now() - asked_at);
  }
  const auto is_stopped = [this] { return control_.is_stopped(); };
  const auto asked = [&] {
    const twin::Awaited::Wait waits(control_.awaited(), "the agent of " + name + ", " + client);
    return host.from_agent.wait(left, is_stopped);
  }();
  if (!asked) {
    if (!is_stopped()) note_missed(vehicle);
    return;
  }
  const auto is_still_agent = [&] {
    const std::lock_guard lock(mutex_);
    return host.agent == client;
  };
  {
    const std::lock_guard lock(mutex_);
    host.missed = 0;
  }
  try {
    const auto model = command_door_.model(vehicle);
    std::optional<twin::CommandWhat> what = command_of(*asked, *model);
    if (!what || !is_still_agent()) return;
    const dds::Bytes heard = order_of(*what, *model);
    const Submitted submitted = command_door_.submit(client, vehicle, std::move(*what), heard);
    if (submitted.refusal) {
      drop_agent(vehicle, {*submitted.refusal});
    } else if (!is_still_agent()) {
      // It left meanwhile: its last command does not keep the helm for it.
      twin::CommandArbiter& arbiter = command_door_.arbiter();
      arbiter.lost(client, vehicle, arbiter.time_s());
    }
  } catch (const Error& e) {
    drop_agent(vehicle, {e.message()});
  }
}

void HostLink::note_missed(std::size_t vehicle) {
  std::string client, name;
  double timeout_s = 0;
  int missed = 0;
  {
    const std::lock_guard lock(mutex_);
    Host& host = hosts_[vehicle];
    if (host.agent.empty()) return;  // it was dropped meanwhile
    client = host.agent;
    name = host.name;
    timeout_s = host.agent_timeout_s;
    missed = ++host.missed;
    host.behind_since = std::chrono::steady_clock::now();
  }
  if (missed >= most_missed) {
    drop_agent(vehicle,
               {formatted("{} answers in a row did not come within {:g} s", missed, timeout_s)});
  } else {
    tell(
        formatted("the agent of {}, {}, did not answer within {:g} s: the run goes on without "
                  "waiting for it, and takes it off after {:g} s more of silence",
                  name, client, timeout_s, timeout_s * (most_missed - missed)));
  }
}

std::optional<twin::VehicleState<double>> HostLink::ask_physics(std::size_t vehicle,
                                                                const twin::HostedStep& step) {
  Host& host = hosts_[vehicle];
  // First, so that who is dropped from now on is not waited for.
  host.from_physics.ask(step.time.step);
  double timeout_s = 0;
  std::string whom;
  {
    const std::lock_guard lock(mutex_);
    if (host.physics.empty() || !host.of_physics.listens) return std::nullopt;
    timeout_s = host.physics_timeout_s;
    whom = "the physics of " + host.name + ", " + host.physics;
  }
  participant_.send(host.input, dds::physics_input(step, host.name,
                                                   dds::stamp_of(place_.epoch, step.time.start_s)));
  const auto is_stopped = [this] { return control_.is_stopped(); };
  const auto made = [&] {
    const twin::Awaited::Wait waits(control_.awaited(), whom);
    return host.from_physics.wait(std::chrono::duration<double>(timeout_s), is_stopped);
  }();
  if (!made) {
    drop_physics(vehicle,
                 {is_stopped() ? "the run was stopped while it was asked"
                               : formatted("its answer did not come within {:g} s", timeout_s)});
    return std::nullopt;
  }
  if (const auto why = unphysical(*made, step)) {
    drop_physics(vehicle, {"it answered with " + *why});
    return std::nullopt;
  }
  return state_after(*made, step);
}

void HostLink::drop_agent(std::size_t vehicle, const Ending& ending) {
  std::string client, name;
  {
    const std::lock_guard lock(mutex_);
    Host& host = hosts_[vehicle];
    client = std::exchange(host.agent, {});
    host.from_agent.give_up();
    name = host.name;
  }
  if (client.empty()) return;
  tell("the agent of " + name + ", " + client + ", is taken off: " + ending.why);
  twin::CommandArbiter& arbiter = command_door_.arbiter();
  arbiter.lost(client, vehicle, arbiter.time_s());
  if (rule_ == HostRule::halt && ending.has_failed) control_.pause();
}

void HostLink::drop_physics(std::size_t vehicle, const Ending& ending) {
  std::string client, name;
  {
    const std::lock_guard lock(mutex_);
    Host& host = hosts_[vehicle];
    client = std::exchange(host.physics, {});
    host.from_physics.give_up();
    name = host.name;
    host.is_ending = host.is_ending || (!client.empty() && host.of_physics.listens);
  }
  if (client.empty()) return;
  tell("the physics of " + name + " are ours again, " + client + " is taken off: " + ending.why);
  if (rule_ == HostRule::halt && ending.has_failed) control_.pause();
}

void HostLink::begin_physics(std::size_t vehicle, const twin::StepTime& time) {
  std::string client, name;
  Ear ear = Ear::listens;
  {
    const std::lock_guard lock(mutex_);
    Host& host = hosts_[vehicle];
    if (host.physics.empty() || host.of_physics.listens) return;
    client = host.physics;
    name = host.name;
    ear = ear_of(host.input, client, host.of_physics);
  }
  if (ear == Ear::listens) hand_physics(vehicle, client, true, time);
  if (ear == Ear::never)
    drop_physics(vehicle, {"it does not read /" + name + "/host/physics_input"});
}

void HostLink::hand_physics(std::size_t vehicle, const std::string& by, bool is_hosted,
                            const twin::StepTime& time) {
  twin::Command command;
  command.step = time.step;
  command.agent = vehicle;
  command.what = twin::HostPhysics{is_hosted};
  command.source = by;
  command.received_s = time.start_s;
  run_.enqueue(std::move(command));
}

}  // namespace slackwater::live
