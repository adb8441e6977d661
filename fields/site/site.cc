#include "fields/site/site.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "fields/base/advice.h"
#include "fields/base/config.h"
#include "fields/base/error.h"
#include "fields/base/given_file.h"
#include "fields/base/text.h"

namespace slackwater {
namespace {

std::optional<TimeZone> read_time_zone(const Config& config) {
  const auto name = config.optional_text("timezone");
  if (!name) return std::nullopt;
  try {
    return TimeZone::named(*name);
  } catch (const Error& problem) {
    config.refuse("timezone", problem.message());
  }
}

ColumnBlock read_block(const Config& config) {
  const std::vector<double> box = config.numbers("bbox", {-180, 360});
  if (box.size() != 4) config.refuse("bbox", "expected four numbers: [west, south, east, north]");
  ColumnBlock block;
  try {
    block.box = BoundingBox::from_degrees(box[0], box[1], box[2], box[3]);
  } catch (const Error& problem) {
    config.refuse("bbox", problem.message());
  }
  block.every = config.optional_integer("every", 1, 1000).value_or(1);
  return block;
}

/// One number for all winds, or a list of sectors.
std::optional<Fetch> read_fetch(const Config& config) {
  constexpr Range fetch_range_km{0.1, 5000};
  if (!config.is_list("fetch_km")) {
    const auto fetch_km = config.optional_number("fetch_km", fetch_range_km);
    return fetch_km ? std::optional(Fetch(*fetch_km * 1000)) : std::nullopt;
  }
  std::vector<FetchSector> sectors;
  for (const Config& entry : config.children("fetch_km")) {
    const std::vector<double> from = entry.numbers("wind_from_deg", {0, 360});
    if (from.size() != 2) {
      entry.refuse("wind_from_deg",
                   "expected two directions that the wind comes from, clockwise: "
                   "[200, 320]");
    }
    sectors.push_back({from[0], from[1], 1000 * entry.number("fetch_km", fetch_range_km)});
  }
  try {
    return Fetch(std::move(sectors));
  } catch (const Error& problem) {
    config.refuse("fetch_km", problem.message());
  }
}

/// `access: {vessel: crew_transfer_vessel, passage: 75min}`
std::optional<SiteAccess> read_access(const Config& config) {
  const auto access = config.optional_child("access");
  if (!access) return std::nullopt;
  SiteAccess found{access->text("vessel"), {}};
  try {
    found.passage = parse_duration(access->text("passage"));
  } catch (const Error& problem) {
    access->refuse("passage", problem.message());
  }
  if (found.passage < Duration::zero() || found.passage > std::chrono::hours(24))
    access->refuse("passage", "expected 0min to 24h, from port to the farm");
  return found;
}

/// No charted place has a mean level more than 15 m above the lowest tide (Bay of Fundy: some 8 m).
constexpr Range chart_datum_range_m{0, 15};

/// `chart_datum: {name: LAT, below_mean_sea_level_m: 1.93, source: chart 2182B}`
std::optional<ChartDatum> read_chart_datum(const Config& config) {
  const auto stated = config.optional_child("chart_datum");
  if (!stated) return std::nullopt;
  ChartDatum datum{stated->text("name"),
                   stated->number("below_mean_sea_level_m", chart_datum_range_m),
                   stated->text("source")};
  if (datum.name.empty() || datum.name.size() > 60)
    stated->refuse("name", "expected what charts call it, at most 60 letters: LAT");
  if (datum.source.empty())
    stated->refuse("source", "expected the chart or tide table that says how far below it is");
  return datum;
}

bool looks_like_path(const std::string& text) {
  return text.find('/') != std::string::npos || text.ends_with(".yaml") || text.ends_with(".yml");
}

}  // namespace

BoundingBox Site::box(double margin_deg) const {
  if (column_block) {
    const BoundingBox& b = column_block->box;
    return BoundingBox::from_degrees(
        b.west_deg - margin_deg, std::max(-90.0, b.south_deg - margin_deg),
        (b.west_deg > b.east_deg ? b.east_deg + 360 : b.east_deg) + margin_deg,
        std::min(90.0, b.north_deg + margin_deg));
  }
  double south = point.latitude_deg();
  double north = south;
  double west = point.longitude_deg();
  double east = west;
  for (const GeoPoint& column : columns) {
    south = std::min(south, column.latitude_deg());
    north = std::max(north, column.latitude_deg());
    // Longitudes next to the site's own, so that a farm across the antimeridian stays small.
    const double longitude =
        column.longitude_deg() +
        360.0 * std::round((point.longitude_deg() - column.longitude_deg()) / 360.0);
    west = std::min(west, longitude);
    east = std::max(east, longitude);
  }
  return BoundingBox::from_degrees(west - margin_deg, std::max(-90.0, south - margin_deg),
                                   east + margin_deg, std::min(90.0, north + margin_deg));
}

bool is_site_id(std::string_view id) {
  return !id.empty() && id.size() <= 64 &&
         std::all_of(id.begin(), id.end(),
                     [](unsigned char c) {
                       return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
                     }) &&
         id != "." && id != "..";
}

Site parse_site(std::string_view yaml, std::string_view name) {
  const Config config = Config::parse(yaml, name);
  Site site;
  site.yaml = yaml;
  site.id = config.text("id");
  if (!is_site_id(site.id))
    config.refuse("id", "expected at most 64 letters, digits, '-', '_' or '.'");
  site.name = config.optional_text("name").value_or(site.id);
  site.point = read_point(config);
  site.water_depth_m = config.optional_number("water_depth_m", {1, 11000});
  site.chart_datum = read_chart_datum(config);
  site.hub_height_m = config.optional_number("hub_height_m", {10, 400});
  site.fetch = read_fetch(config);
  site.current_product = config.optional_text("currents");
  site.time_zone = read_time_zone(config);
  site.tasks = config.texts("tasks");
  site.shift = config.optional_text("shift").value_or("");
  site.access = read_access(config);
  site.turbines = read_turbines(config);
  site.cables = read_cables(config, site.turbines);
  site.areas = read_areas(config);
  if (config.is_mapping("columns")) {
    site.column_block = read_block(config.child("columns"));
  } else {
    for (const Config& entry : config.children("columns"))
      site.columns.push_back(read_point(entry));
  }
  config.expect_all_read();
  return site;
}

std::vector<std::string> known_sites(const std::vector<std::filesystem::path>& folders) {
  std::vector<std::string> ids;
  for (const auto& folder : folders) {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
      if (entry.path().extension() == ".yaml") ids.push_back(entry.path().stem().string());
    }
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

SiteText find_site_text(const std::string& id_or_path,
                        const std::vector<std::filesystem::path>& folders) {
  if (looks_like_path(id_or_path))
    return {text_of_given_file(id_or_path, "a site's YAML file"), id_or_path};
  for (const auto& folder : folders) {
    const auto file = folder / (id_or_path + ".yaml");
    if (std::filesystem::exists(file))
      return {text_of_given_file(file, "a site's YAML file"), file.string()};
  }
  const std::vector<std::string> known = known_sites(folders);
  const std::string list = known.empty() ? "none" : joined(known, " ");
  throw Error(ErrorKind::not_found,
              "found no site '" + id_or_path + "'" + did_you_mean(id_or_path, known) +
                  "; known sites are: " + list + "; or give the path of a site's YAML file");
}

Site find_site(const std::string& id_or_path, const std::vector<std::filesystem::path>& folders) {
  const SiteText text = find_site_text(id_or_path, folders);
  return parse_site(text.yaml, text.file);
}

}  // namespace slackwater
