#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "api/pipeline/verify.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

template <typename T>
json or_null(const std::optional<T>& value) {
  return value ? json(*value) : json(nullptr);
}

json entry_json(const SkillEntry& e) {
  json j = {{"variable", e.variable},
            {"site", e.site},
            {"column", or_null(e.column)},
            {"day", format_day(e.day)},
            {"issued", format_utc(e.issued)},
            {"wind", e.wind},
            {"depth_m", e.band ? json::array({e.band->from_m, e.band->to_m}) : json(nullptr)},
            {"lead_h", json::array({e.lead.from_h, e.lead.to_h})},
            {"method", e.method},
            {"interval_95",
             e.interval ? json::array({e.interval->low, e.interval->high}) : json(nullptr)},
            {"truth", e.truth}};
  if (e.scalar) {
    j["unit"] = "m";
    j["n"] = e.scalar->n;
    j["rmse"] = e.scalar->rmse;
    j["bias"] = e.scalar->bias;
    j["mae"] = e.scalar->mae;
    j["scatter_index"] = or_null(e.scalar->scatter_index);
    return j;
  }
  const calibration::VectorScore& v = e.vector;
  j["unit"] = "m s-1";
  j["n"] = v.n;
  j["rmse_m_s"] = v.rmse_m_s;
  j["bias_east_m_s"] = v.bias_east_m_s;
  j["bias_north_m_s"] = v.bias_north_m_s;
  j["speed_bias_m_s"] = v.speed_bias_m_s;
  j["direction_mae_deg"] = or_null(v.direction_mae_deg);
  j["correlation"] = v.correlation_abs
                         ? json::array({*v.correlation_abs, or_null(v.correlation_deg)})
                         : json(nullptr);
  j["crps_m_s"] = or_null(v.crps_m_s);
  j["coverage_80"] = or_null(v.coverage_80);
  return j;
}

double error_of(const SkillEntry& e) { return e.scalar ? e.scalar->rmse : e.vector.rmse_m_s; }

/// What one row of the table pools: pairs of days weigh the same.
struct Pool {
  double squares = 0;
  double weight = 0;
  std::size_t n = 0;
  double coverage = 0;
  double coverage_weight = 0;
  double east = 0;
  double north = 0;
};

std::string band_text(const std::optional<DepthBand>& band) {
  if (!band) return "surface";
  char text[64];
  if (band->to_m >= 1e5) {
    std::snprintf(text, sizeof text, band->from_m > 0 ? "below %.0f m" : "all depths",
                  band->from_m);
  } else {
    std::snprintf(text, sizeof text, "%.0f-%.0f m", band->from_m, band->to_m);
  }
  return text;
}

}  // namespace

std::string skill_json(const std::vector<SkillEntry>& entries) {
  json list = json::array();
  for (const SkillEntry& entry : entries) list.push_back(entry_json(entry));
  return list.dump(2, ' ', false, json::error_handler_t::replace);
}

std::optional<double> set_rmse(const std::vector<SkillEntry>& entries, const std::string& variable,
                               const std::string& method, const LeadBin& lead) {
  double squares = 0;
  double count = 0;
  std::optional<DepthBand> widest;
  for (const SkillEntry& e : entries) {
    if (e.variable != variable || e.method != method || e.column || e.lead.to_h != lead.to_h)
      continue;
    if (e.band && widest && e.band->to_m - e.band->from_m < widest->to_m - widest->from_m) continue;
    if (e.band && widest && e.band->to_m - e.band->from_m > widest->to_m - widest->from_m) {
      squares = 0;
      count = 0;
    }
    widest = e.band;
    squares += error_of(e) * error_of(e);
    count += 1;
  }
  if (count == 0) return std::nullopt;
  return std::sqrt(squares / count);
}

std::string skill_table(const std::vector<SkillEntry>& entries) {
  using Key = std::array<std::string, 4>;  // variable, wind, band, lead
  std::vector<Key> order;
  std::map<Key, std::map<std::string, Pool>> rows;
  for (const SkillEntry& e : entries) {
    if (e.column) continue;
    char lead[32];
    std::snprintf(lead, sizeof lead, "%g-%g h", e.lead.from_h, e.lead.to_h);
    const Key key{e.variable, e.wind, band_text(e.band), lead};
    if (!rows.contains(key)) order.push_back(key);
    Pool& pool = rows[key][e.method];
    pool.squares += error_of(e) * error_of(e);
    pool.weight += 1;
    pool.n += e.scalar ? e.scalar->n : e.vector.n;
    pool.east += e.scalar ? e.scalar->bias : e.vector.bias_east_m_s;
    pool.north += e.vector.bias_north_m_s;
    if (e.vector.coverage_80) {
      pool.coverage += *e.vector.coverage_80;
      pool.coverage_weight += 1;
    }
  }
  std::string table;
  char line[256];
  for (const Key& key : order) {
    std::snprintf(line, sizeof line, "\n%s, %s, lead %s, wind %s\n", key[0].c_str(), key[2].c_str(),
                  key[3].c_str(), key[1].c_str());
    table += line;
    const bool scalar = key[0] == "sea_surface_wave_significant_height";
    std::snprintf(line, sizeof line, "  %-15s %5s %9s %10s %9s %9s %7s\n", "method", "days",
                  "values", scalar ? "rmse m" : "rmse m/s", scalar ? "bias m" : "bias E",
                  scalar ? "" : "bias N", "in 80%");
    table += line;
    std::vector<std::pair<double, std::string>> ranked;
    for (const auto& [method, pool] : rows[key])
      ranked.emplace_back(std::sqrt(pool.squares / pool.weight), method);
    std::sort(ranked.begin(), ranked.end());
    for (const auto& [rmse, method] : ranked) {
      const Pool& pool = rows[key][method];
      std::snprintf(line, sizeof line, "%s %-15s %5.0f %9zu %10.4f %+9.4f",
                    method == "forecast" ? " >" : "  ", method.c_str(), pool.weight, pool.n, rmse,
                    pool.east / pool.weight);
      table += line;
      if (!scalar) {
        std::snprintf(line, sizeof line, " %+9.4f", pool.north / pool.weight);
        table += line;
      }
      if (pool.coverage_weight > 0) {
        std::snprintf(line, sizeof line, " %6.0f%%", 100 * pool.coverage / pool.coverage_weight);
        table += line;
      }
      table += '\n';
    }
  }
  return table;
}

}  // namespace slackwater::api
