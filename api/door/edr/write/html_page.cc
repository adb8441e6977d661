#include "api/door/edr/write/html_page.h"

#include <array>
#include <cctype>
#include <nlohmann/json.hpp>
#include <vector>

#include "api/door/edr/write/html_frame.h"
#include "fields/base/encode/html.h"
#include "fields/base/text.h"

namespace slackwater::api::edr {
namespace {

using nlohmann::json;

std::string text_of(const json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string text_at(const json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() ? std::string() : text_of(*found);
}

std::string escaped_at(const json& object, const char* key) {
  return escaped_html(text_at(object, key));
}

std::string element(const std::string& tag, const std::string& inner) {
  std::string out = "<" + tag + ">";
  out += inner;
  return out + "</" + tag + ">\n";
}

std::string anchor(const std::string& href, const std::string& text) {
  std::string out = "<a href=\"" + escaped_html(href);
  out += "\">";
  out += escaped_html(text);
  return out + "</a>";
}

std::string with_format(const std::string& href, const char* format) {
  return href + (href.find('?') == std::string::npos ? "?f=" : "&f=") + format;
}

bool is_document(const std::string& type) {
  return type == "application/json" || type == "application/geo+json";
}

/// Where a link leads a person; empty where it leads to this page again, or to a query that wants
/// more than the link has.
std::string href_of(const json& link) {
  const std::string href = text_at(link, "href");
  const std::string rel = text_at(link, "rel");
  const std::string type = text_at(link, "type");
  if (rel == "alternate" || type == "application/prs.coverage+json") return {};
  if (rel == "self") return with_format(href, "json");
  return is_document(type) ? with_format(href, "html") : href;
}

std::string anchor_of(const json& link) {
  const std::string href = href_of(link);
  if (href.empty()) return {};
  const std::string rel = text_at(link, "rel");
  if (rel == "self") return anchor(href, "This page as JSON");
  if (rel == "next") return anchor(href, "Next page");
  const std::string title = text_at(link, "title");
  return anchor(href, title.empty() ? rel : title);
}

std::string links_line(const json& object) {
  std::string line;
  if (const auto links = object.find("links"); links != object.end())
    for (const json& link : *links) line += anchor_of(link);
  return line.empty() ? line : "<p class=\"links\">" + line + "</p>\n";
}

/// A table whose cells know their column, for screens that are too narrow for it.
std::string table(const std::vector<std::string>& columns,
                  const std::vector<std::vector<std::string>>& rows) {
  std::string out = "<table><thead><tr>";
  for (const std::string& column : columns) out += "<th>" + column + "</th>";
  out += "</tr></thead>\n<tbody>";
  for (const auto& row : rows) {
    out += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      out += i == 0 ? "<td>" : "<td data-of=\"" + columns[i] + "\">";
      out += row[i];
      out += "</td>";
    }
    out += "</tr>\n";
  }
  return out + "</tbody></table>\n";
}

/// The page of what is listed: its own address.
std::string page_of(const json& listed) {
  if (const auto links = listed.find("links"); links != listed.end()) {
    for (const json& link : *links)
      if (text_at(link, "rel") == "self") return with_format(text_at(link, "href"), "html");
  }
  return {};
}

/// As the desk says it.
std::string status_words(const std::string& status) {
  if (status == "ok") return "Forecast in force";
  if (status == "degraded") return "Degraded";
  if (status == "stale") return "Old forecast";
  if (status == "hindcast") return "Of a past day";
  if (status == "unreadable") return "Cannot be read";
  return status;
}

std::string sites_of(const json& sites) {
  std::string out = "<h2>Sites</h2>\n";
  if (sites.empty())
    out += "<p>No forecast has been issued yet: run <code>slackwater forecast</code>.</p>\n";
  for (const json& site : sites) {
    const std::string word = escaped_at(site, "status");
    out += "<section id=\"" + escaped_at(site, "id") + "\"><h3>" + escaped_at(site, "title") +
           "</h3>\n<p><span class=\"badge status\" data-status=\"" + word + "\">" +
           status_words(word) + "</span> " + escaped_at(site, "description") +
           "</p>\n<p>Newest forecast: " + escaped_at(site, "issued") + ", ending " +
           escaped_at(site, "valid_to") + ".</p>\n" + links_line(site) + "</section>\n";
  }
  return out;
}

std::string extent_of(const json& extent) {
  std::string out;
  if (const auto box = extent.find("spatial"); box != extent.end()) {
    const json& corners = box->at("bbox").at(0);
    out += "<dt>West, south, east, north</dt><dd>";
    for (std::size_t i = 0; i < corners.size(); ++i)
      out += (i == 0 ? "" : ", ") + formatted("{:.3f}°", corners[i].get<double>());
    out += "</dd>";
  }
  if (const auto time = extent.find("temporal"); time != extent.end()) {
    const json& ends = time->at("interval").at(0);
    out += "<dt>From, to</dt><dd>" + escaped_html(text_of(ends[0])) + ", " +
           escaped_html(text_of(ends[1])) + "</dd>";
  }
  if (const auto vertical = extent.find("vertical"); vertical != extent.end()) {
    out += "<dt>Levels (m)</dt><dd>";
    const json& levels =
        vertical->contains("values") ? vertical->at("values") : vertical->at("interval").at(0);
    for (std::size_t i = 0; i < levels.size(); ++i)
      out += (i == 0 ? "" : ", ") + escaped_html(text_of(levels[i]));
    out += "</dd>";
  }
  return "<h2>Where and when</h2>\n" + element("dl", out);
}

std::string parameters_of(const json& names) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& [name, parameter] : names.items()) {
    rows.push_back({"<code>" + escaped_html(name) + "</code>", escaped_at(parameter, "description"),
                    escaped_html(text_of(parameter.at("unit").at("symbol").at("value")))});
  }
  return "<h2>Parameters</h2>\n" + table({"name", "what", "unit"}, rows);
}

std::string queries_of(const json& queries) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& [name, query] : queries.items()) {
    const json& link = query.at("link");
    const bool is_list = name == "locations" || name == "items";
    const std::string example = text_at(link, "slackwater:example");
    const std::string href = is_list           ? with_format(text_at(link, "href"), "html")
                             : example.empty() ? example
                                               : with_format(example, "json");
    const std::string what = text_at(link.at("variables"), "description");
    rows.push_back({"<code>" + escaped_html(name) + "</code>",
                    escaped_html(what.empty() ? text_at(link, "title") : what),
                    href.empty() ? "" : anchor(href, is_list ? "list" : "example")});
  }
  return "<h2>Queries</h2>\n" + table({"query", "what", "try"}, rows);
}

std::string list_of(const json& listed) {
  std::string out;
  for (const json& entry : listed) {
    out += "<section><h2>" + anchor(page_of(entry), text_at(entry, "title")) + "</h2>\n<p>" +
           escaped_at(entry, "description") + "</p>";
    const auto extent = entry.find("extent");
    if (extent != entry.end() && extent->contains("temporal")) {
      const json& ends = extent->at("temporal").at("interval").at(0);
      out += "<p>From " + escaped_html(text_of(ends[0])) + " to " + escaped_html(text_of(ends[1])) +
             ".</p>";
    }
    out += "</section>\n";
  }
  return out;
}

/// What a feature says of itself; its parameters by name alone.
std::string properties_of(const json& feature) {
  std::string out;
  if (text_at(feature.at("geometry"), "type") == "Point") {
    const json& at = feature.at("geometry").at("coordinates");
    out += "<dt>longitude, latitude</dt><dd>" + escaped_html(text_of(at[0])) + "°, " +
           escaped_html(text_of(at[1])) + "°</dd>";
  }
  for (const auto& [key, value] : feature.at("properties").items()) {
    if (key == "edrqueryendpoint" || key == "parameter-name" || key == "label") continue;
    out += "<dt>" + escaped_html(key) + "</dt><dd>" + escaped_html(text_of(value)) + "</dd>";
  }
  return element("dl", out);
}

std::string features_of(const json& features) {
  std::string out;
  for (const json& feature : features) {
    const std::string label = text_at(feature.at("properties"), "label");
    const std::string page = page_of(feature);
    out += "<section><h2>" + (page.empty() ? escaped_html(label) : anchor(page, label)) +
           "</h2>\n" + properties_of(feature) + (page.empty() ? links_line(feature) : "") +
           "</section>\n";
  }
  return out.empty() ? "<p>None.</p>\n" : out;
}

std::string identifiers_of(const json& list) {
  std::string out;
  for (const json& item : list) out += "<li><code>" + escaped_html(text_of(item)) + "</code></li>";
  return "<h2>Conforms to</h2>\n" + element("ul", out);
}

struct DocumentPart {
  const char* key;
  std::string (*write)(const json&);
};

/// The parts of all documents, in the order of a page.
constexpr std::array<DocumentPart, 8> parts{{{"slackwater:sites", sites_of},
                                             {"collections", list_of},
                                             {"instances", list_of},
                                             {"features", features_of},
                                             {"extent", extent_of},
                                             {"data_queries", queries_of},
                                             {"parameter_names", parameters_of},
                                             {"conformsTo", identifiers_of}}};

/// A parameter of an operation, itself or as it is referred to.
const json& resolved(const json& openapi, const json& parameter) {
  const auto reference = parameter.find("$ref");
  if (reference == parameter.end()) return parameter;
  return openapi.at(json::json_pointer(reference->get<std::string>().substr(1)));
}

/// "get" of an OpenAPI document is GET on the wire.
std::string as_sent(std::string method) {
  for (char& letter : method) letter = static_cast<char>(std::toupper(letter));
  return method;
}

std::vector<std::vector<std::string>> rows_of(const json& openapi, const json& parameters) {
  std::vector<std::vector<std::string>> rows;
  for (const json& given : parameters) {
    const json& parameter = resolved(openapi, given);
    rows.push_back({"<code>" + escaped_at(parameter, "name") + "</code>",
                    escaped_at(parameter, "in"), parameter.value("required", false) ? "yes" : "no",
                    escaped_at(parameter, "description"), escaped_at(parameter, "example")});
  }
  return rows;
}

}  // namespace

std::string html_page(const std::string& title, const std::string& base, const json& document) {
  std::string body;
  std::string heading = text_at(document, "title");
  const bool is_feature = text_at(document, "type") == "Feature";
  if (is_feature) heading = text_at(document.at("properties"), "label");
  if (const std::string text = text_at(document, "description"); !text.empty())
    body += "<p>" + escaped_html(text) + "</p>\n";
  if (is_feature) body += properties_of(document);
  for (const DocumentPart& part : parts)
    if (const auto found = document.find(part.key); found != document.end())
      body += part.write(*found);
  const std::string links = links_line(document);
  if (!links.empty()) body += "<h2>From here</h2>\n" + links;
  return html_frame(heading.empty() ? title : heading, base, body);
}

std::string html_of_interface(const std::string& base, const json& openapi) {
  std::string body = "<p>" + escaped_at(openapi.at("info"), "description") + "</p>\n";
  for (const auto& [path, operations] : openapi.at("paths").items()) {
    for (const auto& [method, operation] : operations.items()) {
      body += "<h2>" + escaped_html(as_sent(method) + " " + path) + "</h2><p>" +
              escaped_at(operation, "summary") + "</p>\n";
      const auto rows = rows_of(openapi, operation.at("parameters"));
      if (!rows.empty()) body += table({"parameter", "in", "needed", "what", "example"}, rows);
    }
  }
  return html_frame(text_of(openapi.at("info").at("title")), base, body);
}

}  // namespace slackwater::api::edr
