#pragma once
#include <filesystem>

#include "ingest/history/read_history.h"

namespace slackwater::ingest {

/// `read_history` in a confined process of its own (ingest/apart/read_apart.h). No other thread may
/// be alive when this is called.
[[nodiscard]] HistoryOfFile read_history_apart(const std::filesystem::path& file,
                                               const std::vector<std::string>& wanted,
                                               const HistoryOptions& options,
                                               const Vocabulary& vocabulary);

}  // namespace slackwater::ingest
