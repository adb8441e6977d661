#pragma once
#include <span>
#include <string>

#include "api/door/live/command_door.h"

namespace slackwater::live {

/// A topic of a vehicle on which it is commanded, `/NAME/name`.
struct CommandTopic {
  const char* name;
  const char* type;
  /// @throws Error(invalid_input) for bytes that are no such message
  twin::CommandWhat (*read)(dds::Payload message);
};
[[nodiscard]] std::span<const CommandTopic> command_topics() noexcept;

/// Hands in what came on one of them, or says on `/NAME/refused` why it cannot be read.
/// @param held_back_s  see `CommandDoor::submit`
void hand_in(CommandDoor& command_door, const std::string& client, std::size_t vehicle,
             twin::CommandWhat (*read)(dds::Payload), dds::Payload message, double held_back_s = 0);

}  // namespace slackwater::live
