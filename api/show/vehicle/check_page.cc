#include "api/show/vehicle/check_page.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "api/json/plot_json.h"
#include "api/show/report/assets.h"
#include "api/show/vehicle/check_tables.h"
#include "fields/base/constants.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using constants::degree;
using nlohmann::json;
using twin::ManoeuvreRow;

constexpr std::size_t most_points = 1000;

/// Rows from the first helm on until the manoeuvre ended, thinned to what a page shows.
std::vector<ManoeuvreRow> shown_rows(const FlownManoeuvre& one) {
  std::vector<ManoeuvreRow> rows;
  const auto executed_s = one.account ? one.account->executed_s() : std::nullopt;
  if (!executed_s) return rows;
  for (const ManoeuvreRow& row : one.rows)
    if (row.t_s >= *executed_s && row.t_s <= one.account->ended_s) rows.push_back(row);
  const std::size_t every = rows.size() / most_points + 1;
  std::vector<ManoeuvreRow> thinned;
  for (std::size_t i = 0; i < rows.size(); i += every) thinned.push_back(rows[i]);
  return thinned;
}

/// Along and across the course at the first helm, m.
json circle_json(const FlownManoeuvre& one) {
  json points = json::array();
  const std::vector<ManoeuvreRow> rows = shown_rows(one);
  for (const ManoeuvreRow& row : rows) {
    const double north = row.north_m - rows.front().north_m,
                 east = row.east_m - rows.front().east_m;
    const double c = std::cos(rows.front().heading_rad), s = std::sin(rows.front().heading_rad);
    points.push_back({number(east * c - north * s), number(north * c + east * s)});
  }
  return points;
}

/// Seconds since the first helm, degrees from the course there.
json heading_json(const FlownManoeuvre& one) {
  json points = json::array();
  const std::vector<ManoeuvreRow> rows = shown_rows(one);
  for (const ManoeuvreRow& row : rows)
    points.push_back(
        {number(row.t_s - rows.front().t_s),
         number(std::remainder(row.heading_rad - rows.front().heading_rad, 2 * constants::pi) /
                degree)});
  return points;
}

json data_json(const VehicleCheck& check) {
  json circle = json::array(), zig_zags = json::array();
  for (const FlownManoeuvre& one : check.manoeuvres) {
    if (!one.account) continue;
    if (one.account->circle) circle = circle_json(one);
    if (one.account->zig_zag)
      zig_zags.push_back({{"name", one.name}, {"heading", heading_json(one)}});
  }
  return {{"circle", circle}, {"zigzags", zig_zags}};
}

std::string manoeuvres_html(const VehicleCheck& check) {
  if (check.manoeuvres.empty()) return "";
  std::string html = "<section><h2>Manoeuvres in still water</h2><div class=\"cards\">";
  for (const FlownManoeuvre& one : check.manoeuvres)
    html += "<div class=\"card\"><h3>" + escaped_html(one.name) + "</h3><p>" +
            escaped_html(figures_of(one)) + "</p></div>";
  return html + "</div></section>\n";
}

}  // namespace

std::string check_page_html(const VehicleCheck& check, std::string_view beside_trial,
                            std::string_view plotting_library) {
  HtmlPage page;
  page.title = "Check of " + check.vehicle.name;
  page.site = check.file.filename().string();
  page.headline = check.vehicle.name + " " + check_verdict(check);
  if (!check.vehicle.warnings.empty()) {
    page.alarm = "Warnings.";
    page.headline = joined(check.vehicle.warnings, "; ") + "; " + page.headline;
  }
  page.facts = {{"cruise", formatted("{:.3g} m/s", check.vehicle.cruise_speed_m_s)},
                {"top", formatted("{:.3g} m/s", check.top_speed_m_s)},
                {"mass", formatted("{:.4g} kg", check.vehicle.body.mass_kg)}};
  page.is_without_plots = check.flies();
  if (!check.flies())
    page.plots_html =
        plot_html("circle", "Turning circle from above",
                  "From where the helm was put over, its course then upwards (m).") +
        plot_html("zigzag", "Zig-zags",
                  "Heading from the course at the first helm (degrees), s since then.");
  if (!beside_trial.empty())
    page.tables_html = "<section><h2>Beside a trial</h2><pre>" +
                       escaped_html(std::string(beside_trial)) + "</pre></section>\n";
  page.tables_html += manoeuvres_html(check);
  for (const ReportTable& table : check_tables(check)) page.tables_html += table_html(table);
  page.data_json = script_safe(data_json(check));
  page.script = vehicle_script();
  return page_html(page, check.flies() ? std::string_view{} : plotting_library);
}

}  // namespace slackwater::api
