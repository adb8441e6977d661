#include "api/door/live/command_door.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "api/door/live/command_topics.h"
#include "fields/base/text.h"

namespace slackwater::live {

CommandDoor::CommandDoor(Stream& stream, twin::CommandArbiter& arbiter, const RunPlace& place)
    : stream_(stream), arbiter_(arbiter), place_(place) {}

void CommandDoor::open(const std::string& name, std::shared_ptr<const twin::Vehicle> model) {
  const auto heard = [&](const char* what, const char* type) {
    return stream_.open("/" + name + "/" + what, type, command_quality, Direction::heard);
  };
  Vehicle vehicle{};
  vehicle.name = name;
  vehicle.model = std::move(model);
  vehicle.velocity = heard("cmd_vel", "geometry_msgs/msg/Twist");
  vehicle.thrusters = heard("thrusters", "std_msgs/msg/Float64MultiArray");
  vehicle.actuators = heard("actuators", "slackwater_msgs/msg/Actuators");
  vehicle.waypoints = heard("waypoints", "nav_msgs/msg/Path");
  vehicle.refused = stream_.open("/" + name + "/refused", "std_msgs/msg/String", state_quality);
  const std::lock_guard lock(mutex_);
  vehicles_.push_back(std::move(vehicle));
}

std::shared_ptr<const twin::Vehicle> CommandDoor::model(std::size_t vehicle) {
  const std::lock_guard lock(mutex_);
  return vehicles_.at(vehicle).model;
}

Submitted CommandDoor::submit(const std::string& client, std::size_t vehicle,
                              twin::CommandWhat what, const dds::Bytes& heard, double held_back_s) {
  twin::Command command;
  command.agent = vehicle;
  command.source = client;
  const bool is_short_lived = twin::must_be_renewed(what);
  const OfVehicle channel = channel_of(what);
  command.what = std::move(what);
  const double now_s = arbiter_.time_s();
  command.received_s = now_s;
  // One at a time, so that the arbiter sees a client's commands in the order of its count.
  const std::lock_guard in_order(order_);
  command.sequence = ++counts_[{client, vehicle}];
  std::optional<twin::Refusal> refusal;
  if (is_short_lived) refusal = stale(client, vehicle, held_back_s, now_s);
  if (!refusal) refusal = arbiter_.submit(client, std::move(command), now_s);
  const std::lock_guard lock(mutex_);
  if (refusal) {
    say_refused(client, vehicle, twin::name_of(refusal->reason), refusal->text);
    return {refusal->text};
  }
  say_heard(vehicle, channel, heard);
  return {{}, arbiter_.taken(vehicle)};
}

/// What a link held back is of a place and an aim that are past.
std::optional<twin::Refusal> CommandDoor::stale(const std::string& client, std::size_t vehicle,
                                                double held_back_s, double now_s) {
  constexpr double oldest_s = twin::RefusalLimits{}.oldest_s;
  if (held_back_s <= oldest_s) return std::nullopt;
  std::string name;
  {
    const std::lock_guard lock(mutex_);
    if (vehicle < vehicles_.size()) name = vehicles_[vehicle].name;
  }
  return arbiter_.refuse(
      client, name,
      {twin::RefusalReason::stale,
       formatted("found a command that was {:.1f} s on its way, expected at most {:g} s for "
                 "velocity, thrusters and actuators; send a new one, do not queue old ones, and "
                 "check the link",
                 held_back_s, oldest_s)},
      now_s);
}

void CommandDoor::lost(const std::string& client) {
  const std::lock_guard in_order(order_);
  std::erase_if(counts_, [&](const auto& count) { return count.first.first == client; });
  arbiter_.lost(client, arbiter_.time_s());
}

CommandDoor::OfVehicle CommandDoor::channel_of(const twin::CommandWhat& what) noexcept {
  if (std::holds_alternative<twin::SetVelocity>(what)) return &Vehicle::velocity;
  if (std::holds_alternative<twin::SetThrusters>(what)) return &Vehicle::thrusters;
  if (std::holds_alternative<twin::SetActuators>(what)) return &Vehicle::actuators;
  return &Vehicle::waypoints;
}

void CommandDoor::say_heard(std::size_t vehicle, OfVehicle channel, dds::Bytes heard) {
  if (heard.empty() || vehicle >= vehicles_.size()) return;
  said_.push_back({vehicles_[vehicle].*channel, std::move(heard)});
}

bool CommandDoor::tell_taken(std::size_t vehicle, const twin::CommandWhat& what) {
  const std::lock_guard lock(mutex_);
  if (vehicle >= vehicles_.size()) return false;
  dds::Bytes heard = order_of(what, *vehicles_[vehicle].model);
  if (heard.empty()) return false;
  say_heard(vehicle, channel_of(what), std::move(heard));
  return true;
}

void CommandDoor::tell_refused(std::size_t vehicle, const twin::RefusalCount& refusal) {
  const std::lock_guard lock(mutex_);
  say_refused(refusal.source, vehicle, twin::name_of(refusal.reason), refusal.last_text,
              refusal.count);
}

std::optional<std::size_t> CommandDoor::vehicle(const std::string& name) {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(vehicles_.begin(), vehicles_.end(),
                                  [&](const Vehicle& one) { return one.name == name; });
  if (found == vehicles_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - vehicles_.begin());
}

void CommandDoor::refuse(const std::string& client, std::size_t vehicle, const std::string& text) {
  std::string name;
  {
    const std::lock_guard lock(mutex_);
    if (vehicle < vehicles_.size()) name = vehicles_[vehicle].name;
  }
  const twin::Refusal refusal =
      arbiter_.refuse(client, name, {twin::RefusalReason::unreadable, text}, arbiter_.time_s());
  const std::lock_guard lock(mutex_);
  say_refused(client, vehicle, twin::name_of(refusal.reason), refusal.text);
}

void CommandDoor::say_refused(const std::string& client, std::size_t vehicle, const char* reason,
                              const std::string& text, std::uint64_t count) {
  if (vehicle >= vehicles_.size() || refused_ >= most_refused) return;
  ++refused_;
  nlohmann::json json{{"client", client}, {"reason", reason}, {"text", text}};
  if (count != 1) json["count"] = count;
  // What others wrote may be no UTF-8.
  said_.push_back({vehicles_[vehicle].refused,
                   dds::text(json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace))});
}

void CommandDoor::speak(double t_s) {
  std::vector<Said> said;
  {
    const std::lock_guard lock(mutex_);
    said.swap(said_);
    refused_ = 0;
  }
  const dds::Stamp stamp = dds::stamp_of(place_.epoch, t_s);
  for (const Said& one : said) stream_.publish(one.channel, stamp, one.message);
}

}  // namespace slackwater::live
