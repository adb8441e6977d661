#pragma once
#include <filesystem>

#include "ingest/cf/forecast/forecast_file.h"

namespace slackwater::ingest {

/// `read_forecast` in a confined process of its own (ingest/apart/read_apart.h): for a file that
/// somebody names, not for those of a store, whose checksum is proven. Where other threads are
/// alive, which no copy of a process has, it is read here.
[[nodiscard]] Snapshot read_forecast_apart(const std::filesystem::path& file);

}  // namespace slackwater::ingest
