#pragma once
#include <span>
#include <string>
#include <string_view>

#include "api/door/live/command_door.h"

namespace slackwater::live {

/// A topic of a vehicle on which it is commanded, `/NAME/name`.
struct CommandTopic {
  const char* name;
  const char* type;
  /// @throws Error(invalid_input) for bytes that are no such message, or that no such vehicle can
  /// be told
  twin::CommandWhat (*read)(dds::Payload message, const twin::Vehicle& vehicle);
};
/// A velocity has two: topics of DDS have one type each, and newer stacks send it stamped.
[[nodiscard]] std::span<const CommandTopic> command_topics() noexcept;
/// By which a recorded topic `/NAME/name` of that type is read: in a bag a stamped velocity may be
/// on `cmd_vel` too. Null: by none.
[[nodiscard]] const CommandTopic* command_topic_of(std::string_view name,
                                                   std::string_view type) noexcept;

/// Hands in what came on one of them, or says on `/NAME/refused` why it cannot be read.
/// @param held_back_s  see `CommandDoor::submit`
/// @return whether it was taken
bool hand_in(CommandDoor& command_door, const std::string& client, std::size_t vehicle,
             const CommandTopic& topic, dds::Payload message, double held_back_s = 0);

/// A command as the message of the topic that it could have come on, for recordings: a velocity as
/// geometry_msgs/msg/Twist. Empty where there is no such topic.
[[nodiscard]] dds::Bytes order_of(const twin::CommandWhat& what, const twin::Vehicle& vehicle);

}  // namespace slackwater::live
