#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/time.h"
#include "fields/geo/geo_point.h"
#include "fields/grid/gridded_field.h"
#include "fields/grid/status.h"
#include "fields/service/forecast_origin.h"
#include "fields/service/wind_policy.h"

namespace slackwater::store {

/// Of names that a catalogue holds: what lists, links and headers have in them.
inline constexpr std::size_t longest_name_bytes = 4096;

/// A product file that was ingested. (sha256, cut_key) is its identity: the same file cut
/// differently is another source.
struct SourceFile {
  std::string sha256;  ///< of the product file
  std::string
      cut_key;       ///< "" or the canonical text of the cut and of the operator's --as / --issued
  std::string name;  ///< as the operator knew it
  std::uint64_t bytes = 0;
  std::string product_id;
  std::string dataset_id;
  std::string attribution;  ///< the sentence to print
  UtcTime ingested_at{};
  std::optional<UtcTime> published_at;  ///< by its provider, where the file says it
  std::vector<std::string> warnings;
  bool operator==(const SourceFile&) const = default;
};

/// What one product file holds on one grid; its values lie in the content file.
struct GranuleRow {
  std::int64_t id = 0;                      ///< given by the store
  std::string source_sha256;                ///< given by the store
  std::string cut_key;                      ///< given by the store
  std::string content_sha256;               ///< given by the store
  std::vector<std::string> standard_names;  ///< CF, in file order
  bool contains_stokes = false;
  bool is_point_series = false;
  std::string station;  ///< "" for gridded products
  DataStatus status = DataStatus::analysis;
  std::optional<UtcTime> reference_time;
  std::optional<int> ensemble_member;
  std::optional<UtcTime> first_time;  ///< start of the first cell; absent for a static field
  std::optional<UtcTime> last_time;   ///< end of the last cell; absent for a static field
  std::size_t times = 0;
  BoundingBox bounds;  ///< what the cells cover; west > east across the antimeridian
  VerticalKind vertical = VerticalKind::none;
  std::optional<double> lowest_level_m;   ///< smallest level, in the sense of `vertical`
  std::optional<double> highest_level_m;  ///< largest level
  std::string product_id;
  std::string dataset_id;
  std::string attribution;
  UtcTime ingested_at{};                ///< given by the store: that of the source
  std::optional<UtcTime> published_at;  ///< given by the store: that of the source
  bool operator==(const GranuleRow&) const = default;
};

/// A granule to be stored: its row and its finished content file, in this process's staging folder.
struct NewGranule {
  GranuleRow row;
  std::filesystem::path content_file;
};

/// Which granules are wanted; what is not set does not restrict.
struct GranuleQuery {
  std::vector<std::string>
      any_of;  ///< standard names, one of which the granule must hold; empty: any
  std::optional<UtcTime>
      from;                   ///< granules that end before it are out; static fields are always in
  std::optional<UtcTime> to;  ///< granules that begin after it are out
  std::optional<BoundingBox>
      box;                        ///< granules that do not touch it (widened by the margin) are out
  std::optional<GeoPoint> point;  ///< the same for a point
  double margin_km = 0;
  std::optional<UtcTime> ingested_by;  ///< known at this instant: ingested then or earlier
  std::optional<DataStatus> status;
};

/// One forecast as issued.
struct ForecastRow {
  std::int64_t id = 0;  ///< given by the store
  std::string site_id;
  UtcDay day{};  ///< day D, the last calibrated day
  UtcTime issued{};
  UtcTime valid_from{};
  UtcTime valid_to{};
  WindPolicy wind_policy = WindPolicy::best;
  ForecastOrigin origin = ForecastOrigin::forecast;
  bool degraded = false;
  std::string headline;
  std::string content_sha256;  ///< given by the store
  std::string summary_json;    ///< calibration report, effective configuration
  std::string code_version;
  std::vector<std::int64_t>
      input_granules;  ///< ids; these granules stay as long as the forecast does
  bool operator==(const ForecastRow&) const = default;
};

struct NewForecast {
  ForecastRow row;
  std::filesystem::path content_file;
};

/// A forecast that is in the store now.
struct FiledForecast {
  std::int64_t id = 0;
  bool is_new = true;  ///< false: it was issued before, to the byte
  std::string content_sha256;
};

/// Which forecasts are wanted; what is not set does not restrict.
struct ForecastQuery {
  std::string site_id;             ///< empty: all sites
  std::optional<UtcDay> from_day;  ///< day D, both ends included
  std::optional<UtcDay> to_day;
  std::optional<ForecastOrigin> origin;
  std::optional<WindPolicy> wind_policy;
};

}  // namespace slackwater::store
