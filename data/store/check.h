#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace slackwater::store {

struct CheckFinding {
  bool harmful = true;  ///< false: left over, costs only space
  std::string found;
  std::string advice;
};

struct CheckReport {
  bool sound = true;  ///< no harmful finding
  std::vector<CheckFinding> findings;
  std::size_t sources = 0;
  std::size_t granules = 0;
  std::size_t forecasts = 0;
  std::size_t decisions = 0;
  std::size_t content_files = 0;    ///< that rows name
  std::uint64_t content_bytes = 0;  ///< of these
};

/// Looks the store over: SQLite's own integrity check, foreign keys, every content file with its
/// size (`deep`: its sha256, which reads everything), files nobody names, staging folders of dead
/// processes. Changes nothing. A catalogue that cannot be read is a finding; only a missing store
/// is an Error(not_found).
[[nodiscard]] CheckReport check_store(const std::filesystem::path& folder, bool deep);

}  // namespace slackwater::store
