#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/config.h"
#include "fields/base/time.h"
#include "fields/geo/geo_point.h"
#include "ingest/copernicus/water.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {

/// One way to recognise a product: all conditions of a rule hold, or the rule does not match. Where
/// the product has an attribution, its rules must prove who made the file: who is credited is what
/// the file says, never what its layout or the tool that wrote it resembles.
struct MatchRule {
  std::string attribute;                    ///< global attribute; empty: no such condition
  std::string contains;                     ///< its text holds this, letter case ignored
  std::map<std::string, std::string> also;  ///< other global attributes, and what each must hold
  std::vector<std::string> variables;       ///< the file has all of these
};

/// Attributes that a product's files forget. They fill gaps; a file that says otherwise is refused
/// (ingest/cf/settle.h).
struct SettledAttributes {
  std::string variable;
  std::optional<std::string> units;
  std::optional<std::string> standard_name;
  std::optional<std::string> positive;
};

/// Where in its interval a mean is stamped.
enum class MeanLabel {
  centre,
  start,
  end,
  utc_day,    ///< anywhere in the UTC day it covers: 00:00 and 12:00 are both met
  utc_step,   ///< at the start or in the middle of its step, steps counted from 00:00 UTC
  utc_month,  ///< anywhere in the calendar month it covers
};

/// "Files whose global attribute says this hold means over `step`", or, of a product that has no
/// instants so far apart: "files whose stamps are `spacing` apart do".
struct MeanRule {
  std::string attribute;  ///< empty: the spacing decides
  std::string contains;
  Duration step{};  ///< of a month: nothing
  MeanLabel label = MeanLabel::centre;
  Duration spacing{};                  ///< between stamps, where there is no attribute
  std::vector<std::string> variables;  ///< of these short names alone; empty: of all
};

/// Between the stamps of two months.
inline constexpr Duration shortest_month = std::chrono::hours(28 * 24);
inline constexpr Duration longest_month = std::chrono::hours(31 * 24);

/// What a dataset is downloaded for.
enum class DownloadKind { current, wave, wind, bathymetry, level };

/// One dataset that `forecast --print-downloads` may ask for.
struct Download {
  std::string product_id;
  std::string dataset_id;
  DownloadKind kind = DownloadKind::current;
  std::vector<std::string> variables;
  BoundingBox domain;               ///< the dataset's, inside which a site must lie
  std::vector<Water> water;         ///< and in one of these; empty: the domain has no other sea
  bool has_depth = false;           ///< take -z/-Z
  bool has_tide = false;            ///< the current contains the tide
  int priority = 100;               ///< smaller first
  double horizon_h = 0;             ///< how far it forecasts past the day of issue; 0: past only
  std::optional<std::string> part;  ///< --dataset-part, e.g. bathy
  std::optional<UtcDay> since;      ///< days before are of another model, or no longer kept

  /// Whether it has water about a place of the sea, as far as the descriptor knows.
  [[nodiscard]] bool covers(const GeoPoint& place) const;
};

/// The descriptor of one product or family: data, not code.
struct Product {
  std::string id;
  std::string title;
  std::string doi;
  std::string attribution;       ///< empty: as the file says (ingest/cf/attribution.h)
  int match_order = 50;          ///< descriptors are tried in this order
  std::vector<MatchRule> match;  ///< any of these
  std::vector<SettledAttributes> settles;
  std::vector<MeanRule> means;
  std::vector<std::string> reference_time;   ///< global attributes to believe
  std::vector<std::string> contains_stokes;  ///< variables that hold Stokes drift
  bool is_regional = false;                  ///< made for a region, not for the whole globe
  /// How long after its reference time a run of the forecast is published; 0: nobody says.
  Duration published_after{0};
  /// Whether its currents and its level contain the tide; nothing where nobody says.
  std::optional<bool> has_tide;
  std::vector<std::string> tide_in;  ///< where only some of them do: these variables
  std::map<std::string, std::string>
      variables;                          ///< short name -> standard name, beyond the vocabulary
  std::optional<double> current_depth_m;  ///< of currents that come without a depth axis
  std::vector<Download> downloads;
  std::string sha256;  ///< of the descriptor's file

  [[nodiscard]] static Product load(const std::filesystem::path& file);
  /// Whether a current, or a level, of this short name contains the tide.
  [[nodiscard]] std::optional<bool> tide_of(const std::string& variable) const;
  [[nodiscard]] bool matches(const netcdf::File& file) const;
  /// The attribute as the file has it, else as the product settles it.
  [[nodiscard]] std::optional<std::string> attribute(const netcdf::Variable& variable,
                                                     std::string_view name) const;
};

}  // namespace slackwater::ingest
