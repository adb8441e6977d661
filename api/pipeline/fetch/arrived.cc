#include "api/pipeline/fetch/arrived.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <set>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/apart/decode_apart.h"

namespace slackwater::api {
namespace {

/// The longest way from one of its times to the next.
Duration step_of(const std::vector<TimeCell>& times) {
  Duration longest = std::chrono::hours(1);
  for (std::size_t i = 1; i < times.size(); ++i)
    longest = std::max(longest, times[i].start - times[i - 1].start);
  return longest;
}

/// An answer for people in the place of data.
bool is_a_page(const std::filesystem::path& file) {
  std::array<char, 512> head{};
  std::ifstream(file, std::ios::binary).read(head.data(), head.size() - 1);
  std::string text(head.data());
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string::npos &&
         (text.compare(first, 9, "<!doctype") == 0 || text.compare(first, 5, "<html") == 0 ||
          text.compare(first, 5, "<?xml") == 0 || text[first] == '{');
}

/// What each kind must hold, one of them; by CF standard names.
std::vector<std::string> names_of(const std::string& kind) {
  if (kind == "currents")
    return {"eastward_sea_water_velocity", "sea_water_x_velocity", "sea_water_speed"};
  if (kind == "level")
    return {"sea_surface_height_above_geoid", "sea_surface_height_above_sea_level"};
  if (kind == "waves") return {"sea_surface_wave_significant_height"};
  if (kind == "bathymetry")
    return {"sea_floor_depth_below_geoid", "sea_floor_depth_below_sea_level"};
  return {"eastward_wind", "x_wind", "wind_speed"};
}

/// Whether a site lies among its cells, or beside them by one.
bool is_about(const Grid& grid, const GeoPoint& point) {
  const auto within = [](const std::vector<double>& axis, double at, double turn) {
    if (axis.empty()) return false;
    const double step = axis.size() > 1 ? axis[1] - axis[0] : 0.5;
    for (const double shifted : {at - turn, at, at + turn})
      if (shifted >= axis.front() - step && shifted <= axis.back() + step) return true;
    return false;
  };
  return within(grid.latitude_deg, point.latitude_deg(), 0) &&
         within(grid.longitude_deg, point.longitude_deg(), 360);
}

Arrived judged(const ingest::Ingested& ingested, const WantedFile& wanted, const Site& site) {
  const std::vector<std::string> names = names_of(wanted.kind);
  std::set<std::string> found;
  std::optional<UtcTime> from, until;
  Duration step = std::chrono::hours(1);
  bool has_kind = false, is_here = false;
  for (const ingest::DecodedGranule& decoded : ingested.granules) {
    const Granule& granule = decoded.granule;
    bool is_of_kind = false;
    for (const GranuleVariable& variable : granule.variables) {
      found.insert(variable.standard_name);
      is_of_kind = is_of_kind ||
                   std::find(names.begin(), names.end(), variable.standard_name) != names.end();
    }
    if (!is_of_kind) continue;
    has_kind = true;
    is_here = is_here || is_about(granule.grid, site.point);
    if (granule.grid.time.empty()) continue;
    step = std::max(step, step_of(granule.grid.time));
    from =
        std::min(from.value_or(granule.grid.time.front().start), granule.grid.time.front().start);
    until = std::max(until.value_or(granule.grid.time.back().end), granule.grid.time.back().end);
  }
  Arrived arrived;
  arrived.until = until;
  if (!has_kind) {
    arrived.fault = formatted("found {}, expected {}", joined(found, ", "), joined(names, " or "));
    return arrived;
  }
  if (!is_here) {
    arrived.fault = "found no cell about the site: it is of another place";
    return arrived;
  }
  if (!wanted.from || !wanted.to || !from || !until) return arrived;
  if (*until <= *wanted.from || *from >= *wanted.to) {
    arrived.fault = "found times from " + format_utc(*from) + " to " + format_utc(*until) +
                    ", expected some from " + format_utc(*wanted.from) + " to " +
                    format_utc(*wanted.to) + ": it is of another day";
    return arrived;
  }
  if (*from > *wanted.from + step) arrived.begins = "begins at " + format_utc(*from);
  if (*until + step < *wanted.to) arrived.lacks = "ends at " + format_utc(*until);
  return arrived;
}

}  // namespace

Arrived look_into(const std::filesystem::path& file, const WantedFile& wanted,
                  const ingest::ProductCatalogue& products, const Site& site,
                  const std::filesystem::path& scratch) {
  std::error_code problem;
  if (!std::filesystem::is_regular_file(file, problem)) return {"found no file", "", "", {}};
  if (std::filesystem::file_size(file, problem) == 0) return {"found an empty file", "", "", {}};
  if (is_a_page(file))
    return {
        "found a page of text in the place of data: the service answered otherwise", "", "", {}};
  std::filesystem::remove_all(scratch, problem);
  std::filesystem::create_directories(scratch, problem);
  Arrived arrived;
  try {
    arrived = judged(ingest::decode_apart(file, products, {}, scratch, {}, {}), wanted, site);
  } catch (const Error& problem_of_file) {
    if (problem_of_file.kind() == ErrorKind::unavailable) throw;
    arrived.fault = problem_of_file.message();
  }
  std::filesystem::remove_all(scratch, problem);
  return arrived;
}

}  // namespace slackwater::api
