#include "api/door/edr/write/describe.h"

#include <array>
#include <map>
#include <string_view>

#include "api/door/edr/write/json_text.h"
#include "api/program/version.h"
#include "fields/base/encode/percent.h"
#include "fields/base/text.h"

namespace slackwater::api::edr {
namespace {

constexpr std::array provenance_names{
    "Slackwater-Site",     "Slackwater-Instance", "Slackwater-Issued",      "Slackwater-Day",
    "Slackwater-Degraded", "Slackwater-Headline", "Slackwater-Attribution", "Slackwater-Version",
    "Slackwater-Note",     "Slackwater-Product",  "Slackwater-Dataset",     "Slackwater-Runs"};

void append_label(std::string& out, std::string_view key, std::string_view text) {
  out += '"';
  out += key;
  out += "\":{\"en\":";
  append_string(out, text);
  out += '}';
}

void append_member(std::string& out, std::string_view key, std::string_view text) {
  out += '"';
  out += key;
  out += "\":";
  append_string(out, text);
}

void append_list(std::string& out, std::string_view key, const std::vector<std::string>& texts) {
  out += '"';
  out += key;
  out += "\":[";
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (i > 0) out += ',';
    append_string(out, texts[i]);
  }
  out += ']';
}

void append_unit(std::string& out, const Parameter& parameter) {
  out += ",\"unit\":{";
  if (!parameter.unit_label.empty()) {
    append_label(out, "label", parameter.unit_label);
    out += ',';
  }
  out += "\"symbol\":{\"value\":";
  append_string(out, parameter.unit);
  out += ",\"type\":\"http://www.opengis.net/def/uom/UCUM/\"}}";
}

void append_product_provenance(std::string& out, const Answer& answer) {
  const ProductSource& product = *answer.provenance.product;
  out += '{';
  append_member(out, "collection", answer.collection);
  out += ',';
  append_member(out, "product", product.product_id);
  out += ',';
  append_member(out, "dataset", product.dataset_id);
  out += ',';
  append_list(out, "runs", product.runs);
  out += ',';
  append_list(out, "sources_sha256", product.sources);
  out += ',';
  if (product.distance_m) out += formatted("\"distance_m\":{:.0f},", *product.distance_m);
  append_list(out, "attributions", answer.provenance.attributions);
  out += ',';
  append_list(out, "notes", answer.notes);
  out += ',';
  append_member(out, "code_version", code_version());
  out += '}';
}

/// A header stays short: of many runs it says how many, and from when to when.
std::string runs_text(const std::vector<std::string>& runs) {
  constexpr std::size_t most_named = 8;
  if (runs.size() <= most_named) return joined(runs, "; ");
  constexpr std::string_view forecast = "forecast of ";
  std::vector<std::string> told;
  std::vector<std::string> times;
  for (const std::string& run : runs) {
    if (run.starts_with(forecast)) {
      times.push_back(run.substr(forecast.size()));
    } else {
      told.push_back(run);
    }
  }
  told.push_back(counted(times.size(), "forecast") + ", " + times.front() + " to " + times.back());
  return joined(told, "; ");
}

std::string header_value(std::string_view text) {
  std::string value;
  for (const char c : text) {
    if (c >= ' ' && c <= '~' && c != '%') {
      value += c;
    } else {
      value += percent_encoded(std::string_view(&c, 1));
    }
  }
  return value;
}

}  // namespace

void append_parameter(std::string& out, const Parameter& parameter, bool with_id) {
  out += "{\"type\":\"Parameter\"";
  if (with_id) {
    out += ',';
    append_member(out, "id", parameter.name);
  }
  if (!parameter.description.empty()) {
    out += ',';
    append_label(out, "description", parameter.description);
  }
  out += ",\"observedProperty\":{";
  if (!parameter.standard_name.empty()) {
    append_member(out, "id",
                  "http://vocab.nerc.ac.uk/standard_name/" + parameter.standard_name + "/");
    out += ',';
  }
  append_label(out, "label", parameter.label.empty() ? parameter.name : parameter.label);
  out += '}';
  if (!parameter.unit.empty()) append_unit(out, parameter);
  if (!parameter.method.empty()) {
    out += ",\"measurementType\":{";
    append_member(out, "method", parameter.method);
    out += '}';
  }
  out += '}';
}

void append_provenance(std::string& out, const Answer& answer) {
  const Provenance& from = answer.provenance;
  if (from.product) {
    append_product_provenance(out, answer);
    return;
  }
  out += '{';
  append_member(out, "site", from.site_id);
  out += ',';
  append_member(out, "collection", answer.collection);
  out += ',';
  append_member(out, "instance", from.instance);
  out += ",\"issued\":\"";
  append_time(out, from.issued);
  out += "\",";
  append_member(out, "day", format_day(from.day));
  out += ',';
  append_member(out, "headline", from.headline);
  out += from.degraded ? ",\"degraded\":true," : ",\"degraded\":false,";
  append_list(out, "attributions", from.attributions);
  out += ',';
  append_list(out, "notes", answer.notes);
  out += ',';
  append_member(out, "code_version", from.code_version);
  out += '}';
}

std::vector<std::string> provenance_fields() {
  return {provenance_names.begin(), provenance_names.end()};
}

std::vector<std::pair<std::string, std::string>> provenance_headers(const Answer& answer) {
  const Provenance& from = answer.provenance;
  std::map<std::string_view, std::string> values;
  if (from.product) {
    values["Slackwater-Product"] = from.product->product_id;
    values["Slackwater-Dataset"] = from.product->dataset_id;
    values["Slackwater-Runs"] = runs_text(from.product->runs);
    values["Slackwater-Version"] = code_version();
  } else {
    values["Slackwater-Site"] = from.site_id;
    values["Slackwater-Instance"] = from.instance;
    values["Slackwater-Issued"] = format_utc(from.issued);
    values["Slackwater-Day"] = format_day(from.day);
    values["Slackwater-Degraded"] = from.degraded ? "true" : "false";
    values["Slackwater-Headline"] = from.headline;
    values["Slackwater-Version"] = from.code_version;
  }
  values["Slackwater-Attribution"] = joined(from.attributions, "; ");
  values["Slackwater-Note"] = joined(answer.notes, "; ");
  std::vector<std::pair<std::string, std::string>> headers;
  for (const char* name : provenance_names)
    if (!values[name].empty()) headers.emplace_back(name, header_value(values[name]));
  return headers;
}

}  // namespace slackwater::api::edr
