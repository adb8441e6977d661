#pragma once
#include <filesystem>

namespace slackwater::api {

/// Throws Error(invalid_input) where others on this machine may read or change a file of tokens.
/// One that cannot be looked at is left to whoever opens it.
void expect_secret(const std::filesystem::path& file);

}  // namespace slackwater::api
