#include "api/pipeline/ingest/ingest_counts.h"

#include <set>

#include "fields/base/text.h"

namespace slackwater::api {

IngestCounts counts_of(std::span<const ingest::DecodedGranule> granules) {
  std::set<UtcTime> all;
  std::map<std::string, std::set<UtcTime>> times;
  std::set<int> members;
  for (const ingest::DecodedGranule& decoded : granules) {
    const Granule& granule = decoded.granule;
    if (granule.ensemble_member) members.insert(*granule.ensemble_member);
    for (const TimeCell& cell : granule.grid.time) {
      all.insert(cell.centre());
      times[std::string(name_of(granule.status))].insert(cell.centre());
    }
  }
  IngestCounts counts;
  counts.times = all.size();
  counts.members = members.size();
  for (const auto& [status, found] : times) counts.by_status[status] = found.size();
  return counts;
}

std::string text_of(const IngestCounts& counts, const std::string& status) {
  const std::string members =
      counts.members > 1 ? " of " + std::to_string(counts.members) + " members" : "";
  std::vector<std::string> parts;
  for (const auto& [name, times] : counts.by_status)
    parts.push_back(name + ", " + std::to_string(times) + " times" + members);
  if (parts.empty()) parts.push_back(status + ", 0 times");
  return joined(parts, ", and ");
}

}  // namespace slackwater::api
