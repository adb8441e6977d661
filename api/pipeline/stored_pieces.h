#pragma once
#include <string>
#include <vector>

#include "data/store/store.h"
#include "fields/record/site_data.h"

namespace slackwater::api {

/// A stored file that must not be opened.
struct DamagedFile {
  std::string product;
  std::string name;  ///< of the product file it came from
  std::string content_file;
  std::string fault;  ///< in words that follow the name of the content file
};

/// What the store holds around a site in a window of time, perhaps nothing, from those content
/// files alone that are whole (data/store/proven_content.h).
struct StoredPieces {
  SitePieces pieces;
  std::vector<DamagedFile> damaged;  ///< left out, each once
};
[[nodiscard]] StoredPieces stored_pieces(store::Store& store, const Site& site, UtcTime from,
                                         UtcTime to);

/// Those granules that may speak for the site (`ingest::comes_near`).
[[nodiscard]] std::vector<store::GranuleRow> near_site(std::vector<store::GranuleRow> granules,
                                                       const Site& site);

/// "the stored copy of waves.nc (PRODUCT) is damaged and left out: ingest it again, see `slackwater
/// store check`"; empty for none.
[[nodiscard]] std::string text_of(const std::vector<DamagedFile>& damaged);

}  // namespace slackwater::api
