#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace slackwater::api::edr {

constexpr std::size_t max_path_bytes = 2048;

/// The decoded segments of a path: "/collections/currents/position" -> three of them; "/" -> none. One
/// slash at the end says nothing. A segment never holds a slash, a backslash or a control character,
/// and is never empty, "." or "..", however these are encoded: such a path is an Error(not_found), as
/// nothing of ours has such a name. A broken percent code is an Error(usage).
[[nodiscard]] std::vector<std::string> path_segments(std::string_view path);

}  // namespace slackwater::api::edr
