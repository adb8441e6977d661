#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fields/grid/gridded_field.h"

namespace slackwater {

/// One quantity of a granule, without its values.
struct GranuleVariable {
  std::string standard_name;     ///< CF standard name: the key at every boundary
  std::string unit;              ///< canonical SI
  std::string source_name;       ///< as the provider wrote it, e.g. "vozocrtx"
  bool contains_stokes = false;  ///< a current that still holds Stokes drift
  bool has_status = false;       ///< a per-value status stands beside the values (in-situ)
  /// Whether a current contains the tide; nothing where nobody says.
  std::optional<bool> has_tide{};
  bool operator==(const GranuleVariable&) const = default;
};

/// What one product file holds on one grid: the unit of the store. Values live in the granule's
/// content file (ingest/cf/granule_file.h), immutable and named by its sha256.
struct Granule {
  Grid grid;
  std::vector<GranuleVariable> variables;
  bool is_point_series = false;         ///< observations at one place (grid 1 x 1)
  std::string station;                  ///< platform name for point series
  std::optional<double> water_depth_m;  ///< where the file states it
  /// Standard error of a measured component of the current, where the file states it.
  std::optional<double> stated_error_m_s;
  DataStatus status = DataStatus::analysis;
  std::optional<UtcTime> reference_time;  ///< forecast issue time
  /// How long after it the product's runs are usually published; 0 where nobody says.
  Duration published_after{0};
  std::optional<int> ensemble_member;  ///< NWP perturbation number
  std::string product_id;              ///< e.g. "MEDSEA_ANALYSISFORECAST_PHY_006_013"
  std::string dataset_id;              ///< where known
  std::string attribution;             ///< the sentence to print
  bool is_regional = false;            ///< of a product made for a region
};

}  // namespace slackwater
