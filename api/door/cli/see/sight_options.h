#pragma once
#include "api/ask/render/sight_choice.h"
#include "api/door/cli/command.h"

namespace slackwater::api {

/// --water, --warmth and --overcast.
/// @param sight  must outlive the command
void add_sight_options(CLI::App& command, SightChoice& sight);

}  // namespace slackwater::api
