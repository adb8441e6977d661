#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fields/record/site_data.h"
#include "fields/site/site.h"
#include "ingest/copernicus/product_catalogue.h"
#include "ingest/ingest.h"

namespace slackwater::ingest {

/// A product file, and what its reader knows of it.
struct FileToRead {
  std::filesystem::path path;
  IngestOptions options;
  /// When it came in, where that is known: from then on all that it holds is known, however far
  /// into the future it runs. Without it values are known once they are valid.
  std::optional<UtcTime> received{};
};

/// The data around a site, with the warnings that an operator should read, each behind its file's
/// name.
struct ReadPieces {
  SitePieces pieces;
  std::vector<std::string> warnings;
};

/// Reads product files for a forecast without a store: the same pieces, to the bit, as those of a
/// store that ingested these files in this order. Of two values that are equally good the later
/// file's wins; a file given twice with the same options counts once.
///
/// @param from, to  the window of time; a forecast of day D looks back over
///                  `calibration::history_wanted` and ahead to its horizon
///
/// Granules pass through a folder of their own below the system's folder for temporary files, gone
/// when the call ends. Throws what `decode_file` throws, Error(unavailable) where there is no room
/// for that folder.
[[nodiscard]] ReadPieces read_pieces(std::span<const FileToRead> files,
                                     const ProductCatalogue& products, const Site& site,
                                     UtcTime from, UtcTime to);

}  // namespace slackwater::ingest
