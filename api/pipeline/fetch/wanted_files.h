#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fields/base/time.h"
#include "fields/geo/geo_point.h"
#include "fields/site/site.h"
#include "ingest/copernicus/product_catalogue.h"

namespace slackwater::api {

/// Of which times the inputs of a forecast are wanted.
struct WantedTimes {
  UtcDay day;        ///< D
  UtcTime issued;    ///< when the forecast is issued: whose run of the wind there is by then
  Duration horizon;  ///< how far beyond the end of D
  Duration history = std::chrono::days(3);  ///< how long before D: three days for the tide
};

/// One file that a forecast at a site wants.
struct WantedFile {
  std::string kind;        ///< "currents", "level", "waves", "bathymetry", "wind", "wind forecast"
  std::string product_id;  ///< of the catalogue; "NOAA GFS"
  std::string dataset_id;  ///< of Copernicus Marine; else empty
  std::optional<std::string> part;
  std::vector<std::string> variables;  ///< by their names in the dataset
  BoundingBox box;
  std::optional<double> deepest_m;     ///< of what has depth: from the surface down to it
  std::optional<UtcTime> from, to;     ///< absent of what has no time
  std::optional<UtcDay> since;         ///< `from` is this day: those before are not kept
  std::optional<UtcTime> run;          ///< of a model of the weather: the newest that is out
  std::vector<std::string> addresses;  ///< of the wind forecast: one for each step, in their order
  std::string file;                    ///< its name; empty: nothing is to be fetched, see `why_not`
  std::string why_not;                 ///< in words
};

/// Of each kind, in this order: currents, level, waves, bathymetry, wind of the past, wind
/// forecast. Of Copernicus Marine the dataset with tide, else the finest, that has water at the
/// site.
[[nodiscard]] std::vector<WantedFile> wanted_files(const ingest::ProductCatalogue& products,
                                                   const Site& site, const WantedTimes& wanted);

/// "2025-03-06T00:00:00": UTC without its Z, as the toolbox of Copernicus Marine takes it.
[[nodiscard]] std::string compact_time(UtcTime time);

/// The last day that the archives of forecasts of Copernicus Marine hold at a time: two years,
/// rolling, as the product user manuals say.
[[nodiscard]] UtcDay archives_begin(UtcTime issued);

}  // namespace slackwater::api
