#pragma once
#include <span>
#include <string>
#include <vector>

#include "fields/base/frame.h"
#include "fields/base/time.h"
#include "fields/geo/geo_point.h"
#include "fields/grid/status.h"

namespace slackwater {

/// Sea state at one time; NaN where the forecast has none.
struct SeaState {
  double significant_height_m = 0;
  double peak_period_s = 0;
  double from_direction_deg = 0;  ///< clockwise from true north, where waves come from
};

/// The forecast at one place: every array runs over Snapshot::time, current arrays over time x
/// depth (depth fastest).
struct ForecastColumn {
  GeoPoint point;
  double water_depth_m = 0;
  std::string water_depth_source;         ///< "site", "bathymetry" or "deepest wet level"
  std::vector<Horizontal> current_m_s;    ///< Eulerian, towards
  std::vector<double> current_sigma_m_s;  ///< standard deviation of each component
  std::vector<SampleStatus> current_status;
  std::vector<Horizontal> wind_m_s;     ///< at 10 m, towards; empty if the forecast has no wind
  std::vector<DataStatus> wind_source;  ///< per time
  std::vector<SeaState> sea;            ///< empty if the forecast has no waves
  std::vector<DataStatus> sea_source;   ///< per time
};

/// One forecast as issued: everything needed to answer "what is the water doing here, then".
/// Immutable.
struct Snapshot {
  std::string site_id;
  std::string site_name;
  UtcDay day;  ///< day D, the last calibrated day
  UtcTime issued;
  std::string wind_policy;      ///< best | forecast | persist
  std::vector<UtcTime> time;    ///< hourly from the end of D, both ends included
  std::vector<double> depth_m;  ///< below mean sea level, ascending
  std::vector<ForecastColumn> columns;
  bool degraded = false;
  bool contains_stokes = false;  ///< the currents it was fitted to still hold Stokes drift
  std::string headline;          ///< one sentence a coordinator reads first
  std::vector<std::string> attributions;
  std::string provenance_json;  ///< inputs (sha256), calibration, code version
};

/// The current at one place, depth and time.
struct CurrentSample {
  Horizontal velocity_m_s{};
  double sigma_m_s = 0;  ///< standard deviation of each component
  SampleStatus status = SampleStatus::missing;
};

/// Linear in time and depth between the snapshot's stamps. Above the top level the top value holds,
/// below the deepest level down to the bed the deepest value holds (physics between: the model
/// decides, see `snapshot.cc`). Batch call; no allocation, thread-safe. `depths_m` and `out` have
/// the same length.
void sample_profile(const Snapshot& snapshot, std::size_t column, UtcTime time,
                    std::span<const double> depths_m, std::span<CurrentSample> out) noexcept;

}  // namespace slackwater
