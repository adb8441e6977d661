#pragma once
#include <memory>
#include <string>
#include <vector>

#include "fields/record/record.h"
#include "fields/site/site.h"

namespace slackwater {

/// How deep the water is and who says so.
struct WaterDepth {
  double depth_m = 0;
  std::string source;  ///< "site", "bathymetry", "station X" or "deepest wet level"
};

/// All that the store holds around one column of a site.
struct ColumnData {
  GeoPoint point;
  VectorRecord current;
  VectorRecord wind;  ///< brought to 10 m
  VectorRecord
      nearest_wind;  ///< of the nearest cell, at 10 m: for the baseline reference-slab alone
  ScalarRecord mixed_layer_depth;  ///< `mlotst`, m
  ScalarRecord temperature;        ///< `thetao`, K; read where no mixed-layer depth is stored
  ScalarRecord significant_height;
  ScalarRecord peak_period;      ///< converted where a dataset has none (wave_period.h)
  std::string wave_period_note;  ///< what an operator should know of it; empty: nothing
  ScalarRecord wave_direction;
  ScalarRecord sea_level;  ///< `zos`, m above the geoid
  WaterDepth water_depth;
};

/// The data around a site by quantity, not yet looked at from any place.
struct SitePieces {
  std::vector<VectorPiece> current;
  std::vector<VectorPiece> wind;
  std::vector<ScalarPiece> mixed_layer_depth;
  std::vector<ScalarPiece> temperature;
  std::vector<ScalarPiece> significant_height;
  std::vector<ScalarPiece> peak_period;
  std::vector<ScalarPiece> energy_period;         ///< read where a dataset has no peak period
  std::vector<ScalarPiece> zero_crossing_period;  ///< the same
  std::vector<ScalarPiece> wave_direction;
  std::vector<ScalarPiece> sea_level;
  std::vector<ScalarPiece> water_depth;
};

/// The data of a site over a window of time, read once and seen at each of its columns: all that a
/// forecast is made from. Movable, not copyable: the records point into the pieces.
struct SiteData {
  Site site;
  std::unique_ptr<const SitePieces> pieces;
  std::vector<ColumnData> columns;
  /// Columns asked for that lie on land or outside every current product.
  std::size_t dry_columns = 0;
  /// What of the store's files is damaged and was left out, as a clause; empty: nothing. Makes a
  /// forecast degraded.
  std::string damage;

  [[nodiscard]] bool has_currents() const;
  /// The column at a place, within 50 m; null where none is.
  [[nodiscard]] const ColumnData* column_at(const GeoPoint& point) const noexcept;
  /// Whether there are neither currents nor wind nor waves at any column.
  [[nodiscard]] bool is_empty() const;
};

/// Looks at the pieces from each column of the site. Columns without any water are left out and
/// counted. Error(not_found) for a site without currents that lies on land, or outside the grid of
/// the currents there are.
[[nodiscard]] SiteData site_data_of(const Site& site, SitePieces pieces);

}  // namespace slackwater
