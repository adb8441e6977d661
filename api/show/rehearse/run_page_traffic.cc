#include "api/show/rehearse/run_page_traffic.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "api/json/plot_json.h"
#include "api/log/traffic_tables.h"
#include "api/show/report/html_page.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

std::string number_text(double value) { return formatted("{:.0f}", value); }

/// Row `i` of a column; 0 where a foreign file has none.
double at(const ingest::TrajectoryTable& table, const char* name, std::size_t i) {
  const std::vector<double>* column = table.column(name);
  return column == nullptr || i >= column->size() ? 0 : (*column)[i];
}

std::string alarms_html(const ingest::TrajectoryFile& log) {
  ReportTable table;
  table.title = "Alarms";
  table.note =
      "Raised where the closest approach (CPA) and the time to it (TCPA), if both hold their "
      "velocities, are within the limits; times since the start of the run.";
  table.columns = {"Vehicle", "MMSI",   "Name",    "From s", "To s",
                   "CPA m",   "TCPA s", "Least m", "End"};
  const ingest::TrajectoryTable* alarms = log.find_table("alarm");
  for (std::size_t i = 0; alarms != nullptr && i < alarms->rows(); ++i) {
    const auto vehicle = static_cast<std::size_t>(at(*alarms, "vehicle", i));
    const std::vector<std::string>* names = alarms->text("name");
    const auto end = static_cast<twin::AlarmEnd>(static_cast<int>(at(*alarms, "end_reason", i)));
    table.rows.push_back(
        {vehicle < log.names.size() ? log.names[vehicle] : "", number_text(at(*alarms, "mmsi", i)),
         names != nullptr && i < names->size() ? (*names)[i] : "",
         number_text(at(*alarms, "begin", i)), number_text(at(*alarms, "end", i)),
         number_text(at(*alarms, "cpa", i)), number_text(at(*alarms, "tcpa", i)),
         number_text(at(*alarms, "least_distance", i)), std::string(name_of(end))});
  }
  if (table.rows.empty()) table.note = "None.";
  return table_html(table);
}

}  // namespace

json vessels_json(std::span<const twin::TrafficVessel> vessels, double until_s) {
  json out = json::array();
  for (const twin::TrafficVessel& vessel : vessels) {
    json x = json::array(), y = json::array();
    const auto points = vessel.track.points();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool ends_before = i + 1 < points.size() && points[i + 1].t_s <= 0;
      const bool begins_after = i > 0 && points[i - 1].t_s >= until_s;
      if (ends_before || begins_after) continue;
      x.push_back(number(points[i].position_m.y));
      y.push_back(number(points[i].position_m.x));
    }
    const std::string mmsi = std::to_string(vessel.id);
    out.push_back({{"name", vessel.name.empty() ? mmsi : vessel.name + " (" + mmsi + ")"},
                   {"x", x},
                   {"y", y}});
  }
  return out;
}

json vessels_json(const ingest::TrajectoryFile& log) {
  return vessels_json(vessels_in(log), log.t_s.back());
}

std::string traffic_html(const ingest::TrajectoryFile& log) {
  if (log.find_table("vessel") == nullptr) return {};
  std::string html;
  ReportTable followed;
  followed.title = "Tracks followed";
  followed.columns = {"How well"};
  std::istringstream lines(log.attribute("track_deviation"));
  for (std::string line; std::getline(lines, line);) followed.rows.push_back({line});
  if (!followed.rows.empty()) html += table_html(followed);
  return html + alarms_html(log);
}

}  // namespace slackwater::api
