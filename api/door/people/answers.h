#pragma once
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "api/door/http/message.h"

namespace slackwater::people {

[[nodiscard]] api::http::Response json_response(const nlohmann::json& body);
/// A part of a path that is a whole number; nothing: it is none.
[[nodiscard]] std::optional<std::size_t> number_in_path(const std::string& part);

}  // namespace slackwater::people
