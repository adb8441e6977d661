#include "api/pipeline/load_site_data.h"

#include "fields/base/error.h"
#include "ingest/pieces.h"

namespace slackwater::api {
namespace {

/// The store's granules, in catalogue order.
std::vector<ingest::GranuleEntry> find_granules(store::Store& store,
                                                const std::vector<std::string>& standard_names,
                                                const ingest::Window& window) {
  store::GranuleQuery query;
  query.any_of = standard_names;
  query.from = window.from;
  query.to = window.to;
  query.box = window.box;
  query.margin_km = ingest::granule_margin_km;
  std::vector<ingest::GranuleEntry> found;
  for (const store::GranuleRow& row : store.find_granules(query)) {
    found.push_back({row.id, row.source_sha256, row.product_id, row.standard_names,
                     store.content_path(row.content_sha256), row.ingested_at});
  }
  return found;
}

}  // namespace

SiteData load_site_data(store::Store& store, const Site& site, UtcTime from, UtcTime to) {
  SiteData data = site_data_of(
      site, ingest::pieces_of(site, from, to, [&](const auto& standard_names, const auto& window) {
        return find_granules(store, standard_names, window);
      }));
  if (data.is_empty()) {
    throw Error(ErrorKind::not_found,
                "the store holds nothing for site " + site.id + " at " + position_text(site.point) +
                    " from " + format_utc(from) + " to " + format_utc(to) +
                    "; ingest product files first (`forecast --print-downloads` shows which)");
  }
  return data;
}

}  // namespace slackwater::api
