#include <cmath>
#include <nlohmann/json.hpp>

#include "api/show/report/skill_json.h"
#include "calibration/verify/skill_set.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

/// A tenth of a micrometre a second is beyond every instrument; more digits only fill the disk.
json number(double value) { return std::round(value * 1e7) / 1e7; }

/// Over how many hours the truth was averaged; 0: instants.
json mean_hours(const calibration::SkillEntry& e) { return number(hours_of(e.truth_averaging)); }

json or_null(const std::optional<double>& value) { return value ? number(*value) : json(nullptr); }

json interval_json(const std::optional<calibration::Interval95>& interval) {
  return interval ? json::array({number(interval->low), number(interval->high)}) : json(nullptr);
}

json correlation_json(const std::optional<double>& modulus, const std::optional<double>& angle) {
  return modulus ? json::array({number(*modulus), or_null(angle)}) : json(nullptr);
}

template <std::size_t n>
json numbers_of(const std::array<double, n>& values) {
  json list = json::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

json reliability_json(const std::optional<calibration::Reliability>& reliability) {
  if (!reliability) return nullptr;
  return {{"probability", calibration::Reliability::probability},
          {"below", numbers_of(reliability->below)},
          {"pit", numbers_of(reliability->pit)}};
}

void add_scalar(json& j, const calibration::ScalarScore& s) {
  j["n"] = s.n;
  j["rmse"] = number(s.rmse);
  j["bias"] = number(s.bias);
  j["mae"] = number(s.mae);
  j["scatter_index"] = or_null(s.scatter_index);
}

void add_vector(json& j, const calibration::VectorScore& v) {
  j["n"] = v.n;
  j["rmse_m_s"] = number(v.rmse_m_s);
  j["bias_east_m_s"] = number(v.bias_east_m_s);
  j["bias_north_m_s"] = number(v.bias_north_m_s);
  j["speed_bias_m_s"] = number(v.speed_bias_m_s);
  j["direction_mae_deg"] = or_null(v.direction_mae_deg);
  j["correlation"] = correlation_json(v.correlation_abs, v.correlation_deg);
  j["crps_m_s"] = or_null(v.crps_m_s);
  j["coverage_80"] = or_null(v.coverage_80);
  j["reliability"] = reliability_json(v.reliability);
}

json set_json(const calibration::SkillSet& set) {
  const calibration::SetScore& s = set.score;
  json j = {{"pairs", s.pairs},
            {"few", s.is_of_few()},
            {"days", {format_day(set.first_day), format_day(set.last_day)}},
            {"n", s.n},
            {"interval_95", interval_json(s.rmse_interval)},
            {"truth_mean_h", mean_hours(set.of)},
            {"hindsight", set.of.hindsight},
            {"simulated_wind", set.of.simulated_wind}};
  if (!s.vector) {
    j["rmse"] = number(s.rmse);
    j["forecast_rmse"] = or_null(set.forecast_rmse);
    j["bias"] = or_null(s.bias);
    return j;
  }
  const calibration::VectorSetScore& v = *s.vector;
  j["rmse_m_s"] = number(s.rmse);
  j["forecast_rmse_m_s"] = or_null(set.forecast_rmse);
  j["bias_east_m_s"] = number(v.bias_east_m_s);
  j["bias_north_m_s"] = number(v.bias_north_m_s);
  j["speed_bias_m_s"] = number(v.speed_bias_m_s);
  j["direction_mae_deg"] = or_null(v.direction_mae_deg);
  j["correlation"] = correlation_json(v.correlation_abs, v.correlation_deg);
  j["crps_m_s"] = or_null(v.crps_m_s);
  j["coverage_80"] = or_null(v.coverage_80);
  j["coverage_80_interval_95"] = interval_json(v.coverage_interval);
  j["reliability"] = reliability_json(v.reliability);
  return j;
}

/// Of one of the entries, with the set that it is of.
json entry_json(const std::vector<calibration::SkillEntry>& entries,
                const calibration::SkillSets& sets, std::size_t i) {
  const calibration::SkillEntry& e = entries[i];
  json j = {{"variable", e.variable},
            {"site", e.site},
            {"column", e.column ? json(*e.column) : json(nullptr)},
            {"day", format_day(e.day)},
            {"issued", format_utc(e.issued)},
            {"origin", name_of(e.origin)},
            {"wind", name_of(e.wind)},
            {"lead_h", json::array({e.lead.from_h, e.lead.to_h})},
            {"method", name_of(e.method)},
            {"unit", calibration::unit_of(e.variable)},
            {"interval_95", interval_json(e.interval)},
            {"truth", e.truth},
            {"truth_mean_h", mean_hours(e)},
            {"hindsight", e.hindsight},
            {"simulated_wind", e.simulated_wind}};
  const char* const place = e.band && e.band->above_bed ? "height_above_bed_m" : "depth_m";
  j[place] = e.band ? json::array({e.band->from_m, e.band->to_m}) : json(nullptr);
  if (e.scalar) {
    add_scalar(j, *e.scalar);
    j["forecast_rmse"] = or_null(e.forecast_rmse);
  } else {
    add_vector(j, e.vector);
    j["forecast_rmse_m_s"] = or_null(e.forecast_rmse);
  }
  j["set"] = set_json(sets.sets[sets.of_entry[i]]);
  return j;
}

}  // namespace

json skill_list(const std::vector<calibration::SkillEntry>& entries) {
  const calibration::SkillSets sets = calibration::sets_of(entries);
  json list = json::array();
  for (std::size_t i = 0; i < entries.size(); ++i) list.push_back(entry_json(entries, sets, i));
  return list;
}

std::string skill_json(const std::vector<calibration::SkillEntry>& entries) {
  const calibration::SkillSets sets = calibration::sets_of(entries);
  // One entry a line: a month of hours is long, and a line is what people search for.
  std::string text = "[";
  for (std::size_t i = 0; i < entries.size(); ++i) {
    text += i == 0 ? "\n" : ",\n";
    text += entry_json(entries, sets, i).dump(-1, ' ', false, json::error_handler_t::replace);
  }
  return text + "\n]";
}

}  // namespace slackwater::api
