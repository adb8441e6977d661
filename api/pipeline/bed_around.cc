#include "api/pipeline/bed_around.h"

#include <algorithm>
#include <cmath>

#include "api/pipeline/stored_pieces.h"
#include "fields/base/error.h"
#include "fields/record/record.h"

namespace slackwater::api {
namespace {

/// Beyond what the site describes; `ingest::pieces_of` reads 0.3 more.
constexpr double beyond_deg = 0.5;

/// The site with nothing but corners around all that it describes, as columns: data are read around
/// these.
Site with_its_surroundings(const Site& site) {
  double south_deg = site.point.latitude_deg(), north_deg = south_deg;
  double west_deg = 0, east_deg = 0;  // of the site's own point
  const auto reach = [&](const GeoPoint& point) {
    south_deg = std::min(south_deg, point.latitude_deg());
    north_deg = std::max(north_deg, point.latitude_deg());
    const double east = std::remainder(point.longitude_deg() - site.point.longitude_deg(), 360.0);
    west_deg = std::min(west_deg, east);
    east_deg = std::max(east_deg, east);
  };
  for (const GeoPoint& column : site.columns) reach(column);
  for (const TurbinePlace& turbine : site.turbines) reach(turbine.point);
  for (const CableRoute& cable : site.cables)
    for (const GeoPoint& point : cable.route) reach(point);
  for (const ConstraintArea& area : site.areas)
    for (const GeoPoint& corner : area.corners) reach(corner);
  Site around = site;
  around.water_depth_m.reset();
  around.column_block.reset();
  const double here_deg = site.point.longitude_deg();
  around.columns = {GeoPoint::from_degrees(std::max(-90.0, south_deg - beyond_deg),
                                           here_deg + west_deg - beyond_deg),
                    GeoPoint::from_degrees(std::min(90.0, north_deg + beyond_deg),
                                           here_deg + east_deg + beyond_deg)};
  return around;
}

bool has_any(const ScalarPiece& piece) {
  return !piece.origin.is_point_series &&
         std::any_of(piece.field.values.begin(), piece.field.values.end(),
                     [](float depth_m) { return !std::isnan(depth_m); });
}

}  // namespace

ScalarPiece bed_around(store::Store& store, const Site& site) {
  const UtcTime before_all{};  // static fields are in every window, all else is in none of this one
  StoredPieces found = stored_pieces(store, with_its_surroundings(site), before_all, before_all);
  std::vector<ScalarPiece>& beds = found.pieces.water_depth;
  std::erase_if(beds, [](const ScalarPiece& piece) { return !has_any(piece); });
  if (beds.empty()) {
    const bool is_damaged = !found.damaged.empty();
    throw Error(is_damaged ? ErrorKind::invalid_input : ErrorKind::not_found,
                "found no bathymetry around site " + site.id + " in the store" +
                    (is_damaged ? " that can be read: " + text_of(found.damaged)
                                : "; ingest one, for instance a file of GEBCO or the static file "
                                  "of a current product"));
  }
  for (const auto& piece : record_at(beds, site.point).pieces)
    if (piece.column.has(0) && piece.column.value[0] > 0)
      for (ScalarPiece& bed : beds)
        if (&bed.origin == piece.origin) return std::move(bed);
  return std::move(beds.front());
}

}  // namespace slackwater::api
