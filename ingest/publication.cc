#include "ingest/publication.h"

#include <algorithm>
#include <array>

#include "fields/base/text.h"
#include "ingest/cf/time_code.h"

namespace slackwater::ingest {
namespace {

struct DateAttribute {
  const char* name;
  bool of_the_service;  ///< where a service cut the file, the date of the cut
};

constexpr std::array<DateAttribute, 5> dates{{{"date_issued", false},
                                              {"date_update", false},
                                              {"date_modified", true},
                                              {"date_created", true},
                                              {"creation_date", true}}};

/// A year of four nines is a mistake, or means "never".
const UtcTime latest_believed = UtcTime(std::chrono::sys_days(std::chrono::year(2200) / 1 / 1));

bool was_cut_by_a_service(const netcdf::File& file) {
  return std::any_of(file.attributes().begin(), file.attributes().end(), [](const auto& attribute) {
    if (attribute.name.starts_with("subset:") || attribute.name == "copernicusmarine_version")
      return true;
    return lower_case(attribute.name) == "history" &&
           contains_ignoring_case(attribute.text().value_or(""), "netcdf-java");
  });
}

/// The date of an attribute; a day stands for its end.
std::optional<UtcTime> date_in(const netcdf::File& file, const char* name, bool is_a_day,
                               std::vector<std::string>& warnings) {
  const auto text = file.text(name);
  if (!text || text->find_first_not_of(" \t\n") == std::string::npos) return std::nullopt;
  const auto found = find_date_and_clock(*text);
  if (!found || found->time > latest_believed) {
    warnings.push_back("the attribute " + std::string(name) + " says '" + text->substr(0, 40) +
                       "', expected a date like 2024-03-01T05:00:00Z; it is ignored");
    return std::nullopt;
  }
  if (found->has_clock && !is_a_day) return found->time;
  return UtcTime(day_of(found->time)) + std::chrono::days(1);
}

}  // namespace

std::optional<UtcTime> stated_publication(const netcdf::File& file,
                                          std::vector<std::string>& warnings) {
  const bool cut = was_cut_by_a_service(file);
  std::optional<UtcTime> latest;
  for (const DateAttribute& date : dates) {
    if (cut && date.of_the_service) continue;
    const auto found = date_in(file, date.name, false, warnings);
    if (found && (!latest || *latest < *found)) latest = found;
  }
  return latest ? latest : date_in(file, "bulletin_date", true, warnings);
}

std::optional<UtcTime> publication_of(const netcdf::File& file, const Ingested& ingested,
                                      const IngestOptions& options,
                                      std::vector<std::string>& warnings) {
  if (options.issued) return std::nullopt;
  const auto stated = stated_publication(file, warnings);
  if (!stated) return std::nullopt;
  for (const DecodedGranule& decoded : ingested.granules) {
    const Granule& granule = decoded.granule;
    const bool must_be_past =
        granule.status == DataStatus::observation || options.as == DataStatus::analysis;
    if (!must_be_past || granule.grid.time.empty()) continue;
    const UtcTime end = granule.grid.time.back().end;
    if (end <= *stated) continue;
    if (granule.status == DataStatus::observation) {
      warnings.push_back("says that it was published by " + format_utc(*stated) +
                         ", before its last observation of " + format_utc(end) +
                         "; when it was published is taken as unknown");
    }
    return std::nullopt;
  }
  return stated;
}

std::optional<UtcTime> published_by(const std::optional<UtcTime>& stated,
                                    const std::optional<UtcTime>& received) noexcept {
  return stated && received ? std::min(*stated, *received) : stated;
}

}  // namespace slackwater::ingest
