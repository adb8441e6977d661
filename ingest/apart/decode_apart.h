#pragma once
#include <functional>

#include "ingest/ingest.h"

namespace slackwater::ingest {

/// `decode_file` in a confined process of its own (ingest/apart/read_apart.h), which writes to the
/// staging folder alone. No other thread may be alive, and no store open, when this is called
/// (SQLite's shared memory crosses a fork).
///
/// @param meanwhile  is done here while the file is read there
[[nodiscard]] Ingested decode_apart(const std::filesystem::path& file,
                                    const ProductCatalogue& products, const IngestOptions& options,
                                    const std::filesystem::path& staging_folder,
                                    const Progress& progress,
                                    const std::function<void()>& meanwhile);

}  // namespace slackwater::ingest
