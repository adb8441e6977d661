#include "api/pipeline/snapshot_json.h"

#include <nlohmann/json.hpp>

#include "fields/base/time.h"

namespace slackwater::api {

nlohmann::json averaged_json(const std::optional<AveragedCurrents>& averaged) {
  using nlohmann::json;
  if (!averaged) return nullptr;
  return {{"mean_h", hours_of(averaged->averaging)},
          {"holds_part_of_the_tide", averaged->holds_part_of_the_tide},
          {"unresolved_tide_m_s",
           averaged->unresolved_tide_m_s ? json(*averaged->unresolved_tide_m_s) : json(nullptr)},
          {"tidal_record",
           averaged->tidal_record.empty() ? json(nullptr) : json(averaged->tidal_record)}};
}

nlohmann::json provenance_json(const Provenance& provenance) {
  using nlohmann::json;
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
  return object;
}

nlohmann::json chart_datum_json(const std::optional<ChartDatum>& datum) {
  if (!datum) return nullptr;
  return {{"name", datum->name},
          {"below_mean_sea_level_m", datum->below_mean_sea_level_m},
          {"source", datum->source}};
}

}  // namespace slackwater::api
