#include "api/edr/write/html_page.h"

#include <nlohmann/json.hpp>

#include "fields/base/html.h"

namespace slackwater::api::edr {
namespace {

using nlohmann::json;

std::string text_of(const json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

bool is_address(const json& value) {
  if (!value.is_string()) return false;
  const auto& text = value.get_ref<const std::string&>();
  return text.starts_with("http://") || text.starts_with("https://");
}

void append(std::string& out, const json& value) {
  if (value.is_object()) {
    out += "<dl>";
    for (const auto& [key, member] : value.items()) {
      out += "<dt>" + escaped_html(key) + "</dt><dd>";
      append(out, member);
      out += "</dd>";
    }
    out += "</dl>\n";
  } else if (value.is_array()) {
    out += "<ul>";
    for (const json& item : value) {
      out += "<li>";
      append(out, item);
      out += "</li>";
    }
    out += "</ul>\n";
  } else if (is_address(value)) {
    const std::string href = escaped_html(text_of(value));
    out += "<a href=\"";
    out += href;
    out += "\">";
    out += href;
    out += "</a>";
  } else {
    out += escaped_html(text_of(value));
  }
}

std::string page(const std::string& title, const std::string& body) {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" +
         escaped_html(title) +
         "</title><style>body{font:1em/1.4 sans-serif;max-width:60em;margin:2em auto;padding:0 1em}"
         "dt{font-weight:bold}dd{margin:0 0 .4em 1.5em}table{border-collapse:collapse}"
         "td,th{border:1px solid #999;padding:.2em .5em;text-align:left}</style></head><body><h1>" +
         escaped_html(title) + "</h1>\n" + body + "</body></html>\n";
}

/// A parameter of an operation, itself or as it is referred to.
const json& resolved(const json& openapi, const json& parameter) {
  const auto reference = parameter.find("$ref");
  if (reference == parameter.end()) return parameter;
  return openapi.at(json::json_pointer(reference->get<std::string>().substr(1)));
}

std::string rows_of(const json& openapi, const json& parameters) {
  std::string rows;
  for (const json& given : parameters) {
    const json& parameter = resolved(openapi, given);
    const json example = parameter.value("example", json());
    rows += "<tr><td>" + escaped_html(text_of(parameter.at("name"))) + "</td><td>" +
            escaped_html(text_of(parameter.at("in"))) + "</td><td>" +
            (parameter.value("required", false) ? "yes" : "no") + "</td><td>" +
            escaped_html(text_of(parameter.at("description"))) + "</td><td>" +
            (example.is_null() ? "" : escaped_html(text_of(example))) + "</td></tr>\n";
  }
  return rows;
}

}  // namespace

std::string html_page(const std::string& title, const json& document) {
  std::string body;
  append(body, document);
  return page(title, body);
}

std::string html_of_interface(const json& openapi) {
  std::string body = "<p>" + escaped_html(text_of(openapi.at("info").at("description"))) + "</p>\n";
  for (const auto& [path, operations] : openapi.at("paths").items()) {
    const json& get = operations.at("get");
    body += "<h2>GET " + escaped_html(path) + "</h2><p>" +
            escaped_html(text_of(get.at("summary"))) + "</p>\n";
    const std::string rows = rows_of(openapi, get.at("parameters"));
    if (rows.empty()) continue;
    body +=
        "<table><tr><th>parameter</th><th>in</th><th>needed</th><th>what</th><th>example</th></tr>"
        "\n" +
        rows + "</table>\n";
  }
  return page(text_of(openapi.at("info").at("title")), body);
}

}  // namespace slackwater::api::edr
