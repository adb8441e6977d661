#include "api/log/traffic_tables.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/encode/sha256.h"
#include "fields/base/error.h"
#include "twin/body/frame.h"

namespace slackwater::api {
namespace {

using ingest::TrajectoryTable;
using twin::TrackPoint;
using twin::TrafficVessel;

constexpr double none = constants::nan;

TrajectoryTable vessel_table(std::span<const TrafficVessel> vessels) {
  TrajectoryTable table;
  table.name = "vessel";
  std::vector<double> mmsi, around, length, beam, reports;
  std::vector<std::string> names;
  for (const TrafficVessel& vessel : vessels) {
    mmsi.push_back(vessel.id);
    around.push_back(vessel.is_around ? 1 : 0);
    length.push_back(vessel.length_m.value_or(none));
    beam.push_back(vessel.beam_m.value_or(none));
    reports.push_back(static_cast<double>(vessel.track.points().size()));
    names.push_back(vessel.name);
  }
  table.columns = {
      {"mmsi", "1", "number of the vessel in AIS (MMSI)", mmsi},
      {"around", "1", "1: met by the vehicles, 0: only followed", around},
      {"length", "m", "length of the vessel", length},
      {"beam", "m", "beam of the vessel", beam},
      {"reports", "1", "how many rows of report are of it, one vessel after the other", reports}};
  table.texts = {{"name", "name of the vessel", names}};
  return table;
}

TrajectoryTable report_table(std::span<const TrafficVessel> vessels) {
  TrajectoryTable table;
  table.name = "report";
  std::vector<double> t, x, y, v_x, v_y, heading;
  for (const TrafficVessel& vessel : vessels) {
    for (const TrackPoint& point : vessel.track.points()) {
      t.push_back(point.t_s);
      const Horizontal at_m = twin::horizontal_of(point.position_m);
      const Horizontal v_m_s =
          point.velocity_m_s ? twin::horizontal_of(*point.velocity_m_s) : Horizontal(none, none);
      x.push_back(at_m.real());
      y.push_back(at_m.imag());
      v_x.push_back(v_m_s.real());
      v_y.push_back(v_m_s.imag());
      heading.push_back(point.heading_rad.value_or(none));
    }
  }
  table.columns = {{"time", "s", "since the start of the run", t},
                   {"x", "m", "east of the origin", x},
                   {"y", "m", "north of the origin", y},
                   {"velocity_x", "m s-1", "over ground, towards east", v_x},
                   {"velocity_y", "m s-1", "over ground, towards north", v_y},
                   {"heading", "rad", "of the bow, clockwise from north", heading}};
  return table;
}

TrajectoryTable alarm_table(std::span<const TrafficVessel> vessels,
                            std::span<const twin::AlarmRecord> alarms) {
  TrajectoryTable table;
  table.name = "alarm";
  std::vector<double> vehicle, mmsi, begin, end, why, cpa, tcpa, least, least_at;
  std::vector<std::string> names;
  for (const twin::AlarmRecord& alarm : alarms) {
    vehicle.push_back(static_cast<double>(alarm.vehicle));
    mmsi.push_back(alarm.mmsi);
    begin.push_back(alarm.begin_s);
    end.push_back(alarm.end_s);
    why.push_back(static_cast<double>(alarm.end));
    cpa.push_back(alarm.cpa_m);
    tcpa.push_back(alarm.tcpa_s);
    least.push_back(alarm.least_distance_m);
    least_at.push_back(alarm.least_distance_s);
    names.push_back(name_of_vessel(vessels, alarm.mmsi));
  }
  table.columns = {
      {"vehicle", "1", "index of the trajectory whose alarm it is", vehicle},
      {"mmsi", "1", "of the other vessel", mmsi},
      {"begin", "s", "raised, since the start of the run", begin},
      {"end", "s", "over, since the start of the run", end},
      {"end_reason", "1", "0 still on at the end of the run, 1 clear, 2 lost, 3 vehicle halted",
       why},
      {"cpa", "m", "distance at the closest approach as foreseen when raised", cpa},
      {"tcpa", "s", "time from begin to the closest approach as foreseen when raised", tcpa},
      {"least_distance", "m", "nearest that they were while the alarm was on", least},
      {"least_distance_time", "s", "when, since the start of the run", least_at}};
  table.texts = {{"name", "name of the other vessel", names}};
  return table;
}

std::optional<double> present(double value) {
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

const std::vector<double>& needed(const TrajectoryTable& table, const char* name) {
  const std::vector<double>* column = table.column(name);
  if (column == nullptr || column->size() != table.rows())
    throw Error(ErrorKind::invalid_input, "found no column " + std::string(name) +
                                              " in the table " + table.name +
                                              "; give a log that `slackwater simulate` wrote");
  return *column;
}

/// Whether a report can be one of a track.
bool is_sound(const TrackPoint& point, const std::vector<TrackPoint>& before) {
  const bool is_number = std::isfinite(point.t_s) && std::isfinite(point.position_m.x) &&
                         std::isfinite(point.position_m.y) &&
                         std::isfinite(point.heading_rad.value_or(0));
  const twin::Triple<double> v = point.velocity_m_s.value_or(twin::Triple<double>{});
  return is_number && std::isfinite(v.x) && std::isfinite(v.y) &&
         (before.empty() || point.t_s > before.back().t_s);
}

twin::Track track_of(const TrajectoryTable& reports, std::size_t first, std::size_t count) {
  const auto& t = needed(reports, "time");
  const auto& x = needed(reports, "x");
  const auto& y = needed(reports, "y");
  const auto& v_x = needed(reports, "velocity_x");
  const auto& v_y = needed(reports, "velocity_y");
  const auto& heading = needed(reports, "heading");
  std::vector<TrackPoint> points;
  for (std::size_t i = first; i < first + count; ++i) {
    TrackPoint point{t[i], twin::ned_of(Horizontal(x[i], y[i])), {}, present(heading[i])};
    if (!std::isnan(v_x[i])) point.velocity_m_s = twin::ned_of(Horizontal(v_x[i], v_y[i]));
    if (!is_sound(point, points))
      throw Error(ErrorKind::invalid_input,
                  "row " + std::to_string(i) + " of the table report is no report of a track");
    points.push_back(point);
  }
  return twin::Track(std::move(points));
}

}  // namespace

std::vector<TrajectoryTable> traffic_tables(std::span<const TrafficVessel> vessels,
                                            std::span<const twin::AlarmRecord> alarms) {
  if (vessels.empty()) return {};
  return {vessel_table(vessels), report_table(vessels), alarm_table(vessels, alarms)};
}

std::string traffic_checksum(std::span<const TrafficVessel> vessels) {
  if (vessels.empty()) return "";
  Sha256 sum;
  for (const TrajectoryTable& table : traffic_tables(vessels, {})) {
    for (const auto& column : table.columns) sum.update(std::as_bytes(std::span(column.values)));
    for (const auto& column : table.texts)
      for (const std::string& text : column.values) sum.update(text + "\n");
  }
  return sum.hex();
}

std::vector<TrafficVessel> vessels_in(const ingest::TrajectoryFile& log) {
  const TrajectoryTable* vessels = log.find_table("vessel");
  const TrajectoryTable* reports = log.find_table("report");
  if (vessels == nullptr || reports == nullptr) return {};
  std::vector<TrafficVessel> out;
  const std::vector<std::string>* names = vessels->text("name");
  std::size_t first = 0;
  for (std::size_t i = 0; i < vessels->rows(); ++i) {
    const double count = needed(*vessels, "reports")[i];
    const double mmsi = needed(*vessels, "mmsi")[i];
    if (!(count >= 1 && count <= static_cast<double>(reports->rows() - first)) ||
        !(mmsi >= 0 && mmsi <= 4e9))
      throw Error(ErrorKind::invalid_input,
                  "the reports of vessel " + std::to_string(i) + " are not in the log");
    TrafficVessel vessel;
    vessel.id = static_cast<std::uint32_t>(mmsi);
    vessel.is_around = needed(*vessels, "around")[i] != 0;
    vessel.length_m = present(needed(*vessels, "length")[i]);
    vessel.beam_m = present(needed(*vessels, "beam")[i]);
    if (names != nullptr) vessel.name = names->at(i);
    vessel.track = track_of(*reports, first, static_cast<std::size_t>(count));
    first += static_cast<std::size_t>(count);
    out.push_back(std::move(vessel));
  }
  return out;
}

}  // namespace slackwater::api
