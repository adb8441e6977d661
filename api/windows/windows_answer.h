#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "api/windows/windows.h"

namespace slackwater::api {

/// For programs: api/docs/json.md has the schema.
[[nodiscard]] nlohmann::json windows_json(const WindowsQuestion& question,
                                          const WindowsAnswer& answer);
/// For people: the answer of each task first, then what it rests on.
[[nodiscard]] std::string windows_text(const WindowsQuestion& question,
                                       const WindowsAnswer& answer);

}  // namespace slackwater::api
