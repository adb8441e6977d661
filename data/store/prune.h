#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "fields/base/time.h"

namespace slackwater::store {

class Database;

struct PruneOptions {
  /// Sources ingested before this instant go, except those with static fields (bathymetry), those
  /// a remaining forecast was made from, and those that tell what came of a decision: of whatever
  /// place they analyse or measure the hours from the beginning of its forecast to the end of its
  /// work, and three hours about them, as far as values are interpolated.
  std::optional<UtcTime> older_than;
  /// Forecasts issued before `older_than` go as well, but for those that a decision was made on.
  /// Without it no forecast ever goes.
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
  std::size_t kept_sources = 0;    ///< old ones that stay for decisions alone
  std::size_t kept_forecasts = 0;  ///< the same
  std::size_t content_files = 0;
  std::uint64_t bytes = 0;          ///< of the content files removed
  std::size_t staging_folders = 0;  ///< of dead processes
};

/// Decisions never go, nor does what shows what they rested on and what came of it.
///
/// Removes rows first and, once that is durable, their files: killed in between, it leaves orphans,
/// never holes.
PruneReport prune_store(Database& database, const std::filesystem::path& folder,
                        const PruneOptions& options);

}  // namespace slackwater::store
