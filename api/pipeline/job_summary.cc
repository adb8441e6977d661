#include "api/pipeline/job_summary.h"

#include <nlohmann/json.hpp>

#include "api/pipeline/snapshot_json.h"
#include "api/pipeline/sources_json.h"
#include "fields/service/wave_source.h"

namespace slackwater::api {
namespace {

using calibration::ColumnForecast;
using calibration::DailyForecast;
using nlohmann::json;

json inputs_of(const DailyForecast& forecast) {
  json list = json::array();
  for (const ProductFiles& files : forecast.snapshot.provenance.inputs)
    list.push_back({{"product", files.product}, {"sha256", files.sha256}});
  return list;
}

json calibration_json(const calibration::Calibration& c) {
  json parameters = json::array();
  for (const calibration::Parameter& p : c.parameters) {
    parameters.push_back({{"name", p.name},
                          {"unit", p.unit},
                          {"value", p.value},
                          {"sigma", p.sigma},
                          {"sigma_of_logarithm", p.is_logarithmic},
                          {"prior", p.prior},
                          {"prior_sigma", p.prior_sigma},
                          {"lower", p.lower},
                          {"upper", p.upper},
                          {"at_bound", p.at_bound},
                          {"weakly_determined", p.weakly_determined},
                          {"source", p.source}});
  }
  json misfit = json::array();
  for (const calibration::MisfitAtDepth& m : c.misfit) {
    misfit.push_back({{"depth_m", m.depth_m},
                      {"n", m.n},
                      {"rms_m_s", m.rms_m_s},
                      {"bias_east_m_s", m.bias_east_m_s},
                      {"bias_north_m_s", m.bias_north_m_s}});
  }
  return {{"form", std::string(name_of(c.form))},
          {"wind_used", c.wind_used},
          {"water_depth_m", c.water_depth_m},
          {"parameters", parameters},
          {"covariance", c.covariance},
          {"misfit", misfit},
          {"rms_m_s", c.rms_m_s},
          {"observations", c.observations},
          {"effective_observations", c.effective_observations},
          {"iterations", c.iterations},
          {"termination", c.termination},
          {"warnings", c.warnings}};
}

/// How the spread of a weather ensemble stood to its error, by day of lead.
json spread_json(const calibration::SpreadCheck& check) {
  json list = json::array();
  for (const calibration::CheckedLead& lead : check.lead) {
    list.push_back({{"days", lead.days},
                    {"checked", lead.is_checked()},
                    {"rms_error_m_s", lead.rms_error_m_s},
                    {"rms_spread_m_s", lead.rms_spread_m_s},
                    {"factor", lead.factor}});
  }
  return list;
}

/// Whose winds the members have, member by member.
json wind_members_json(const ColumnForecast& column) {
  if (!column.wind_ensemble) return nullptr;
  const calibration::WindEnsembleRun& run = *column.wind_ensemble;
  return {{"product", run.product_id},
          {"dataset", run.dataset},
          {"reference_time", format_utc(run.reference_time)},
          {"of_members", run.number.size()},
          {"spread_by_lead_day", spread_json(run.spread)},
          {"number", column.column.wind_member_number}};
}

/// Where the waves come from; what those that were computed rest on.
json waves_json(const DailyForecast& forecast) {
  const std::string sources = wave_sources_text(forecast.snapshot);
  if (sources.empty()) return nullptr;
  json waves = {{"source", sources}, {"computed", nullptr}};
  if (!forecast.computed_waves) return waves;
  const calibration::ComputedWaves& computed = *forecast.computed_waves;
  const auto or_null = [](const std::optional<double>& value) {
    return value ? json(*value) : json(nullptr);
  };
  waves["computed"] = {
      {"hours", computed.hours},
      {"of_hours", computed.of_hours},
      {"of_wind_alone", computed.of_wind_alone},
      {"fetch_km", {computed.fetch.shortest_m() / 1000, computed.fetch.longest_m() / 1000}},
      {"fetch_assumed", computed.is_fetch_assumed},
      {"highest_m", computed.highest_m},
      {"highest_half_fetch_m", or_null(computed.highest_half_fetch_m)},
      {"highest_twice_fetch_m", or_null(computed.highest_twice_fetch_m)},
      {"text", calibration::text_of(computed)}};
  return waves;
}

json failure_json(const calibration::PartFailure& failed, const json& column) {
  return {{"part", name_of(failed.part)},
          {"column", column},
          {"kind", name_of(failed.failure.kind)},
          {"why", failed.failure.why}};
}

/// The parts that failed, those of a column with its index.
json failures_json(const DailyForecast& forecast) {
  json list = json::array();
  for (const calibration::PartFailure& failed : forecast.failures)
    list.push_back(failure_json(failed, nullptr));
  for (std::size_t i = 0; i < forecast.columns.size(); ++i) {
    for (const calibration::PartFailure& failed : forecast.columns[i].failures)
      list.push_back(failure_json(failed, i));
  }
  return list;
}

json share_json(const calibration::Blend& blend) {
  json share = json::array();
  for (const calibration::CandidateShare& s : blend.share) {
    share.push_back({{"method", name_of(s.method)},
                     {"weight", s.weight},
                     {"pairs", s.pairs},
                     {"past_rmse_m_s", s.past_rmse_m_s ? json(*s.past_rmse_m_s) : json(nullptr)}});
  }
  return share;
}

/// Weights of the candidates and the factor on the spread, with where they come from.
json blend_json(const DailyForecast& forecast) {
  if (!forecast.earned) return nullptr;
  const auto& blend = forecast.earned->blend;
  const auto& spread = forecast.earned->spread;
  json later = json::array();
  for (const calibration::Blend& of_day : forecast.earned->later) {
    later.push_back({{"share", share_json(of_day)},
                     {"pairs", of_day.pairs},
                     {"earned", of_day.earned},
                     {"provenance", of_day.provenance}});
  }
  return {
      {"share", share_json(blend)},
      {"later", later},
      {"simulated_days", forecast.earned->simulated_days},
      {"pairs", blend.pairs},
      {"earned", blend.earned},
      {"fell_back_to",
       blend.fell_back_to ? json(name_of(blend.share[*blend.fell_back_to].method)) : json(nullptr)},
      {"provenance", blend.provenance},
      {"spread_scale", spread.scale},
      {"spread_pairs", spread.pairs},
      {"spread_provenance", spread.provenance}};
}

}  // namespace

json job_summary(const DailyJob& job) {
  const DailyForecast& forecast = job.forecast;
  const calibration::ForecastPlan& plan = forecast.plan;
  json columns = json::array();
  for (std::size_t i = 0; i < forecast.columns.size(); ++i) {
    const ColumnForecast& column = forecast.columns[i];
    json entry = {{"latitude_deg", column.column.point.latitude_deg()},
                  {"longitude_deg", column.column.point.longitude_deg()},
                  {"water_depth_m", column.column.water_depth_m},
                  {"water_depth_source", column.column.water_depth_source},
                  {"wind_members", wind_members_json(column)},
                  {"notes", column.notes},
                  {"sources", sources_json(column.sources)}};
    if (const calibration::Calibration* best = column.calibration()) {
      entry["calibration"] = calibration_json(*best);
      entry["forms"] = json::array();
      for (std::size_t f = 0; f < column.forms.size(); ++f) {
        entry["forms"].push_back({{"form", std::string(name_of(column.forms[f].form))},
                                  {"probability", column.form_weight[f]},
                                  {"rms_m_s", column.forms[f].rms_m_s},
                                  {"log_occam", column.forms[f].log_occam}});
      }
    } else {
      entry["calibration"] = nullptr;
      entry["calibration_problem"] = column.calibration_problem;
    }
    columns.push_back(std::move(entry));
  }
  return {{"site", job.site.id},
          {"site_yaml", job.site.yaml},
          {"day", format_day(plan.day)},
          {"issued", format_utc(plan.issued)},
          {"wind", std::string(name_of(plan.wind))},
          {"hindsight", forecast.snapshot.hindsight},
          {"simulated_wind", forecast.snapshot.simulated_wind},
          {"averaged", averaged_json(forecast.snapshot.averaged)},
          {"horizon_h", hours_of(job.horizon)},
          {"dataset", plan.dataset},
          {"stands_in_for", plan.stands_in_for},
          {"inputs", inputs_of(forecast)},
          {"dry_columns", job.dry_columns},
          {"columns", columns},
          {"blend", blend_json(forecast)},
          {"waves", waves_json(forecast)},
          {"failed", failures_json(forecast)},
          {"code_version", forecast.snapshot.provenance.code_version}};
}

}  // namespace slackwater::api
