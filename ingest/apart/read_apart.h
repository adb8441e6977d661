#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "fields/base/process/run_apart.h"

namespace slackwater::ingest {

/// What the reader of a file may use and reach: a minute and a second for each MiB of it, the file
/// and the tables of the libraries.
[[nodiscard]] Allowance allowance_for(const std::filesystem::path& file);

/// Of errors in what a reader told, which no sound reader tells.
[[nodiscard]] std::string context_of_told(const std::filesystem::path& file);

/// Reads a file of a stranger in a confined process of its own (fields/base/process/run_apart.h). A
/// file that crashes the library that reads it, or reads for ever, or unpacks to more than there is
/// room for, is one Error(invalid_input) that names it, and this process lives on.
///
/// @param read  answers in bytes (packed.h); its exceptions arrive here as Errors
/// @throws Error as `read` does; Error(not_found) where there is no file; Error(invalid_input) for
///         what is no regular file (a pipe or a device could keep a reader for ever);
///         Error(unavailable) where the reader was ended from outside
[[nodiscard]] std::string read_apart(const std::filesystem::path& file, const Allowance& allowance,
                                     const std::function<std::string(const TellShare&)>& read,
                                     const std::function<void(double)>& on_share = {},
                                     const std::function<void()>& meanwhile = {});

}  // namespace slackwater::ingest
