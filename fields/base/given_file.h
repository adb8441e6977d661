#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace slackwater {

// A file that somebody names: only regular ones are read, since a pipe or a device could keep its
// reader for ever.

/// @throws Error(invalid_input) for a pipe, a socket or a device
void refuse_device(const std::filesystem::path& file);

/// @param what  is expected there, e.g. "a YAML file"
/// @throws Error(not_found) where there is nothing; Error(invalid_input) for a folder or a device
void expect_given_file(const std::filesystem::path& file, std::string_view what);

/// All of its bytes. @throws as `expect_given_file`; Error(invalid_input) where there are more than
/// `most_bytes`; Error(unavailable) where it cannot be read
[[nodiscard]] std::string text_of_given_file(const std::filesystem::path& file,
                                             std::string_view what,
                                             std::size_t most_bytes = std::size_t{64} << 20U);

}  // namespace slackwater
