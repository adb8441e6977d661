#pragma once
#include <memory>
#include <string>
#include <vector>

#include "api/pipeline/pieces.h"
#include "api/pipeline/record.h"
#include "api/pipeline/site.h"

namespace slackwater::api {

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
  ScalarRecord peak_period;
  ScalarRecord wave_direction;
  WaterDepth water_depth;
};

/// The stored data of a site over a window of time, read once and seen at each of its columns.
/// Movable, not copyable: the records point into the pieces.
struct SiteData {
  struct Pieces {
    std::vector<VectorPiece> current;
    std::vector<VectorPiece> wind;
    std::vector<ScalarPiece> mixed_layer_depth;
    std::vector<ScalarPiece> temperature;
    std::vector<ScalarPiece> significant_height;
    std::vector<ScalarPiece> peak_period;
    std::vector<ScalarPiece> wave_direction;
    std::vector<ScalarPiece> water_depth;
  };
  Site site;
  std::unique_ptr<Pieces> pieces;
  std::vector<ColumnData> columns;
  std::size_t dry_columns =
      0;  ///< columns asked for that lie on land or outside every current product

  [[nodiscard]] bool has_currents() const;
};

/// Reads what the store holds for the site from `from` to `to`. Columns without any water are left
/// out and counted; a site with no data of any kind is Error(not_found), one on land or outside the
/// grid says so.
[[nodiscard]] SiteData load_site_data(store::Store& store, const Site& site, UtcTime from,
                                      UtcTime to);

}  // namespace slackwater::api
