#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "fields/base/config.h"

namespace slackwater::twin {

/// Opens the description that `key` names, FOLDER/NAME.yaml.
/// Throws Error(invalid_input) for a name that is none of those in the folder, and lists them.
[[nodiscard]] Config open_named(const Config& config, std::string_view key,
                                const std::filesystem::path& folder);
/// The same of a name that is a value already. @param what  it names, for the error
[[nodiscard]] Config open_named(const std::string& name, std::string_view what,
                                const std::filesystem::path& folder);

}  // namespace slackwater::twin
