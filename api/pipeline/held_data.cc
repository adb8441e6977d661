#include "api/pipeline/held_data.h"

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "api/pipeline/stored_pieces.h"
#include "calibration/day/leading_day.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/pieces.h"

namespace slackwater::api {
namespace {

using std::chrono::days;
using std::chrono::hours;

struct Kind {
  const char* name;
  const char* standard_name;
};

constexpr std::array<Kind, 3> kinds{{{"currents", "eastward_sea_water_velocity"},
                                     {"wind", "eastward_wind"},
                                     {"waves", "sea_surface_wave_significant_height"}}};

std::vector<store::GranuleRow> granules_near(store::Store& store, const Site& site,
                                             const char* standard_name) {
  store::GranuleQuery query;
  query.any_of = {standard_name};
  query.box = site.box(0);
  query.margin_km = ingest::farthest_granule_km;
  return near_site(store.find_granules(query), site);
}

struct Reach {
  UtcTime from{};
  UtcTime to{};
};

std::optional<Reach> reach_of(const std::vector<store::GranuleRow>& rows) {
  std::optional<Reach> reach;
  for (const store::GranuleRow& row : rows) {
    if (!row.first_time || !row.last_time) continue;
    if (!reach) reach = {*row.first_time, *row.last_time};
    reach->from = std::min(reach->from, *row.first_time);
    reach->to = std::max(reach->to, *row.last_time);
  }
  return reach;
}

std::string box_text(const BoundingBox& box) {
  return formatted("{:.2f} to {:.2f} N, {:.2f} to {:.2f} E", box.south_deg, box.north_deg,
                   box.west_deg, box.east_deg);
}

/// Whether some granule comes near the point with its coordinates exchanged.
bool looks_swapped(store::Store& store, const Site& site) {
  if (std::abs(site.point.longitude_deg()) > 90) return false;
  Site swapped = site;
  swapped.point = GeoPoint::from_degrees(site.point.longitude_deg(), site.point.latitude_deg());
  swapped.columns.clear();
  swapped.column_block.reset();
  for (const Kind& kind : kinds)
    if (!granules_near(store, swapped, kind.standard_name).empty()) return true;
  return false;
}

/// For a site that no product comes near.
std::string area_text(store::Store& store, const Site& site) {
  std::string text;
  for (const Kind& kind : kinds) {
    store::GranuleQuery query;
    query.any_of = {kind.standard_name};
    const auto rows = store.find_granules(query);
    if (rows.empty()) continue;
    text += (text.empty() ? "" : "; ") + std::string(kind.name) + " cover " +
            box_text(rows.back().bounds);
  }
  if (text.empty())
    return "it holds no currents, wind or waves at all: ingest product files first (`forecast "
           "--print-downloads` shows which)";
  if (looks_swapped(store, site))
    return "no product in it is near the site, but one is near if latitude and longitude are "
           "exchanged: did you swap latitude and longitude? (its " +
           text + ")";
  return "no product in it is near the site: its " + text +
         "; ingest product files around the site first (`forecast --print-downloads` shows which)";
}

/// The newest whole day of currents, if any.
std::optional<UtcDay> newest_day(store::Store& store, const Site& site, const Reach& currents) {
  try {
    const SiteData data = site_data_of(
        site, stored_pieces(store, site, currents.to - days(10), currents.to + days(1)).pieces);
    const auto leading = calibration::leading_day(data, {currents.to + days(2)});
    return leading ? std::optional(leading->day) : std::nullopt;
  } catch (const Error&) {  // a site on land: the advice is left out, no more
    return std::nullopt;
  }
}

}  // namespace

std::string held_text(store::Store& store, const Site& site) {
  std::string text;
  std::optional<Reach> currents;
  for (const Kind& kind : kinds) {
    const auto reach = reach_of(granules_near(store, site, kind.standard_name));
    if (!reach) continue;
    text += (text.empty() ? "" : ", ") + std::string(kind.name) + " from " +
            format_utc(reach->from) + " to " + format_utc(reach->to);
    if (!currents && kind.standard_name == kinds[0].standard_name) currents = reach;
  }
  if (text.empty()) return area_text(store, site);
  text = "it holds " + text;
  const auto day = currents ? newest_day(store, site, *currents) : std::nullopt;
  if (!day) return text + "; there is no whole day of currents in it: ingest more product files";
  return text + "; `--day " + format_day(*day) + "` would work, or `--at " +
         format_utc(UtcTime(*day) + days(1) + hours(5)) +
         "` for the forecast of that time, or ingest newer product files";
}

}  // namespace slackwater::api
