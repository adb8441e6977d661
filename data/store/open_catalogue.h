#pragma once
#include <filesystem>

#include "data/store/database.h"

namespace slackwater::store {

/// Opens the catalogue for writing; makes folder, catalogue and schema where they are missing or
/// old. Refuses to put an empty catalogue over content files whose own catalogue is lost.
[[nodiscard]] Database open_catalogue_for_writing(const std::filesystem::path& folder);

/// Opens it for reading, with as little work as possible:
///   1. beside writers, through the shared memory file, which the first reader makes;
///   2. where nothing can be made (read-only file system) and there is no WAL: a copy in memory;
///   3. where nothing can be made and a WAL was left by a crash: catalogue and WAL, without locks.
/// A catalogue of an older schema is first brought up to date, which needs write access.
[[nodiscard]] Database open_catalogue_for_reading(const std::filesystem::path& folder);

}  // namespace slackwater::store
