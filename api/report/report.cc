#include "api/report/report.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <system_error>

#include "api/report/assets.h"
#include "api/report/plot_data.h"
#include "fields/base/check.h"
#include "fields/base/error.h"

namespace slackwater::api {
namespace {

std::string table_html(const ReportTable& table) {
  std::string out = "<section class=\"table\"><h2>" + escaped_html(table.title) +
                    "</h2><div class=\"scroll\"><table><thead><tr>";
  for (const std::string& column : table.columns) out += "<th>" + escaped_html(column) + "</th>";
  out += "</tr></thead><tbody>\n";
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    expects(table.rows[row].size() == table.columns.size(),
            "a table's row has a cell for every column");
    out += table.highlighted_row == row ? "<tr class=\"highlighted\">" : "<tr>";
    for (const std::string& cell : table.rows[row]) out += "<td>" + escaped_html(cell) + "</td>";
    out += "</tr>\n";
  }
  out += "</tbody></table></div>";
  if (!table.note.empty()) out += "<p class=\"note\">" + escaped_html(table.note) + "</p>";
  return out + "</section>\n";
}

std::string plot_html(const std::string& id, const std::string& title, const std::string& note) {
  return "<section class=\"plot\" id=\"" + id + "-section\"><h2>" + escaped_html(title) +
         "</h2><div id=\"" + id + "\" class=\"chart\" role=\"img\" aria-label=\"" +
         escaped_html(title) + "\"></div><p class=\"note\">" + escaped_html(note) +
         "</p></section>\n";
}

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
    char text[32];
    std::snprintf(text, sizeof text, "%g m", profile.depth_m[k]);
    table.columns.emplace_back(text);
  }
  for (std::size_t t = 0; t < profile.time.size(); t += 3) {
    std::string stamp = format_utc(profile.time[t]).substr(0, 16);
    stamp[10] = ' ';
    std::vector<std::string> row{std::move(stamp)};
    for (std::size_t k = 0; k < levels; k += skip) {
      const Horizontal current = profile.current_m_s[t * levels + k];
      char text[48];
      std::snprintf(text, sizeof text, "%.2f to %03.0f", std::abs(current),
                    to_direction_deg(current));
      row.emplace_back(std::isnan(current.real()) ? "no value" : text);
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

std::string header_html(const ReportInput& input) {
  std::string out = "<header><h1>" + escaped_html(input.title) + "</h1><p class=\"site\">" +
                    escaped_html(input.site) + "</p>";
  if (!input.headline.empty()) {
    out += std::string("<p class=\"headline") + (input.degraded ? " degraded" : "") + "\">" +
           (input.degraded ? "<strong>Degraded forecast.</strong> " : "") +
           escaped_html(input.headline) + "</p>";
  }
  out += "<dl class=\"facts\">";
  for (const auto& [label, value] : input.facts) {
    out += "<div><dt>" + escaped_html(label) + "</dt><dd>" + escaped_html(value) + "</dd></div>";
  }
  return out + "</dl></header>\n";
}

}  // namespace

std::string escaped_html(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string report_html(const ReportInput& input) {
  return report_html(input, report_plotting_library());
}

std::string report_html(const ReportInput& input, std::string_view plotting_library) {
  const std::string data = plot_data_json(input);  // checks the shapes, with or without plots
  const bool has_plots = !plotting_library.empty();
  std::string out =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>" +
      escaped_html(input.title) + "</title>\n<style>\n";
  out += report_style();
  out += "</style></head><body>\n" + header_html(input) + "<main>\n";
  if (has_plots) {
    out += plots_html(input);
    out +=
        "<noscript><p class=\"headline degraded\">The plots need JavaScript; the tables below do "
        "not.</p></noscript>\n";
  } else {
    out +=
        "<p class=\"headline degraded\">This page has no plots: the plotting library was not at "
        "hand when the "
        "program was built (npm could not fetch it). The numbers are in the tables.</p>\n";
    if (input.profile) out += table_html(profile_table(*input.profile));
  }
  for (const ReportTable& table : input.tables) out += table_html(table);
  out += "</main>\n<footer>";
  for (const std::string& attribution : input.attributions)
    out += "<p>" + escaped_html(attribution) + "</p>";
  if (has_plots) out += "<p>Plots: Apache ECharts (Apache-2.0) with zrender (BSD-3-Clause).</p>";
  if (!input.generated.empty()) out += "<p>Made " + escaped_html(input.generated) + "</p>";
  out += "</footer>\n";
  if (has_plots) {
    out += "<script type=\"application/json\" id=\"report-data\">" + data + "</script>\n<script>";
    out += plotting_library;
    out += "</script>\n<script>\n";
    out += report_script();
    out += "</script>\n";
  }
  return out + "</body></html>\n";
}

void write_report(const ReportInput& input, const std::filesystem::path& file) {
  const std::string html = report_html(input);
  if (file.has_parent_path()) {
    std::error_code ignored;  // a folder that cannot be made shows itself when the file is opened
    std::filesystem::create_directories(file.parent_path(), ignored);
  }
  std::filesystem::path part = file;
  part += ".part";
  std::ofstream out(part, std::ios::binary);
  out << html;
  out.close();
  std::error_code failure;
  if (out) std::filesystem::rename(part, file, failure);
  if (!out || failure) {
    std::filesystem::remove(part, failure);
    throw Error(ErrorKind::unavailable,
                "writing the page " + file.string() +
                    " failed; a writable place was expected; check its rights and space");
  }
}

}  // namespace slackwater::api
