#pragma once
#include <string>

#include "api/ask/decisions/decisions.h"

namespace slackwater::api {

/// A row a decision, for a spreadsheet; a name, a task or a note that a spreadsheet would take for
/// a formula (it begins with = + - @) has an apostrophe before it.
[[nodiscard]] std::string decisions_csv(const DecisionsAnswer& answer);

}  // namespace slackwater::api
