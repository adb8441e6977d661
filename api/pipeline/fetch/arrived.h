#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "api/pipeline/fetch/wanted_files.h"

namespace slackwater::api {

/// What is in a file that came.
struct Arrived {
  std::string fault;             ///< why it is of no use, in words; empty: it is what was asked for
  std::string lacks;             ///< how early it ends, in words; empty: it does not
  std::string begins;            ///< how late it begins, in words; empty: it does not
  std::optional<UtcTime> until;  ///< the end of its times
};

/// Looks into a file as `ingest` reads it, in a confined process of its own: an answer in HTML,
/// half a file, another sea, yesterday's under today's name.
/// No thread may be alive and no store open (ingest/apart/decode_apart.h).
/// @param scratch  a folder for what it unpacks; empty again after that
[[nodiscard]] Arrived look_into(const std::filesystem::path& file, const WantedFile& wanted,
                                const ingest::ProductCatalogue& products, const Site& site,
                                const std::filesystem::path& scratch);

}  // namespace slackwater::api
