#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/local_time.h"
#include "fields/base/time.h"
#include "fields/geo/geo_point.h"
#include "fields/site/chart_datum.h"
#include "fields/site/constraint_area.h"
#include "fields/site/farm.h"
#include "fields/wave/fetch.h"

namespace slackwater {

/// A block of product cells: every n-th wet cell whose centre lies in the box becomes a column.
struct ColumnBlock {
  BoundingBox box;
  int every = 1;
};

/// How people and vehicles get to the turbines.
struct SiteAccess {
  std::string vessel;  ///< id of a sheet of `data/vessels`, or its file
  Duration passage{};  ///< from port to the farm, and home again the same
};

/// An offshore site as `data/sites/*.yaml` describes it (fields/docs/conventions.md).
struct Site {
  std::string id;
  std::string name;
  GeoPoint point;
  std::optional<double> water_depth_m;
  std::optional<ChartDatum> chart_datum;  ///< absent: nobody says, and none is assumed
  std::optional<double> hub_height_m;
  /// How far the wind blows over water, for waves that are computed from the wind.
  std::optional<Fetch> fetch;
  /// The product whose currents lead here; absent: by precedence (fields/record).
  std::optional<std::string> current_product;
  std::optional<TimeZone> time_zone;  ///< of its clocks: shown beside UTC
  std::vector<TurbinePlace> turbines;
  std::vector<CableRoute> cables;
  std::vector<ConstraintArea> areas;
  std::vector<std::string> tasks;
  std::string shift;  ///< "06:00-18:00" of its clocks, in which work is done; empty: at any hour
  std::optional<SiteAccess> access;  ///< absent: nobody says, and nothing of it is judged
  std::vector<GeoPoint> columns;     ///< extra columns; empty: the site's own point alone
  std::optional<ColumnBlock> column_block;
  std::string yaml;  ///< the text it was read from, kept with every result

  /// The smallest box that holds every column, with a margin in degrees.
  [[nodiscard]] BoundingBox box(double margin_deg) const;
};

/// At most 64 letters, digits, '-', '_' or '.', for it names a folder.
[[nodiscard]] bool is_site_id(std::string_view id);

/// Reads a site from YAML; unknown keys, values out of range and contradictions are
/// Error(invalid_input).
[[nodiscard]] Site parse_site(std::string_view yaml, std::string_view name);

/// A site's file as text, and its path.
struct SiteText {
  std::string yaml;
  std::string file;
};
/// What `find_site` reads, not parsed. Throws likewise.
[[nodiscard]] SiteText find_site_text(const std::string& id_or_path,
                                      const std::vector<std::filesystem::path>& folders);

/// Finds a site by id in the sites folders, or by the path of its file. Throws Error(not_found)
/// that lists the ids there are.
[[nodiscard]] Site find_site(const std::string& id_or_path,
                             const std::vector<std::filesystem::path>& folders);

/// Ids of the sites in these folders, sorted.
[[nodiscard]] std::vector<std::string> known_sites(
    const std::vector<std::filesystem::path>& folders);

}  // namespace slackwater
