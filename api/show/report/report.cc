#include "api/show/report/report.h"

#include <cmath>

#include "api/show/report/assets.h"
#include "api/show/report/plot_data.h"
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

/// The answer in words: what a reader who has ten seconds takes along.
std::string answer_html(const ReportInput& input) {
  if (input.answer.empty()) return {};
  std::string out = "<section id=\"answer\"><h2>" + escaped_html(input.answer_title) +
                    "</h2><dl class=\"answer\">";
  for (const auto& [label, value] : input.answer)
    out += "<dt>" + escaped_html(label) + "</dt><dd>" + escaped_html(value) + "</dd>";
  return out + "</dl></section>\n";
}

std::string speed_html(const ReportSpeed& speed) {
  std::string out =
      "<section class=\"plot\" id=\"speed-section\"><h2>Speed of the current</h2>"
      "<p class=\"control\"><label for=\"speed-depth\">Depth below mean sea level</label> "
      "<select id=\"speed-depth\">";
  for (std::size_t i = 0; i < speed.depths.size(); ++i) {
    out += "<option value=\"" + std::to_string(i) + "\"" + (i == speed.first ? " selected" : "") +
           ">" + escaped_html(speed.depths[i].label) + "</option>";
  }
  out +=
      "</select></p><div id=\"speed\" class=\"chart\" role=\"img\" aria-label=\"Speed of the "
      "current\"></div><p class=\"note\">Line: likely speed (as often too low as too high). Band: "
      "in "
      "8 of 10 cases the speed lies in it. Shaded columns: slack, the likely speed stays below " +
      formatted("{:g} m/s (dashed line)", speed.slack_below_m_s) +
      ". Arrows: where the current flows to, up is north. Times are UTC.</p></section>\n";
  return out;
}

std::string slack_html(const ReportSpeed& speed) {
  return "<div id=\"slack\">" + table_html(speed.depths.at(speed.first).slack_table) + "</div>\n";
}

std::string folded_html(const ReportInput& input) {
  if (input.folded.empty()) return {};
  std::string out = "<details><summary>" + escaped_html(input.folded_title) + "</summary>\n";
  for (const ReportTable& table : input.folded) out += table_html(table);
  return out + "</details>\n";
}

std::string plots_html(const ReportInput& input) {
  std::string out;
  if (input.speed) out += speed_html(*input.speed) + slack_html(*input.speed);
  if (!input.series.empty()) {
    const std::string note =
        input.series_note.empty()
            ? "Lines: central forecast; bands: 10 to 90 %; dashed: truth where it is known."
            : input.series_note;
    out += plot_html("series", "Wind and waves",
                     note +
                         " Arrows above a panel point where the wind blows to, or the waves run "
                         "to, up is north. Times are UTC.");
  }
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
  page.first_html = input.decisions_html + answer_html(input);
  page.plots_html = plots_html(input);
  page.tables_html = input.after_plots_html;
  for (const ReportTable& table : input.tables) page.tables_html += table_html(table);
  page.tables_html += folded_html(input);
  page.attributions = input.attributions;
  page.generated = input.generated;
  page.data_json = plot_data_json(input);  // checks the shapes, with or without plots
  if (input.speed) page.instead_of_plots_html = slack_html(*input.speed);
  if (input.profile) page.instead_of_plots_html += table_html(profile_table(*input.profile));
  page.script = report_script();
  return page_html(page, plotting_library);
}

void write_report(const ReportInput& input, const std::filesystem::path& file) {
  write_page(report_html(input), file);
}

}  // namespace slackwater::api
