#include "fields/record/site_data.h"

#include <algorithm>
#include <cmath>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "fields/record/nearest_wind.h"
#include "fields/record/wave_period.h"
#include "fields/wind/log_profile.h"

namespace slackwater {
namespace {

/// Brings each piece to 10 m: the level nearest to it, by the logarithmic profile where it is
/// another height.
VectorRecord at_ten_metres(VectorRecord record) {
  for (auto& piece : record.pieces) {
    VectorColumn& column = piece.column;
    if (column.levels_m.empty()) continue;
    const auto nearest = std::min_element(
        column.levels_m.begin(), column.levels_m.end(),
        [](double a, double b) { return std::abs(a - 10.0) < std::abs(b - 10.0); });
    const auto k = static_cast<std::size_t>(nearest - column.levels_m.begin());
    const double factor = log_profile_ratio(10.0, *nearest);
    VectorColumn flat;
    flat.point = column.point;
    flat.time = column.time;
    flat.source = column.source;
    if (std::abs(*nearest - 10.0) > 0.5) piece.from_height_m = *nearest;
    for (std::size_t t = 0; t < column.times(); ++t) {
      flat.value.push_back(factor * column.value[column.offset(t, k)]);
      flat.status.push_back(column.status[column.offset(t, k)]);
    }
    column = std::move(flat);
  }
  return record;
}

/// The centres of the cells that a block asks for, wet at the top level at some time, in the first
/// current product that covers the block.
std::vector<GeoPoint> cells_of(const ColumnBlock& block, const std::vector<VectorPiece>& pieces,
                               std::size_t& dry) {
  std::vector<GeoPoint> points;
  for (const VectorPiece& piece : pieces) {
    const Grid& grid = piece.east.grid;
    if (piece.origin.is_point_series) continue;
    std::vector<std::size_t> rows;
    std::vector<std::size_t> columns;
    for (std::size_t j = 0; j < grid.rows(); ++j) {
      if (grid.latitude_deg[j] >= block.box.south_deg &&
          grid.latitude_deg[j] <= block.box.north_deg)
        rows.push_back(j);
    }
    for (std::size_t i = 0; i < grid.columns(); ++i) {
      const double middle = 0.5 * (block.box.south_deg + block.box.north_deg);
      if (block.box.contains(GeoPoint::from_degrees(middle, grid.longitude_deg[i])))
        columns.push_back(i);
    }
    const auto step = static_cast<std::size_t>(block.every);
    for (std::size_t j = 0; j < rows.size(); j += step) {
      for (std::size_t i = 0; i < columns.size(); i += step) {
        bool wet = false;
        for (std::size_t t = 0; t < grid.times() && !wet; ++t) {
          const std::size_t offset = grid.offset(t, 0, rows[j], columns[i]);
          wet = !std::isnan(piece.east.values[offset]) && !std::isnan(piece.north.values[offset]);
        }
        if (wet) {
          points.push_back(
              GeoPoint::from_degrees(grid.latitude_deg[rows[j]], grid.longitude_deg[columns[i]]));
        } else {
          ++dry;
        }
      }
    }
    if (!points.empty()) break;
  }
  return points;
}

WaterDepth water_depth_at(const Site& site, const std::vector<ScalarPiece>& bathymetry,
                          const ColumnData& column) {
  if (site.water_depth_m && site.columns.empty() && !site.column_block)
    return {*site.water_depth_m, "site"};
  for (const auto& piece : record_at(bathymetry, column.point).pieces) {
    if (piece.column.has(0) && piece.column.value[0] > 0)
      return {piece.column.value[0], "bathymetry"};
  }
  if (site.water_depth_m) return {*site.water_depth_m, "site"};
  for (const auto& piece : column.current.pieces) {
    if (piece.origin->water_depth_m && piece.distance_m < 1000.0)
      return {*piece.origin->water_depth_m, "station " + piece.origin->station};
  }
  double deepest = 0;
  for (const auto& piece : column.current.pieces) {
    const VectorColumn& c = piece.column;
    for (std::size_t k = 0; k < c.levels_m.size(); ++k) {
      for (std::size_t t = 0; t < c.times(); ++t) {
        if (c.has(t, k)) deepest = std::max(deepest, c.levels_m[k]);
      }
    }
  }
  return {deepest, "deepest wet level"};
}

}  // namespace

bool SiteData::has_currents() const {
  return std::any_of(columns.begin(), columns.end(),
                     [](const ColumnData& c) { return !c.current.pieces.empty(); });
}

const ColumnData* SiteData::column_at(const GeoPoint& point) const noexcept {
  constexpr double same_place_m = 50;
  const auto found = std::find_if(columns.begin(), columns.end(), [&](const ColumnData& one) {
    return one.point == point || distance_m(one.point, point) < same_place_m;
  });
  return found == columns.end() ? nullptr : &*found;
}

bool SiteData::is_empty() const {
  return std::all_of(columns.begin(), columns.end(), [](const ColumnData& c) {
    return c.current.pieces.empty() && c.wind.pieces.empty() && c.significant_height.pieces.empty();
  });
}

SiteData site_data_of(const Site& site, SitePieces all) {
  SiteData data;
  data.site = site;
  data.pieces = std::make_unique<const SitePieces>(std::move(all));
  const SitePieces& pieces = *data.pieces;

  std::vector<GeoPoint> points = site.columns;
  if (site.column_block) points = cells_of(*site.column_block, pieces.current, data.dry_columns);
  if (points.empty() && !site.column_block) points = {site.point};

  bool on_land = false;
  for (const GeoPoint& point : points) {
    ColumnData column;
    column.point = point;
    column.current = record_at(pieces.current, point);
    on_land = on_land || column.current.on_land;
    if (points.size() > 1 && column.current.pieces.empty() && !pieces.current.empty()) {
      ++data.dry_columns;
      continue;
    }
    column.wind = record_at(pieces.wind, point);
    column.nearest_wind = at_ten_metres(nearest_wind(column.wind, pieces.wind, point));
    column.wind = at_ten_metres(std::move(column.wind));
    column.mixed_layer_depth = record_at(pieces.mixed_layer_depth, point);
    column.temperature = record_at(pieces.temperature, point);
    column.significant_height = record_at(pieces.significant_height, point);
    WavePeriod period = wave_period_at(pieces, point, !column.significant_height.pieces.empty());
    column.peak_period = std::move(period.peak_period);
    column.wave_period_note = std::move(period.note);
    column.wave_direction = record_at(pieces.wave_direction, point);
    column.sea_level = record_at(pieces.sea_level, point);
    column.water_depth = water_depth_at(site, pieces.water_depth, column);
    data.columns.push_back(std::move(column));
  }
  if (!data.has_currents() && on_land) {
    throw Error(ErrorKind::not_found,
                "site " + site.id + " at " + position_text(site.point) +
                    " is on land in the stored current product; move the site into the water, or "
                    "ingest a product that has water there");
  }
  if (!data.has_currents() && !pieces.current.empty() && !site.column_block) {
    const BoundingBox box = coverage_of(pieces.current.front().east.grid);
    const std::string extent = formatted("{:.3f}..{:.3f} E, {:.3f}..{:.3f} N", box.west_deg,
                                         box.east_deg, box.south_deg, box.north_deg);
    throw Error(ErrorKind::not_found, "site " + site.id + " at " + position_text(site.point) +
                                          " lies outside the stored currents nearest to it (" +
                                          extent + "); ingest a product that covers it");
  }
  return data;
}

}  // namespace slackwater
