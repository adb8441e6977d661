#include "api/pipeline/filed_making.h"

#include <nlohmann/json.hpp>

namespace slackwater::api {
namespace {

using calibration::ForecastMaking;
using nlohmann::json;

ForecastMaking::Fit fit_of(const json& calibration) {
  ForecastMaking::Fit fit;
  for (const json& p : calibration.at("parameters"))
    fit.parameters.push_back({p.at("name").get<std::string>(), p.at("unit").get<std::string>(),
                              p.at("value").get<double>(), p.at("prior").get<double>(),
                              p.at("at_bound").get<bool>(), p.at("weakly_determined").get<bool>()});
  fit.rms_m_s = calibration.at("rms_m_s").get<double>();
  fit.observations = calibration.at("observations").get<std::size_t>();
  fit.termination = calibration.at("termination").get<std::string>();
  return fit;
}

std::vector<ForecastMaking::Share> shares_of(const json& blend) {
  std::vector<ForecastMaking::Share> shares;
  for (const json& share : blend.at("share"))
    shares.push_back({share.at("method").get<std::string>(), share.at("weight").get<double>()});
  return shares;
}

/// Summaries of earlier versions say nothing of later days of lead.
ForecastMaking::Mixture mixture_of(const json& blend) {
  ForecastMaking::Mixture mixture;
  mixture.by_day.push_back(shares_of(blend));
  for (const json& of_day : blend.value("later", json::array()))
    if (of_day.at("share").size() == mixture.by_day.front().size())
      mixture.by_day.push_back(shares_of(of_day));
  mixture.provenance = blend.at("provenance").get<std::string>();
  mixture.spread_scale = blend.at("spread_scale").get<double>();
  mixture.spread_provenance = blend.at("spread_provenance").get<std::string>();
  mixture.simulated_days = blend.value("simulated_days", std::size_t{0});
  return mixture;
}

std::optional<ForecastMaking> making_in(const json& summary) {
  if (!summary.is_object() || !summary.contains("columns") || summary["columns"].empty())
    return std::nullopt;
  ForecastMaking making;
  const json& column = summary["columns"][0];
  if (const json calibration = column.value("calibration", json()); calibration.is_object())
    making.fit = fit_of(calibration);
  else
    making.no_fit = column.value("calibration_problem", "");
  if (const json blend = summary.value("blend", json()); blend.is_object())
    making.mixture = mixture_of(blend);
  for (const json& use : column.value("sources", json::array()))
    making.sources.push_back(use.at("text").get<std::string>());
  making.notes = column.value("notes", std::vector<std::string>());
  return making;
}

}  // namespace

std::optional<ForecastMaking> filed_making(const std::string& summary_json) {
  try {
    return making_in(json::parse(summary_json));
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

}  // namespace slackwater::api
