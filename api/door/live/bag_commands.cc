#include "api/door/live/bag_commands.h"

#include <algorithm>
#include <utility>

#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::live {
namespace {

/// "/rov/cmd_vel" -> "cmd_vel".
std::string_view name_in(std::string_view topic) { return topic.substr(topic.rfind('/') + 1); }

/// Those by which it is read, of a command; empty: it is none.
std::string types_of(std::string_view name) {
  std::string types;
  for (const CommandTopic& topic : command_topics())
    if (command_topic_of(name, topic.type) != nullptr)
      types += (types.empty() ? "" : " or ") + std::string(topic.type);
  return types;
}

/// What a bag without a command of ours holds: commands in another type or of another name first.
std::string found_instead(const std::vector<bag::Channel>& channels) {
  std::vector<std::string> commands;
  std::vector<std::string> others;
  for (const bag::Channel& channel : channels) {
    const bool is_command = !types_of(name_in(channel.topic)).empty();
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

std::string PlayedBag::text() const {
  const std::uint64_t refused = handed_in - taken;
  std::string text = formatted("{}: {} command{} handed in", path.filename().string(), handed_in,
                               handed_in == 1 ? "" : "s");
  text += refused == 0 ? ", all taken" : formatted(", {} taken, {} refused", taken, refused);
  if (left_from_s)
    text += formatted("; those from {:.2f} s on lie behind the end of the run", *left_from_s);
  return text;
}

BagCommands::BagCommands(const std::filesystem::path& bag, const std::vector<std::string>& names,
                         double run_s, CommandDoor& command_door,
                         std::function<void(const std::string&)> on_trouble)
    : path_(bag),
      client_("bag " + bag.filename().string()),
      names_(names),
      command_door_(command_door),
      on_trouble_(std::move(on_trouble)),
      bag_(bag::open_bag(bag)),
      clock_(run_s) {
  played_.path = bag;
  for (const bag::Channel& channel : bag_->channels()) channels_.push_back(channel_of(channel));
  const bool has_any = std::any_of(channels_.begin(), channels_.end(),
                                   [](const Channel& one) { return one.topic != nullptr; });
  if (!has_any) {
    throw Error(ErrorKind::invalid_input,
                bag.string() +
                    ": holds no cmd_vel, thrusters, actuators or waypoints of a vehicle of this "
                    "run; expected topics like /" +
                    names.front() + "/cmd_vel as " + types_of("cmd_vel") +
                    found_instead(bag_->channels()));
  }
  due_ = next();
  expect_any(run_s);
  for (const std::string& warning : bag_->warnings()) tell(warning);
  if (const std::string words = clock_.left_out(); !words.empty())
    tell(path_.string() + ": " + words);
}

void BagCommands::expect_any(double run_s) const {
  const auto refuse = [&](const std::string& what) {
    throw Error(ErrorKind::invalid_input, path_.string() + ": " + what);
  };
  if (!due_) {
    refuse(
        "holds no message on its topics of commands for this run; record them, or leave out "
        "--play-commands");
  } else if (due_->at_s >= run_s) {
    refuse(
        formatted("its first command comes {:.1f} s after its first message, behind the end of "
                  "the run at {:g} s; make the run longer, or cut the bag",
                  due_->at_s, run_s));
  }
}

BagCommands::Channel BagCommands::channel_of(const bag::Channel& channel) const {
  const std::string name(name_in(channel.topic));
  const std::string types = types_of(name);
  if (types.empty()) return {};
  Channel made;
  const auto of = std::find_if(names_.begin(), names_.end(), [&](const std::string& vehicle) {
    return channel.topic == "/" + vehicle + "/" + name;
  });
  const std::string found = path_.string() + ": found " + channel.topic + " as " + channel.type;
  if (of == names_.end()) {
    made.unread =
        found + ", of no vehicle of this run (" + joined(names_, ", ") + "); it is not played";
    return made;
  }
  made.vehicle = static_cast<std::size_t>(of - names_.begin());
  made.topic = command_topic_of(name, channel.type);
  if (made.topic == nullptr)
    made.unread = found + ", expected " + types + "; it is not played: convert it";
  return made;
}

void BagCommands::tell(const std::string& text) const {
  if (on_trouble_) on_trouble_(text);
}

std::optional<BagCommands::Due> BagCommands::next() {
  while (const auto message = bag_->next()) {
    Channel& channel = channels_[message->channel];
    const bool is_command = channel.topic != nullptr;
    const double at_s =
        clock_.time_s(*message, bag_->channels()[message->channel].topic, is_command);
    if (!channel.unread.empty()) tell(std::exchange(channel.unread, {}));
    if (is_command)
      return Due{at_s, &channel, dds::Bytes(message->payload.begin(), message->payload.end())};
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
  for (; due_ && due_->at_s <= start_s + soon_s; due_ = next_or_end()) {
    ++played_.handed_in;
    const Channel& to = *due_->channel;
    if (live::hand_in(command_door_, client_, to.vehicle, *to.topic, due_->message))
      ++played_.taken;
  }
}

PlayedBag BagCommands::played() const {
  PlayedBag played = played_;
  if (due_) played.left_from_s = due_->at_s;
  return played;
}

}  // namespace slackwater::live
