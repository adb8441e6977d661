#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fields/base/time.h"
#include "ingest/decoded/ingested.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {

/// When the provider published what a file holds, as its global attributes say it.
///
///   date_issued, date_update, date_modified,
///   date_created, creation_date                 the latest that is there
///   bulletin_date                               else the end of that day
///
/// A file is not out before it was last changed, hence the latest. `date_issued`, `date_modified`
/// and `date_created` are ACDD's; `date_update` is OceanSITES' and the in-situ centres';
/// `creation_date` stands in Copernicus files for `date_created`. `bulletin_date` names the run of
/// an ocean model: what it made is out by the end of that day. A date without a time of day is the
/// end of its day.
///
/// Left out: `history` and `subset:date`, which tell of the download; and where a file was cut by a
/// service that rewrites it (`subset:…`, `copernicusmarine_version`, a history of NetCDF-Java), its
/// `date_modified`, `date_created` and `creation_date`, which are that service's. An attribute
/// without a readable date adds a warning.
///
/// Source: ESIP, Attribute Convention for Data Discovery 1.3; OceanSITES Data Format Reference
/// Manual 1.4, global attributes.
[[nodiscard]] std::optional<UtcTime> stated_publication(const netcdf::File& file,
                                                        std::vector<std::string>& warnings);

/// The stated publication where it can be that of these granules: analyses that the operator
/// declares (`--as analysis`) and observations are not out before their last value, and who gives
/// `--issued` knows better than the file. Nothing otherwise; with a warning for observations.
[[nodiscard]] std::optional<UtcTime> publication_of(const netcdf::File& file,
                                                    const Ingested& ingested,
                                                    const IngestOptions& options,
                                                    std::vector<std::string>& warnings);

/// What is in hand has been published: never later than when the file came in.
[[nodiscard]] std::optional<UtcTime> published_by(const std::optional<UtcTime>& stated,
                                                  const std::optional<UtcTime>& received) noexcept;

}  // namespace slackwater::ingest
