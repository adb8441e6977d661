#include "api/door/edr/write/describe.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "api/door/edr/write/json_text.h"
#include "api/program/version.h"
#include "fields/base/percent.h"
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
  append_list(out, "attributions", answer.provenance.attributions);
  out += ',';
  append_list(out, "notes", answer.notes);
  out += ',';
  append_member(out, "code_version", code_version());
  out += '}';
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
  std::array<std::string, provenance_names.size()> values{from.site_id,
                                                          from.instance,
                                                          format_utc(from.issued),
                                                          format_day(from.day),
                                                          from.degraded ? "true" : "false",
                                                          from.headline,
                                                          joined(from.attributions, "; "),
                                                          from.code_version,
                                                          joined(answer.notes, "; "),
                                                          "",
                                                          "",
                                                          ""};
  if (from.product) {
    std::fill_n(values.begin(), 6, "");
    values[7] = code_version();
    values[9] = from.product->product_id;
    values[10] = from.product->dataset_id;
    values[11] = joined(from.product->runs, "; ");
  }
  std::vector<std::pair<std::string, std::string>> headers;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!values[i].empty()) headers.emplace_back(provenance_names[i], header_value(values[i]));
  }
  return headers;
}

}  // namespace slackwater::api::edr
