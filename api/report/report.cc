#include "api/report/report.h"

#include <cmath>

#include "api/report/assets.h"
#include "api/report/plot_data.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

std::string hodograph_html() {
  return "<section class=\"plot\" id=\"hodograph-section\"><h2>Hodograph: how the current turns "
         "with depth</h2>"
         "<p class=\"control\"><label for=\"hodograph-time\">Valid time</label> "
         "<input type=\"range\" id=\"hodograph-time\" min=\"0\" value=\"0\" step=\"1\"> "
         "<output id=\"hodograph-label\"></output></p>"
         "<div class=\"pair\"><div id=\"hodograph\" class=\"chart square\"></div>"
         "<div id=\"spiral\" class=\"chart square\"></div></div>"
         "<p class=\"note\">Each dot is the tip of the current vector at one depth (m, beside it), "
         "seen from above: "
         "right is east, up is north, both in m/s. Left: the whole current, from the origin. "
         "Right: the same minus "
         "its mean over depth, which leaves the spiral of wind and bed friction. Where the truth "
         "is known it is the "
         "hollow, dashed line.</p></section>\n";
}

/// A few hours and depths of the profile in plain text, for a page without plots.
ReportTable profile_table(const ReportProfile& profile) {
  ReportTable table{
      .title = "Forecast current, speed (m/s) and direction it flows to (degrees from north)",
      .note = "",
      .columns = {"Valid time (UTC)"},
      .rows = {},
      .highlighted_row = {}};
  const std::size_t levels = profile.depth_m.size();
  const std::size_t skip = levels / 6 + 1;
  for (std::size_t k = 0; k < levels; k += skip) {
    table.columns.push_back(formatted("{:g} m", profile.depth_m[k]));
  }
  for (std::size_t t = 0; t < profile.time.size(); t += 3) {
    std::string stamp = format_utc(profile.time[t]).substr(0, 16);
    stamp[10] = ' ';
    std::vector<std::string> row{std::move(stamp)};
    for (std::size_t k = 0; k < levels; k += skip) {
      const Horizontal current = profile.current_m_s[t * levels + k];
      row.push_back(std::isnan(current.real()) ? "no value"
                                               : formatted("{:.2f} to {:03.0f}", std::abs(current),
                                                           to_direction_deg(current)));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string plots_html(const ReportInput& input) {
  std::string out;
  if (input.profile) {
    out += plot_html("profile", "Current over time and depth",
                     "Colour: speed (m/s). Arrows: direction the current flows to, up is north, "
                     "length grows with "
                     "speed. Depth is counted from mean sea level; the tide moves the surface, not "
                     "the scale. Times "
                     "are UTC.");
    out += hodograph_html();
  }
  if (!input.skill.empty()) out += plot_html("skill", "Skill by lead and method", input.skill_note);
  if (!input.series.empty()) {
    out += plot_html(
        "series", "Wind and waves",
        "Lines: central forecast; bands: 10 to 90 %; dashed: truth where it is known. Arrows above "
        "a "
        "panel point where the wind blows to, or the waves run to, up is north. Times are UTC.");
  }
  return out;
}

}  // namespace

std::string report_html(const ReportInput& input) {
  return report_html(input, report_plotting_library());
}

std::string report_html(const ReportInput& input, std::string_view plotting_library) {
  HtmlPage page;
  page.title = input.title;
  page.site = input.site;
  page.headline = input.headline;
  if (input.degraded) page.alarm = "Degraded forecast.";
  page.facts = input.facts;
  page.plots_html = plots_html(input);
  for (const ReportTable& table : input.tables) page.tables_html += table_html(table);
  page.attributions = input.attributions;
  page.generated = input.generated;
  page.data_json = plot_data_json(input);  // checks the shapes, with or without plots
  if (input.profile) page.instead_of_plots_html = table_html(profile_table(*input.profile));
  page.script = report_script();
  return page_html(page, plotting_library);
}

void write_report(const ReportInput& input, const std::filesystem::path& file) {
  write_page(report_html(input), file);
}

}  // namespace slackwater::api
