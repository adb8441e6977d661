#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/time.h"
#include "fields/geo/geo_point.h"
#include "fields/record/site_data.h"
#include "fields/site/site.h"

namespace slackwater::ingest {

/// The window of time and space that is read.
struct CutOut {
  std::optional<UtcTime> from;  ///< absent for static fields
  std::optional<UtcTime> to;
  BoundingBox box;   ///< of the cells that are read
  BoundingBox site;  ///< of the site's columns alone
};

/// A decoded granule as a list of granules names it, before its content file is opened.
struct GranuleEntry {
  std::int64_t number = 0;                  ///< of two granules the later ingested has the larger
  std::string source_sha256;                ///< of the product file
  std::string product_id;                   ///< for messages
  std::vector<std::string> standard_names;  ///< CF, that it holds
  std::filesystem::path content_file;       ///< ingest/cf/granule_file.h
  std::optional<UtcTime> received{};        ///< when the product file came in, where that is known
  std::optional<UtcTime> published{};       ///< when its provider published it, where that is known
};

/// Whether a product is one that a file does not name: two of them may be anybody's.
[[nodiscard]] bool is_nobodys(const std::string& product_id);

/// Grids that come nearer than this to the window's box are looked at.
inline constexpr double granule_margin_km = 10;
/// Nothing farther from a site speaks for it, in any direction: the reach of a wind mast.
inline constexpr double farthest_granule_km = 50;

/// Whether a granule may speak for what lies in the window: a grid by its cells, a point series
/// within its reach, in metres (`series_reach_m`), from the site.
[[nodiscard]] bool comes_near(bool is_point_series, const BoundingBox& bounds,
                              const std::vector<std::string>& standard_names, const CutOut& window);

/// The granules that hold any of these standard names, do not end before the window or begin after
/// it (static fields always count) and come near it (`comes_near`); in catalogue order: by first
/// time (static fields first), then name of the status, reference time, ensemble member (absent
/// before present), number.
using FindGranules = std::function<std::vector<GranuleEntry>(
    const std::vector<std::string>& standard_names, const CutOut& window)>;

/// The data around a site over a window of time, by quantity: what a forecast is made from
/// (`site_data_of`). The one way from granules to pieces, whoever keeps the granules.
///
/// Granules are cut to the cells around the site's columns; U and V of one product in two files are
/// paired by their times and grid, with the last V found that fits; current series of one mooring
/// come as one piece (fields/record/mooring.h). Temperatures are read where no mixed-layer depth is
/// there. An Error names the quantity and the product.
[[nodiscard]] SitePieces pieces_of(const Site& site, UtcTime from, UtcTime to,
                                   const FindGranules& find);
/// The same of a window that is no site's.
[[nodiscard]] SitePieces pieces_of(const CutOut& window, const FindGranules& find);

/// Pieces of scalar quantities, by their CF names, whatever these are: as many lists as names. Each
/// granule is opened once for all of them.
[[nodiscard]] std::vector<std::vector<ScalarPiece>> scalar_pieces_of(
    const CutOut& window, const std::vector<std::string>& standard_names, const FindGranules& find);

/// What is read for places in a box: its cells and those around it.
/// @param box  its longitudes in any turn; west > east across the antimeridian
[[nodiscard]] CutOut cut_around(const BoundingBox& box, UtcTime from, UtcTime to);
/// How many cells, of all levels, are read for one time of a grid.
[[nodiscard]] std::size_t cells_read(const Grid& grid, const CutOut& window);

}  // namespace slackwater::ingest
