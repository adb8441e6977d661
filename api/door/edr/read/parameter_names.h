#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace slackwater::api::edr {

constexpr std::size_t max_parameter_names = 1'000;

/// Reads `parameter-name`: names separated by commas (blanks around them do not count). The indices
/// into `known`, in the order asked, none twice. Throws Error(usage) for an empty list or name,
/// more than max_parameter_names, and a name that is not known: the message gives the nearest known
/// one, or all where none is near.
[[nodiscard]] std::vector<std::size_t> parse_parameter_names(std::string_view text,
                                                             const std::vector<std::string>& known);

}  // namespace slackwater::api::edr
