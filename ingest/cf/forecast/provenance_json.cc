#include "ingest/cf/forecast/provenance_json.h"

#include <nlohmann/json.hpp>

#include "fields/base/constants.h"
#include "fields/base/error.h"

namespace slackwater::ingest {
namespace {

using nlohmann::json;

double number_of(const json& value) {
  return value.is_null() ? constants::nan : value.get<double>();
}

CalibrationSummary calibration_of(const json& object) {
  CalibrationSummary calibration;
  calibration.form = object.at("form").get<std::string>();
  calibration.rms_m_s = number_of(object.at("rms_m_s"));
  calibration.termination = object.at("termination").get<std::string>();
  for (const auto& [name, value] : object.at("parameters").items())
    calibration.parameters[name] = number_of(value);
  return calibration;
}

Provenance provenance_of(const json& object) {
  Provenance provenance;
  provenance.site = object.value("site", std::string());
  if (object.contains("issued"))
    provenance.issued = parse_utc(object.at("issued").get<std::string>());
  for (const json& input : object.at("inputs")) {
    provenance.inputs.push_back({input.at("product").get<std::string>(),
                                 input.at("sha256").get<std::vector<std::string>>()});
  }
  provenance.code_version = object.value("code_version", std::string());
  if (object.contains("calibration"))
    provenance.calibration = calibration_of(object.at("calibration"));
  return provenance;
}

}  // namespace

std::string provenance_json(const Provenance& provenance) {
  json inputs = json::array();
  for (const ProductFiles& files : provenance.inputs)
    inputs.push_back({{"product", files.product}, {"sha256", files.sha256}});
  json object = {{"inputs", inputs}};
  if (!provenance.site.empty()) object["site"] = provenance.site;
  if (provenance.issued) object["issued"] = format_utc(*provenance.issued);
  if (!provenance.code_version.empty()) object["code_version"] = provenance.code_version;
  if (const auto& calibration = provenance.calibration) {
    object["calibration"] = {{"form", calibration->form},
                             {"rms_m_s", calibration->rms_m_s},
                             {"termination", calibration->termination},
                             {"parameters", calibration->parameters}};
  }
  return object.dump(-1, ' ', false, json::error_handler_t::replace);
}

Provenance provenance_from(std::string_view text) {
  try {
    return provenance_of(json::parse(text));
  } catch (const json::exception& problem) {
    throw Error(ErrorKind::invalid_input,
                "found a provenance that cannot be read (" + std::string(problem.what()) +
                    "), expected a JSON object with the inputs of the forecast");
  }
}

}  // namespace slackwater::ingest
