#include "api/door/live/bag_commands.h"

#include <algorithm>

#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::live {
namespace {

/// What a bag without a command of ours holds: commands in another type or of another name first.
std::string found_instead(const std::vector<bag::Channel>& channels) {
  std::vector<std::string> commands;
  std::vector<std::string> others;
  for (const bag::Channel& channel : channels) {
    const bool is_command = std::any_of(
        command_topics().begin(), command_topics().end(),
        [&](const auto& topic) { return channel.topic.ends_with("/" + std::string(topic.name)); });
    (is_command ? commands : others).push_back(channel.topic + " as " + channel.type);
  }
  if (!commands.empty())
    return "; found " + joined(commands, ", ") + ": rename the vehicle or convert the type";
  constexpr std::size_t enough = 5;
  const std::size_t more = others.size() > enough ? others.size() - enough : 0;
  others.resize(others.size() - more);
  if (others.empty()) return "; found no topic";
  return "; found " + joined(others, ", ") +
         (more > 0 ? " and " + std::to_string(more) + " more" : "");
}

}  // namespace

BagCommands::BagCommands(const std::filesystem::path& bag, const std::vector<std::string>& names,
                         CommandDoor& command_door,
                         std::function<void(const std::string&)> on_trouble)
    : path_(bag),
      client_("bag " + bag.filename().string()),
      command_door_(command_door),
      on_trouble_(std::move(on_trouble)),
      bag_(bag::open_bag(bag)) {
  bool has_any = false;
  for (const bag::Channel& channel : bag_->channels()) {
    std::optional<Target>& target = targets_.emplace_back();
    for (std::size_t i = 0; i < names.size(); ++i)
      for (const CommandTopic& topic : command_topics())
        if (channel.topic == "/" + names[i] + "/" + topic.name && channel.type == topic.type)
          target = Target{i, topic.read};
    has_any = has_any || target.has_value();
  }
  if (!has_any) {
    throw Error(ErrorKind::invalid_input,
                bag.string() +
                    ": holds no cmd_vel, thrusters or waypoints of a vehicle of this "
                    "run; expected topics like /" +
                    names.front() + "/cmd_vel as geometry_msgs/msg/Twist" +
                    found_instead(bag_->channels()));
  }
  due_ = next();
  for (const std::string& warning : bag_->warnings()) tell(warning);
}

void BagCommands::tell(const std::string& text) const {
  if (on_trouble_) on_trouble_(text);
}

std::optional<BagCommands::Due> BagCommands::next() {
  while (const auto message = bag_->next()) {
    if (!first_ns_) first_ns_ = message->log_time_ns;
    const std::optional<Target>& target = targets_[message->channel];
    if (!target) continue;
    const double at_s = 1e-9 * static_cast<double>(message->log_time_ns - *first_ns_);
    return Due{at_s, *target, dds::Bytes(message->payload.begin(), message->payload.end())};
  }
  return std::nullopt;
}

std::optional<BagCommands::Due> BagCommands::next_or_end() {
  try {
    return next();
  } catch (const Error& e) {
    tell("the commands played from " + path_.string() +
         " end here, the run goes on without them: " + e.message());
    return std::nullopt;
  }
}

void BagCommands::hand_in(double start_s) {
  constexpr double soon_s = 1e-6;  // what rounding leaves of a number of steps
  for (; due_ && due_->at_s <= start_s + soon_s; due_ = next_or_end())
    live::hand_in(command_door_, client_, due_->target.vehicle, due_->target.read, due_->message);
}

}  // namespace slackwater::live
