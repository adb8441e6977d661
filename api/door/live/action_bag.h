#pragma once
#include <filesystem>
#include <span>

#include "api/door/dds/message/bytes.h"
#include "data/store/session_action.h"

namespace slackwater::live {

/// std_msgs/msg/String: the row as JSON.
[[nodiscard]] dds::Bytes message_of(const store::SessionAction& action);

/// The record of a session as a bag of its own, on `action_topic`: a row a message, at the time of
/// the clock of the wall at which it was done.
/// @throws Error(invalid_input) where something lies at the path, Error(unavailable) where it
///         cannot be written
void write_action_bag(const std::filesystem::path& path,
                      std::span<const store::SessionAction> actions);

}  // namespace slackwater::live
