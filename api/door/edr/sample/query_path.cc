#include <algorithm>
#include <cmath>
#include <limits>

#include "api/door/edr/read/bad_parameter.h"
#include "api/door/edr/read/distance.h"
#include "api/door/edr/read/resolution.h"
#include "api/door/edr/read/wkt.h"
#include "api/door/edr/sample/queries.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/geo/geo_point.h"

// Trajectory and corridor: samples along lines.

namespace slackwater::api::edr {
namespace {

/// Lines in time: as their M says, else the whole line at each time of `datetime`.
std::vector<Path> at_times(const Path& line, bool has_time, const std::vector<UtcTime>& times) {
  if (has_time) return {line};
  std::vector<Path> paths;
  for (const UtcTime time : times) {
    paths.push_back(line);
    for (Vertex& vertex : paths.back()) vertex.time = time;
  }
  return paths;
}

std::vector<Path> at_levels(const Path& line, const std::vector<double>& levels) {
  std::vector<Path> paths;
  for (const double level : levels) {
    paths.push_back(line);
    for (Vertex& vertex : paths.back()) vertex.vertical = std::isnan(level) ? 0.0 : level;
  }
  return paths;
}

Geometry lines_of(const QueryString& query) {
  return parse_wkt("coords", query.find("coords").value_or(""),
                   {GeometryType::line_string, GeometryType::multi_line_string});
}

/// What M and `datetime` say together: a line that has its own times takes no others.
std::vector<UtcTime> times_beside(const Selection& s, const Geometry& lines,
                                  const QueryString& query) {
  if (!lines.has_time) return times_of(s, query);
  if (query.find("datetime")) {
    throw Error(ErrorKind::usage,
                "found datetime beside a line whose vertices have their own times (M); leave one "
                "of the two out");
  }
  const ValidRange& range = s.field->range();
  for (const Part& part : lines.parts) {
    for (const Vertex& vertex : part.front()) {
      if (vertex.time >= range.from && vertex.time <= range.to) return {vertex.time};
    }
  }
  throw Error(ErrorKind::not_found,
              "coords: found no vertex (M, seconds since 1970) within the "
              "forecast; it holds " +
                  format_utc(range.from) + "/" + format_utc(range.to));
}

void expect_reached(const Selection& s, const Geometry& lines) {
  for (const Part& part : lines.parts) {
    for (const Vertex& vertex : part.front()) {
      const Place place{vertex.longitude_deg, vertex.latitude_deg, 0, {}};
      BedSample bed;
      s.field->sample_bed({&place, 1}, {&bed, 1});
      if (bed.status != SampleStatus::outside_area) return;
    }
  }
  throw Error(
      ErrorKind::not_found,
      "coords: found a line that the forecast does not reach; valid: " + s.field->range().text());
}

Answer along_all(Selection s, const std::vector<Path>& paths) {
  Absences absences{};
  std::vector<Coverage> coverages;
  for (std::size_t i = 0; i < paths.size(); ++i)
    coverages.push_back(along(s, paths[i], "path-" + std::to_string(i + 1), absences));
  return answer_of(std::move(s), std::move(coverages), absences);
}

/// Points of a line at even distances along it, ends included; the vertices
/// themselves where `count` is 0.
Path resampled(const Path& line, std::size_t count) {
  if (count == 0) return line;
  std::vector<double> at{0};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double north = line[i].latitude_deg - line[i - 1].latitude_deg;
    const double east = (line[i].longitude_deg - line[i - 1].longitude_deg) *
                        std::cos(constants::degree * line[i].latitude_deg);
    at.push_back(at.back() + std::hypot(north, east));
  }
  Path out;
  std::size_t i = 1;
  for (std::size_t n = 0; n < count; ++n) {
    const double here = count == 1
                            ? 0.5 * at.back()
                            : at.back() * static_cast<double>(n) / static_cast<double>(count - 1);
    while (i + 1 < line.size() && at[i] < here) ++i;
    const double step = at[i] - at[i - 1];
    const double share = step > 0 ? std::clamp((here - at[i - 1]) / step, 0.0, 1.0) : 0.0;
    const Vertex& a = line[i - 1];
    const Vertex& b = line[i];
    Vertex v;
    v.longitude_deg = a.longitude_deg + share * (b.longitude_deg - a.longitude_deg);
    v.latitude_deg = a.latitude_deg + share * (b.latitude_deg - a.latitude_deg);
    v.vertical = a.vertical + share * (b.vertical - a.vertical);
    v.time = a.time + Duration(static_cast<Duration::rep>(
                          share * static_cast<double>((b.time - a.time).count())));
    out.push_back(v);
  }
  return out;
}

/// The line moved sideways, to the right of its course where `offset_m` is positive.
Path beside(const Path& line, double offset_m) {
  Path out = line;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vertex& before = line[i > 0 ? i - 1 : 0];
    const Vertex& after = line[std::min(i + 1, line.size() - 1)];
    const double cosine = std::max(0.01, std::cos(constants::degree * line[i].latitude_deg));
    const double east = (after.longitude_deg - before.longitude_deg) * cosine;
    const double north = after.latitude_deg - before.latitude_deg;
    const double length = std::hypot(east, north);
    if (!(length > 0)) continue;
    const double degrees = offset_m / (constants::earth_radius_m * constants::degree);
    out[i].longitude_deg += degrees * north / length / cosine;
    out[i].latitude_deg = std::clamp(out[i].latitude_deg - degrees * east / length, -90.0, 90.0);
  }
  return out;
}

/// `count` offsets from -half to half; the middle alone for one.
std::vector<double> offsets(double whole, std::size_t count) {
  std::vector<double> out;
  for (std::size_t i = 0; i < count; ++i)
    out.push_back(
        count == 1 ? 0.0 : whole * (static_cast<double>(i) / static_cast<double>(count - 1) - 0.5));
  return out;
}

double length_m(const Path& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    length +=
        distance_m(GeoPoint::from_degrees(line[i - 1].latitude_deg, line[i - 1].longitude_deg),
                   GeoPoint::from_degrees(line[i].latitude_deg, line[i].longitude_deg));
  return length;
}

/// How many positions span a length at the spacing of the forecast's columns, ends included; as few
/// as `least` where it has but one column.
std::size_t stored_count(const Selection& s, double length, std::size_t least) {
  const auto& columns = s.field->snapshot().columns;
  double spacing_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < columns.size(); ++i)
    spacing_m = std::min(spacing_m, distance_m(columns.front().point, columns[i].point));
  if (!(spacing_m > 0) || !std::isfinite(spacing_m)) return least;
  const double steps = std::min(std::ceil(length / spacing_m), static_cast<double>(max_resolution));
  return std::max(least, static_cast<std::size_t>(steps) + 1);
}

/// A resolution-x, -y or -z: nothing where it is absent, 0 for "as stored".
std::optional<std::size_t> asked_count(const QueryString& query, std::string_view key) {
  const auto text = query.find(key);
  if (!text) return std::nullopt;
  return parse_resolution(key, *text).value_or(0);
}

/// Levels of the corridor about `middle`: its stored levels between the two ends, and the ends.
std::vector<double> stored_levels(const Selection& s, double middle, double height_m) {
  std::vector<double> levels{middle - 0.5 * height_m};
  for (const double level : all_levels(*s.collection, *s.field))
    if (std::abs(level - middle) < 0.5 * height_m) levels.push_back(level);
  levels.push_back(middle + 0.5 * height_m);
  return levels;
}

/// Where a corridor is sampled across its width and, about a level, over its height.
struct Section {
  std::vector<double> across_m;
  double height_m = 0;
  std::size_t upward = 1;  ///< positions over the height; 0: as stored

  [[nodiscard]] std::vector<double> levels(const Selection& s, double middle) const {
    if (s.collection->vertical == Vertical::none) return {middle};
    if (upward == 0) return stored_levels(s, middle, height_m);
    std::vector<double> all = offsets(height_m, upward);
    for (double& level : all) level += middle;
    return all;
  }
};

constexpr std::size_t usual_count = 3;  ///< both borders and the middle

Section section_of(const Selection& s, const QueryString& query) {
  const double width_m =
      parse_distance_m("corridor-width", query.find("corridor-width").value_or(""), "width-units",
                       query.find("width-units").value_or(""));
  Section section;
  // EDR 1.0 knew corridors without a height, and its clients send none: such a one is
  // of its path's own level.
  const auto height = query.find("corridor-height");
  const auto height_units = query.find("height-units");
  const bool is_flat = !height && !height_units;
  if (!is_flat) {
    section.height_m = parse_distance_m("corridor-height", height.value_or(""), "height-units",
                                        height_units.value_or(""));
  }
  std::size_t across = asked_count(query, "resolution-x").value_or(usual_count);
  if (across == 0) across = stored_count(s, width_m, 2);
  section.across_m = offsets(width_m, across);
  if (!is_flat) section.upward = asked_count(query, "resolution-z").value_or(usual_count);
  return section;
}

/// The line of a corridor at the positions of resolution-y; its vertices where that is absent.
Path along_line(const Selection& s, const QueryString& query, const Path& line) {
  const auto count = asked_count(query, "resolution-y");
  if (!count) return line;
  return resampled(line, *count > 0 ? *count : stored_count(s, length_m(line), line.size()));
}

/// A corridor's lines at one level of its middle, or at the vertices' own
/// (`level` is added to them).
void add_lines(std::vector<Path>& paths, const Path& line, const std::vector<double>& levels,
               bool is_relative) {
  for (const double level : levels) {
    paths.push_back(line);
    for (Vertex& vertex : paths.back())
      vertex.vertical = is_relative ? vertex.vertical + level : level;
  }
}

/// The lines of a trajectory query at each of its times, and at each of its levels where the
/// vertices have none of their own.
std::vector<Path> trajectories(const Geometry& lines, const std::vector<UtcTime>& times,
                               const std::vector<double>& levels) {
  std::vector<Path> paths;
  for (const Part& part : lines.parts) {
    for (const Path& timed : at_times(part.front(), lines.has_time, times)) {
      if (lines.has_vertical) {
        paths.push_back(timed);
        continue;
      }
      for (Path& path : at_levels(timed, levels)) paths.push_back(std::move(path));
    }
  }
  return paths;
}

}  // namespace

QueryPoints trajectory_plan(Selection s, const QueryString& query) {
  Geometry lines = lines_of(query);
  if (lines.has_vertical && query.find("z")) {
    throw Error(
        ErrorKind::usage,
        "found z beside a line whose vertices have their own (Z); leave one of the two out");
  }
  expect_reached(s, lines);
  std::vector<UtcTime> times = times_beside(s, lines, query);
  std::vector<double> levels = lines.has_vertical
                                   ? std::vector<double>{}
                                   : verticals_of(s, query, s.field->range().deepest_m);
  std::size_t vertices = 0;
  for (const Part& part : lines.parts) vertices += part.front().size();
  const std::size_t lines_each =
      std::max<std::size_t>(1, levels.size()) * (lines.has_time ? 1 : times.size());
  const Work work = moderate_work(s, vertices * lines_each, lines.parts.size() * lines_each);
  return {work, [s = std::move(s), lines = std::move(lines), times = std::move(times),
                 levels = std::move(levels)]() mutable {
            return along_all(std::move(s), trajectories(lines, times, levels));
          }};
}

QueryPoints corridor_plan(Selection s, const QueryString& query) {
  const Geometry lines = lines_of(query);
  Section section = section_of(s, query);
  expect_reached(s, lines);
  std::vector<UtcTime> times = times_beside(s, lines, query);
  // Without a vertical of its own the corridor runs about the levels of z, else about
  // the middle of the range.
  std::vector<double> about{0};
  const bool is_relative = lines.has_vertical && s.collection->vertical != Vertical::none;
  if (s.collection->vertical != Vertical::none && !lines.has_vertical) {
    const auto [low, high] = vertical_range(*s.collection, *s.field);
    about = query.find("z")
                ? verticals_of(s, query, s.field->range().deepest_m)
                : std::vector{std::min(low + 0.5 * section.height_m, 0.5 * (low + high))};
  }
  std::vector<double> levels;
  for (const double middle : about)
    for (const double level : section.levels(s, middle)) levels.push_back(level);
  std::vector<Path> middle_lines;
  std::size_t vertices = 0;
  for (const Part& part : lines.parts) {
    middle_lines.push_back(along_line(s, query, part.front()));
    vertices += middle_lines.back().size();
  }
  const std::size_t lines_each =
      section.across_m.size() * levels.size() * (lines.has_time ? 1 : times.size());
  const Work work = moderate_work(s, vertices * lines_each, middle_lines.size() * lines_each);
  return {work, [s = std::move(s), middle_lines = std::move(middle_lines),
                 across_m = std::move(section.across_m), times = std::move(times),
                 levels = std::move(levels), has_time = lines.has_time, is_relative]() mutable {
            std::vector<Path> paths;
            for (const Path& line : middle_lines) {
              for (const double sideways : across_m) {
                for (const Path& timed : at_times(beside(line, sideways), has_time, times))
                  add_lines(paths, timed, levels, is_relative);
              }
            }
            return along_all(std::move(s), paths);
          }};
}

}  // namespace slackwater::api::edr
