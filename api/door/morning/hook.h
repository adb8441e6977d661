#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

#include "api/ask/morning/operator_config.h"

namespace slackwater::api {

/// Tells the operator's hook the verdict of an issued forecast, once and never again: that it was
/// told is written down before it is run.
/// @param folder    where that is written down, made where needed
/// @param forecast  the forecast's number in the store
/// @param verdict   JSON, on its standard input
/// @return what became of it, a sentence; empty: it had been told of this forecast before
/// Throws Error(unavailable) where the folder cannot be written; what goes wrong with the hook
/// itself is told in the sentence.
[[nodiscard]] std::string tell_hook(const Hook& hook, const std::filesystem::path& folder,
                                    std::int64_t forecast, const std::string& verdict);

}  // namespace slackwater::api
