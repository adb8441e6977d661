#pragma once
#include <map>
#include <span>
#include <string>

#include "ingest/decoded/ingested.h"

namespace slackwater::api {

/// How much of what a file holds, counted as an operator counts: a valid time once, in however many
/// granules and members it comes.
struct IngestCounts {
  std::size_t times = 0;                         ///< distinct valid times
  std::map<std::string, std::size_t> by_status;  ///< of them analysis, forecast, observation
  std::size_t members = 0;                       ///< of an ensemble; 0: none
  bool operator==(const IngestCounts&) const = default;
};

[[nodiscard]] IngestCounts counts_of(std::span<const ingest::DecodedGranule> granules);

/// "analysis, 24 times", "analysis, 49 times, and forecast, 71 times", "forecast, 73 times of 11
/// members". @param status  of a file without times
[[nodiscard]] std::string text_of(const IngestCounts& counts, const std::string& status);

}  // namespace slackwater::api
