#include "api/show/coverage/findings_file.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <variant>

#include "api/show/coverage/marks.h"
#include "api/show/coverage/view.h"
#include "fields/base/encode/csv.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "fields/geo/local_frame.h"

namespace slackwater::api {
namespace {

using ingest::TrajectoryFile;
using Property = std::pair<const char*, std::variant<std::string, double>>;

/// One finding: where, and what is said of it; NaN where there is nothing to say.
struct Row {
  GeoPoint place;
  std::vector<Property> properties;
};

/// To a tenth of a millimetre: no number is better than that, and short ones are read more easily.
double rounded(double value) {
  return std::isfinite(value) ? std::round(value * 1e4) / 1e4 : std::nan("");
}

std::vector<Property> truth_of(const Finding& f) {
  return {{"truth", std::string(words_of(f.outcome))},
          {"true_size_m", rounded(f.true_size_m)},
          {"size_error_m", rounded(f.size_m - f.true_size_m)},
          {"position_error_m", rounded((f.reported_m - f.true_m).norm())},
          {"true_severity", rounded(f.true_severity)}};
}

Row row_of(const InspectionCoverage& coverage, const CoverageMark& mark, const LocalFrame& frame,
           UtcTime epoch, bool shows_truth) {
  const Finding& f = *mark.finding;
  Row row;
  row.place = frame.to_geodetic(mark.place_m).point;
  const double bearing_deg =
      coverage.sheet.is_all_round ? coverage.sheet.bearing_deg(mark.along_m) : std::nan("");
  row.properties = {
      {"number", mark.label},
      {"kind", words_of(f.kind)},
      {"surface", coverage.surface},
      {"instrument", coverage.instrument},
      {"vehicle", coverage.vehicle},
      {"east_m", rounded(mark.place_m.x())},
      {"north_m", rounded(mark.place_m.y())},
      {"depth_m", rounded(-mark.place_m.z())},
      {"bearing_deg", std::isnan(bearing_deg) ? bearing_deg : std::round(bearing_deg * 10) / 10},
      {"along_m", rounded(mark.along_m)},
      {"down_m", rounded(mark.down_m)},
      {"size_m", rounded(f.size_m)},
      {"severity", rounded(f.severity)},
      {"severity_unit",
       std::string(twin::severity_unit_of(f.kind) == twin::SeverityUnit::share ? "1" : "m")},
      {"detail_m", rounded(f.detail_m)},
      {"time_utc", f.is_reported() ? format_utc(add_hours(epoch, f.t_s / 3600)) : std::string()}};
  if (shows_truth)
    for (Property& property : truth_of(f)) row.properties.push_back(std::move(property));
  return row;
}

std::vector<Row> rows_of(const TrajectoryFile& log, const FindingsChoice& choice) {
  const std::vector<InspectionCoverage> coverages = coverage_in(log);
  if (coverages.empty())
    throw Error(ErrorKind::invalid_input,
                "the run inspected nothing, so that there is no list of findings; expected a "
                "vehicle with an instrument and a surface to look at");
  const LocalFrame frame(origin_in(log));
  std::vector<Row> rows;
  std::size_t reported = 0, missed = 0;
  for (const InspectionCoverage& coverage : coverages)
    for (const CoverageMark& mark : marks_of(coverage, choice.shows_truth, reported, missed))
      rows.push_back(row_of(coverage, mark, frame, log.epoch, choice.shows_truth));
  return rows;
}

/// The names of all columns, of a log without findings too.
std::vector<std::string> columns_of(bool shows_truth) {
  InspectionCoverage coverage;
  coverage.sheet.width_m = 1;
  Finding finding;
  CoverageMark mark;
  mark.finding = &finding;
  const LocalFrame frame(GeoPoint{});
  std::vector<std::string> names;
  for (const Property& p : row_of(coverage, mark, frame, UtcTime{}, shows_truth).properties)
    names.emplace_back(p.first);
  return names;
}

/// To a centimetre on the ground.
double rounded_degrees(double degrees) { return std::round(degrees * 1e7) / 1e7; }

}  // namespace

GeoPoint origin_in(const TrajectoryFile& log) {
  const std::string text = log.attribute("origin");
  double north = 0, east = 0;
  int end = 0;
  if (std::sscanf(text.c_str(), "%lf N, %lf E%n", &north, &east, &end) != 2 ||
      static_cast<std::size_t>(end) != text.size())
    throw Error(ErrorKind::invalid_input, "the log's origin: found '" + text +
                                              "', expected degrees as in '48.85 N, -2.55 E'; run "
                                              "`slackwater simulate` again");
  return GeoPoint::from_degrees(north, east);
}

std::string findings_geojson(const TrajectoryFile& log, const FindingsChoice& choice) {
  using json = nlohmann::ordered_json;
  json features = json::array();
  for (const Row& row : rows_of(log, choice)) {
    json properties = json::object();
    for (const auto& [name, value] : row.properties) {
      if (const auto* number = std::get_if<double>(&value))
        properties[name] = std::isfinite(*number) ? json(*number) : json(nullptr);
      else if (const auto& text = std::get<std::string>(value); text.empty())
        properties[name] = nullptr;
      else
        properties[name] = text;
    }
    features.push_back(
        {{"type", "Feature"},
         {"geometry",
          {{"type", "Point"},
           {"coordinates", json::array({rounded_degrees(row.place.longitude_deg()),
                                        rounded_degrees(row.place.latitude_deg())})}}},
         {"properties", properties}});
  }
  const json all = {{"type", "FeatureCollection"}, {"features", features}};
  return all.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

std::string findings_csv(const TrajectoryFile& log, const FindingsChoice& choice) {
  const std::vector<Row> rows = rows_of(log, choice);
  std::string out = "latitude_deg,longitude_deg";
  for (const std::string& name : columns_of(choice.shows_truth)) out += "," + name;
  out += "\n";
  for (const Row& row : rows) {
    out += csv_cell(rounded_degrees(row.place.latitude_deg())) + "," +
           csv_cell(rounded_degrees(row.place.longitude_deg()));
    for (const auto& [name, value] : row.properties)
      out += "," + std::visit([](const auto& v) { return csv_cell(v); }, value);
    out += "\n";
  }
  return out;
}

}  // namespace slackwater::api
