#include "api/live/desk.h"

#include <nlohmann/json.hpp>

namespace slackwater::live {

Desk::Desk(Stream& stream, twin::Steward& steward, const RunPlace& place)
    : stream_(stream), steward_(steward), place_(place) {}

void Desk::open(const std::string& name) {
  const auto heard = [&](const char* what, const char* type) {
    return stream_.open("/" + name + "/" + what, type, command_quality, Direction::heard);
  };
  Vehicle vehicle{};
  vehicle.velocity = heard("cmd_vel", "geometry_msgs/msg/Twist");
  vehicle.thrusters = heard("thrusters", "std_msgs/msg/Float64MultiArray");
  vehicle.waypoints = heard("waypoints", "nav_msgs/msg/Path");
  vehicle.refused = stream_.open("/" + name + "/refused", "std_msgs/msg/String", state_quality);
  const std::lock_guard lock(mutex_);
  vehicles_.push_back(vehicle);
}

std::optional<std::string> Desk::submit(const std::string& client, std::size_t vehicle,
                                        twin::CommandWhat what, const dds::Bytes& heard) {
  twin::Command command;
  command.agent = vehicle;
  command.source = client;
  const bool is_velocity = std::holds_alternative<twin::SetVelocity>(what);
  const bool is_thrusters = std::holds_alternative<twin::SetThrusters>(what);
  command.what = std::move(what);
  const double now_s = steward_.time_s();
  command.received_s = now_s;
  // One at a time, so that the steward sees a client's commands in the order of its count.
  const std::lock_guard lock(mutex_);
  command.sequence = ++counts_[{client, vehicle}];
  if (const auto refusal = steward_.submit(client, std::move(command), now_s)) {
    say_refused(client, vehicle, twin::name_of(refusal->reason), refusal->text);
    return refusal->text;
  }
  if (!heard.empty() && vehicle < vehicles_.size() && said_.size() < most_said) {
    const Vehicle& channels = vehicles_[vehicle];
    said_.push_back({is_velocity    ? channels.velocity
                     : is_thrusters ? channels.thrusters
                                    : channels.waypoints,
                     heard});
  }
  return std::nullopt;
}

void Desk::lost(const std::string& client) {
  const std::lock_guard lock(mutex_);
  std::erase_if(counts_, [&](const auto& count) { return count.first.first == client; });
  steward_.lost(client, steward_.time_s());
}

void Desk::refuse(const std::string& client, std::size_t vehicle, const std::string& text) {
  const std::lock_guard lock(mutex_);
  say_refused(client, vehicle, "unreadable", text);
}

void Desk::say_refused(const std::string& client, std::size_t vehicle, const char* reason,
                       const std::string& text) {
  if (vehicle >= vehicles_.size() || said_.size() >= most_said) return;
  const nlohmann::json json{{"client", client}, {"reason", reason}, {"text", text}};
  // What others wrote may be no UTF-8.
  said_.push_back({vehicles_[vehicle].refused,
                   dds::text(json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace))});
}

void Desk::speak(double t_s) {
  std::vector<Said> said;
  {
    const std::lock_guard lock(mutex_);
    said.swap(said_);
  }
  const dds::Stamp stamp = dds::stamp_of(place_.epoch, t_s);
  for (const Said& one : said) stream_.publish(one.channel, stamp, one.message);
}

}  // namespace slackwater::live
