#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "fields/base/time.h"

namespace slackwater::store {

class Database;

struct PruneOptions {
  /// Sources ingested before this instant go, except those with static fields (bathymetry) and
  /// those a remaining forecast was made from.
  std::optional<UtcTime> older_than;
  /// Forecasts issued before `older_than` go as well. Without it no forecast ever goes.
  bool forecasts = false;
  /// Content files that no row names go, e.g. after a crash.
  bool orphans = false;
  /// Nothing is removed; the report says what would be.
  bool dry_run = false;
};

struct PruneReport {
  std::size_t sources = 0;
  std::size_t granules = 0;
  std::size_t forecasts = 0;
  std::size_t content_files = 0;
  std::uint64_t bytes = 0;          ///< of the content files removed
  std::size_t staging_folders = 0;  ///< of dead processes
};

/// Removes rows first and, once that is durable, their files: killed in between, it leaves orphans,
/// never holes.
PruneReport prune_store(Database& database, const std::filesystem::path& folder,
                        const PruneOptions& options);

}  // namespace slackwater::store
