#pragma once
#include <filesystem>

#include "ingest/history/read_history.h"

namespace slackwater::api {

/// `ingest::read_history` in a process of its own: a file that crashes the library that reads it,
/// or reads for ever, is one Error(invalid_input) that names it, and this process lives on.
///
/// No store may be open here, and no thread alive, when this is called.
[[nodiscard]] ingest::HistoryOfFile read_history_apart(const std::filesystem::path& file,
                                                       const std::vector<std::string>& wanted,
                                                       const ingest::HistoryOptions& options,
                                                       const ingest::Vocabulary& vocabulary);

}  // namespace slackwater::api
