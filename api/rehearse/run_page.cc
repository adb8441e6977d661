#include "api/rehearse/run_page.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "api/rehearse/fate.h"
#include "api/rehearse/run_page_traffic.h"
#include "api/report/assets.h"
#include "api/report/html_page.h"
#include "api/report/plot_json.h"

namespace slackwater::api {
namespace {

using ingest::TrajectoryFile;
using nlohmann::json;

/// A page draws no more points of a line than a screen has pixels.
constexpr std::size_t most_points = 1500;

struct Rows {
  std::size_t times = 0;
  std::size_t every = 1;
  [[nodiscard]] std::vector<std::size_t> drawn() const {
    std::vector<std::size_t> rows;
    for (std::size_t t = 0; t < times; t += every) rows.push_back(t);
    if (times > 0 && rows.back() != times - 1) rows.push_back(times - 1);
    return rows;
  }
};

/// Part `k` of a variable of one vehicle, at the rows that are drawn.
json line_of(const TrajectoryFile& log, const Rows& rows, std::size_t vehicle, const char* name,
             std::size_t k = 0, double scale = 1) {
  json out = json::array();
  const TrajectoryFile::Variable* v = log.find(name);
  for (const std::size_t t : rows.drawn())
    out.push_back(v == nullptr || k >= v->per
                      ? json(nullptr)
                      : number(scale * v->values[(vehicle * rows.times + t) * v->per + k]));
  return out;
}

bool is_ever(const TrajectoryFile& log, const Rows& rows, std::size_t vehicle, const char* name,
             std::size_t k) {
  const TrajectoryFile::Variable* v = log.find(name);
  if (v == nullptr || k >= v->per) return false;
  for (std::size_t t = 0; t < rows.times; ++t)
    if (std::abs(v->values[(vehicle * rows.times + t) * v->per + k]) > 0) return true;
  return false;
}

json vehicle_json(const TrajectoryFile& log, const Rows& rows, std::size_t i) {
  constexpr double degrees = 57.29577951308232;
  const auto line = [&](const char* name, std::size_t k = 0, double scale = 1) {
    return line_of(log, rows, i, name, k, scale);
  };
  json thrust = json::array();
  const TrajectoryFile::Variable* t = log.find("thrust");
  for (std::size_t k = 0; t != nullptr && k < t->per; ++k)
    if (is_ever(log, rows, i, "thrust", k)) thrust.push_back(line("thrust", k));
  return {{"name", log.names[i]},
          {"x", line("x")},
          {"y", line("y")},
          {"z", line("z")},
          {"roll", line("roll", 0, degrees)},
          {"pitch", line("pitch", 0, degrees)},
          {"yaw", line("yaw", 0, degrees)},
          {"thrust", thrust},
          {"power", line("electrical_power")},
          {"charge", line("state_of_charge", 0, 100)},
          {"voltage", line("bus_voltage")},
          {"across", line("across_track")},
          {"water", {line("water_velocity", 0), line("water_velocity", 1)}},
          {"wind", {line("wind_velocity", 0), line("wind_velocity", 1)}}};
}

std::string choice_html() {
  return "<p class=\"control\"><label for=\"vehicle\">Vehicle</label> <select "
         "id=\"vehicle\"></select></p>";
}

std::string plots() {
  return plot_html(
             "tracks", "Tracks from above",
             "East and north of the origin (m); the ring is the start. Thin grey lines are other "
             "vessels.") +
         choice_html() +
         plot_html(
             "height", "Height and distance from the track",
             "Height above mean sea level (m, negative below) and distance from the leg under "
             "way (m, positive right of it).") +
         plot_html("attitude", "Attitude", "Roll to starboard, pitch bow up, heading (degrees).") +
         plot_html("thrust", "Thrust", "Of each thruster (N).") +
         plot_html("power", "Power and battery",
                   "Power drawn (W), state of charge (%) and voltage of the bus (V).") +
         plot_html("felt", "Water and wind felt",
                   "Speed of the water, current and waves, and of the wind at the vehicle (m/s).");
}

}  // namespace

std::string run_page_html(const TrajectoryFile& log, std::string_view plotting_library) {
  Rows rows;
  rows.times = log.t_s.size();
  rows.every = std::max<std::size_t>(1, rows.times / most_points);
  json seconds = json::array();
  for (const std::size_t t : rows.drawn()) seconds.push_back(number(log.t_s[t]));
  json vehicles = json::array();
  for (std::size_t i = 0; i < log.names.size(); ++i) vehicles.push_back(vehicle_json(log, rows, i));
  HtmlPage page;
  page.title = log.attribute("title");
  page.site = log.attribute("forecast");
  page.facts = {{"start", format_utc(log.epoch)},
                {"length", std::to_string(static_cast<long>(log.t_s.back())) + " s"},
                {"vehicles", log.attribute("vehicles")},
                {"origin", log.attribute("origin")},
                {"seed", log.attribute("seed")},
                {"member", log.attribute("member")}};
  page.plots_html = plots();
  page.headline = fates_in(log);
  if (!page.headline.empty()) page.alarm = "Not a normal run.";
  page.tables_html = fate_html(log) + traffic_html(log);
  page.data_json =
      script_safe({{"t", seconds}, {"vehicles", vehicles}, {"vessels", vessels_json(log)}});
  if (!log.attribute("attribution").empty()) page.attributions = {log.attribute("attribution")};
  page.generated = log.attribute("source");
  page.script = run_script();
  return page_html(page, plotting_library);
}

void write_run_page(const TrajectoryFile& log, const std::filesystem::path& file) {
  write_page(run_page_html(log, report_plotting_library()), file);
}

}  // namespace slackwater::api
