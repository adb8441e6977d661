#include "api/pipeline/load_site_data.h"

#include "api/pipeline/held_data.h"
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

/// What the store holds for the site in a window of time, perhaps nothing.
SiteData data_of(store::Store& store, const Site& site, UtcTime from, UtcTime to) {
  return site_data_of(
      site, ingest::pieces_of(site, from, to, [&](const auto& standard_names, const auto& window) {
        return find_granules(store, standard_names, window);
      }));
}

}  // namespace

SiteData load_site_data(store::Store& store, const Site& site, UtcTime from, UtcTime to) {
  SiteData data = data_of(store, site, from, to);
  if (data.is_empty()) {
    throw Error(ErrorKind::not_found, "the store holds nothing for site " + site.id + " at " +
                                          position_text(site.point) + " from " + format_utc(from) +
                                          " to " + format_utc(to) + "; " + held_text(store, site));
  }
  return data;
}

std::optional<double> bathymetry_at(store::Store& store, const Site& site) {
  Site point = site;
  point.water_depth_m.reset();
  point.columns.clear();
  point.column_block.reset();
  const UtcTime before_all{};  // static fields are in every window, all else is in none of this one
  const SiteData data = data_of(store, point, before_all, before_all);
  const WaterDepth& depth = data.columns.front().water_depth;
  if (depth.source != "bathymetry") return std::nullopt;
  return depth.depth_m;
}

}  // namespace slackwater::api
