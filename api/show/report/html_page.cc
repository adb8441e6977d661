#include "api/show/report/html_page.h"

#include <algorithm>
#include <cctype>
#include <system_error>

#include "api/show/report/assets.h"
#include "api/web/look/page_look.h"
#include "fields/base/check.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "fields/base/whole_file.h"

namespace slackwater::api {
namespace {

std::string header_html(const HtmlPage& page) {
  std::string out = "<header><h1>" + escaped_html(page.title) + "</h1><p class=\"site\">" +
                    escaped_html(page.site) + "</p>";
  if (!page.headline.empty()) {
    out += std::string("<p class=\"headline") + (page.alarm.empty() ? "" : " degraded") + "\">" +
           (page.alarm.empty() ? "" : "<strong>" + escaped_html(page.alarm) + "</strong> ") +
           escaped_html(page.headline) + "</p>";
  }
  out += page.first_html + "<dl class=\"facts\">";
  for (const auto& [label, value] : page.facts) {
    out += "<div><dt>" + escaped_html(label) + "</dt><dd>" + escaped_html(value) + "</dd></div>";
  }
  return out + "</dl></header>\n";
}

std::string scripts_html(const HtmlPage& page, std::string_view plotting_library) {
  std::string out =
      "<script type=\"application/json\" id=\"report-data\">" + page.data_json + "</script>\n";
  out += "<script>";
  out += plotting_library;
  out += "</script>\n<script>\n";
  out += report_common_script();
  out += page.script;
  return out + "</script>\n";
}

/// A text as a string of CSS, whatever is in it: all that is no letter or digit is escaped.
std::string css_string(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 || std::isalnum(byte) != 0)
      out += c;
    else
      out += formatted("\\{:x} ", static_cast<unsigned>(byte));
  }
  return out + "\"";
}

/// On paper each page says what it belongs to, and which of how many it is.
std::string printed_edges(const HtmlPage& page) {
  return "@page { @top-left { content: " + css_string(page.title) +
         "; font: 9px sans-serif; } @top-right { content: " + css_string(page.site) +
         "; font: 9px sans-serif; } @bottom-right { content: counter(page) \" of \" "
         "counter(pages); font: 9px sans-serif; } }\n";
}

}  // namespace

std::string table_html(const ReportTable& table) {
  std::string out = "<section class=\"table\"><h2>" + escaped_html(table.title) +
                    "</h2><div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"" +
                    escaped_html(table.title) + "\"><table><thead><tr>";
  for (const std::string& column : table.columns) out += "<th>" + escaped_html(column) + "</th>";
  out += "</tr></thead><tbody>\n";
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    expects(table.rows[row].size() == table.columns.size(),
            "a table's row has a cell for every column");
    const bool is_marked = table.highlighted_row == row ||
                           std::find(table.marked_rows.begin(), table.marked_rows.end(), row) !=
                               table.marked_rows.end();
    out += is_marked ? "<tr class=\"highlighted\">" : "<tr>";
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

std::string page_html(const HtmlPage& page, std::string_view plotting_library) {
  const bool has_plots = !plotting_library.empty();
  std::string out =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>" +
      escaped_html(page.title) + "</title>\n<style>\n";
  out += web::page_look();
  out += report_style();
  out += printed_edges(page);
  out += "</style></head><body>\n" + header_html(page) + "<main>\n";
  if (has_plots) {
    out += page.plots_html;
    out +=
        "<noscript><p class=\"headline degraded\">The plots need JavaScript; the tables below do "
        "not.</p></noscript>\n";
  } else if (!page.is_without_plots) {
    out +=
        "<p class=\"headline degraded\">This page has no plots: the plotting library was not at "
        "hand when the program was built (npm could not fetch it). The numbers are in the "
        "tables.</p>\n";
    out += page.instead_of_plots_html;
  }
  out += page.tables_html + "</main>\n<footer>";
  for (const std::string& attribution : page.attributions)
    out += "<p>" + escaped_html(attribution) + "</p>";
  if (has_plots) out += "<p>Plots: Apache ECharts (Apache-2.0) with zrender (BSD-3-Clause).</p>";
  if (!page.generated.empty()) out += "<p>Made " + escaped_html(page.generated) + "</p>";
  out += "</footer>\n";
  if (has_plots) out += scripts_html(page, plotting_library);
  return out + "</body></html>\n";
}

void write_page(const std::string& html, const std::filesystem::path& file) {
  if (file.has_parent_path()) {
    std::error_code ignored;  // a folder that cannot be made shows itself when the file is opened
    std::filesystem::create_directories(file.parent_path(), ignored);
  }
  if (std::error_code unknown; std::filesystem::is_directory(file, unknown)) {
    throw Error(ErrorKind::usage, "found the folder " + file.string() +
                                      " where a page was to be written; name a file in it");
  }
  write_text(file, html);
}

}  // namespace slackwater::api
