#include "api/pipeline/load_site_data.h"

#include "api/pipeline/held_data.h"
#include "api/pipeline/stored_pieces.h"
#include "fields/base/error.h"
#include "fields/base/log.h"

namespace slackwater::api {
namespace {

/// What the store holds for the site in a window of time, perhaps nothing; damage is logged.
SiteData data_of(store::Store& store, const Site& site, UtcTime from, UtcTime to) {
  StoredPieces found = stored_pieces(store, site, from, to);
  for (const DamagedFile& file : found.damaged) {
    log_event(LogLevel::warning, "stored file left out",
              {{"name", file.name},
               {"product", file.product},
               {"content_file", file.content_file},
               {"problem", file.fault}});
  }
  SiteData data = site_data_of(site, std::move(found.pieces));
  data.damage = text_of(found.damaged);
  return data;
}

}  // namespace

SiteData load_site_data(store::Store& store, const Site& site, UtcTime from, UtcTime to) {
  SiteData data = data_of(store, site, from, to);
  if (data.is_empty()) {
    const bool is_damaged = !data.damage.empty();
    throw Error(
        is_damaged ? ErrorKind::invalid_input : ErrorKind::not_found,
        "the store holds nothing for site " + site.id + " at " + position_text(site.point) +
            " from " + format_utc(from) + " to " + format_utc(to) +
            (is_damaged ? " that can be read: " + data.damage : "; " + held_text(store, site)));
  }
  return data;
}

SiteData load_site_data(store::Store& store, const Site& site,
                        const calibration::ForecastOptions& options) {
  const UtcTime day(options.day.value_or(day_of(options.issued)));
  return load_site_data(store, site, day - calibration::history_wanted,
                        day + std::chrono::days(1) + options.horizon);
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
