#include "api/door/cli/point_list.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string_view>

#include "fields/base/encode/csv.h"
#include "fields/base/error.h"
#include "fields/base/given_file.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

constexpr std::string_view blank_or_quote = " \t\r\"";
constexpr std::size_t most_depths = 10'000;

std::vector<std::string_view> cells_of(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  for (;;) {
    const std::size_t end = line.find(separator);
    cells.push_back(trimmed(line.substr(0, end), blank_or_quote));
    if (end == std::string_view::npos) return cells;
    line.remove_prefix(end + 1);
  }
}

/// A finite number that is the whole text.
std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data(), end, value);
  if (problem != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// What the text was, cut where it is long.
std::string shown(std::string_view text) {
  constexpr std::size_t enough = 60;
  return "'" + std::string(text.substr(0, enough)) + (text.size() > enough ? "…'" : "'");
}

std::vector<std::string> cells_in(std::string_view line) {
  std::optional<std::vector<std::string>> cells = csv_cells(line);
  if (cells) return std::move(*cells);
  throw Error(ErrorKind::invalid_input,
              "found a quote that is not closed in " + shown(line) + "; expected \" in pairs");
}

/// The column under the first of the names that the head has.
std::optional<std::size_t> find_column(const std::vector<std::string>& head,
                                       const std::vector<std::string_view>& names) {
  for (const std::string_view name : names) {
    const auto found = std::find(head.begin(), head.end(), name);
    if (found != head.end()) return static_cast<std::size_t>(found - head.begin());
  }
  return std::nullopt;
}

std::size_t column_of(const std::vector<std::string>& head,
                      const std::vector<std::string_view>& names) {
  if (const auto found = find_column(head, names)) return *found;
  throw Error(ErrorKind::invalid_input,
              "line 1: found no column " + std::string(names.front()) +
                  "; expected the columns' names, e.g. latitude_deg,longitude_deg");
}

double cell_number(const std::vector<std::string>& cells, std::size_t column,
                   std::string_view what) {
  if (column >= cells.size()) {
    throw Error(ErrorKind::invalid_input, "found " + std::to_string(cells.size()) +
                                              " values, expected a " + std::string(what) +
                                              " in column " + std::to_string(column + 1));
  }
  const std::optional<double> value = number_in(cells[column]);
  if (value) return *value;
  throw Error(ErrorKind::invalid_input, "found " + shown(cells[column]) + ", expected a " +
                                            std::string(what) + " in degrees");
}

PointList points_in(std::istream& in) {
  std::string line;
  std::getline(in, line);
  std::string_view first = line;
  if (first.starts_with("\xEF\xBB\xBF")) first.remove_prefix(3);  // what spreadsheets put there
  const std::vector<std::string> head = with_context("line 1", [&] { return cells_in(first); });
  const std::size_t latitude = column_of(head, {"latitude_deg", "latitude", "lat"});
  const std::size_t longitude = column_of(head, {"longitude_deg", "longitude", "lon"});
  const auto named = find_column(head, {"name", "id", "station", "label"});
  PointList list;
  for (std::size_t number = 2; std::getline(in, line); ++number) {
    if (trimmed(line, blank_or_quote).empty()) continue;
    with_context("line " + std::to_string(number), [&] {
      const std::vector<std::string> cells = cells_in(line);
      const double north = cell_number(cells, latitude, "latitude");
      const double east = cell_number(cells, longitude, "longitude");
      if (std::abs(east) > 360) {
        throw Error(ErrorKind::invalid_input,
                    "found longitude " + shown(cells[longitude]) + ", expected -360 to 360");
      }
      if (list.points.size() == most_points) {
        throw Error(ErrorKind::invalid_input, "found more than " + std::to_string(most_points) +
                                                  " points; give them in several files");
      }
      list.points.push_back(GeoPoint::from_degrees(north, east));
      if (named) list.names.push_back(*named < cells.size() ? cells[*named] : std::string());
    });
  }
  if (list.points.empty()) {
    throw Error(ErrorKind::invalid_input, "found no points below the line of names");
  }
  return list;
}

std::vector<double> evenly(const std::vector<std::string_view>& parts) {
  const std::optional<double> from = number_in(parts[0]);
  const std::optional<double> to = number_in(parts[1]);
  const std::optional<double> count = number_in(parts[2]);
  if (!from || !to || !count || *count < 2 || *count > static_cast<double>(most_depths) ||
      *count != std::floor(*count)) {
    return {};
  }
  std::vector<double> depths;
  const auto steps = static_cast<std::size_t>(*count) - 1;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(steps);
    depths.push_back(i == steps ? *to : *from + share * (*to - *from));
  }
  return depths;
}

std::vector<double> listed(const std::vector<std::string_view>& parts) {
  std::vector<double> depths;
  if (parts.size() > most_depths) return depths;
  for (const std::string_view part : parts) {
    const std::optional<double> depth = number_in(part);
    if (!depth) return {};
    depths.push_back(*depth);
  }
  return depths;
}

}  // namespace

PointList read_points(const std::filesystem::path& file) {
  return with_context(file.string(), [&] {
    expect_given_file(file, "a file of points");
    std::ifstream in(file);
    return points_in(in);
  });
}

std::vector<double> parse_depths(const std::string& text) {
  const std::vector<std::string_view> by_slash = cells_of(text, '/');
  std::vector<double> depths =
      by_slash.size() == 3 ? evenly(by_slash) : listed(cells_of(text, ','));
  const bool ascend = std::adjacent_find(depths.begin(), depths.end(), [](double a, double b) {
                        return !(a < b);
                      }) == depths.end();
  if (depths.empty() || !ascend || depths.front() < 0) {
    throw Error(
        ErrorKind::invalid_input,
        "found " + shown(text) +
            ", expected metres below mean sea level in rising order, as a list (0,5,12.5) or as "
            "from/to/count (0/80/50)");
  }
  return depths;
}

}  // namespace slackwater::api
