#include "api/pipeline/snapshot_difference.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ingest/cf/forecast/forecast_file.h"

namespace slackwater::api {
namespace {

bool same(double a, double b) noexcept { return a == b || (std::isnan(a) && std::isnan(b)); }
bool same(Horizontal a, Horizontal b) noexcept {
  return same(a.real(), b.real()) && same(a.imag(), b.imag());
}
bool same(const SeaState& a, const SeaState& b) noexcept {
  return same(a.significant_height_m, b.significant_height_m) &&
         same(a.peak_period_s, b.peak_period_s) && same(a.from_direction_deg, b.from_direction_deg);
}

template <typename T>
bool all_same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const T& x, const T& y) { return same(x, y); });
}

/// The file keeps degrees, the point radians.
bool same_place(const GeoPoint& a, const GeoPoint& b) {
  constexpr double rounding_deg = 1e-12;
  return std::abs(a.latitude_deg() - b.latitude_deg()) < rounding_deg &&
         std::abs(a.longitude_deg() - b.longitude_deg()) < rounding_deg;
}

/// Whether the issued members are the first of those made.
bool are_first(const std::vector<Horizontal>& issued, const std::vector<Horizontal>& made,
               double step_m_s) {
  return issued.size() <= made.size() &&
         std::equal(issued.begin(), issued.end(), made.begin(),
                    [&](Horizontal i, Horizontal m) { return i == ingest::as_filed(m, step_m_s); });
}

std::string column_difference(const ForecastColumn& issued, const ForecastColumn& made) {
  if (!same_place(issued.point, made.point)) return "place";
  if (!same(issued.water_depth_m, made.water_depth_m) ||
      issued.water_depth_source != made.water_depth_source)
    return "water depth";
  if (!all_same(issued.current_m_s, made.current_m_s) ||
      issued.current_status != made.current_status)
    return "central current";
  if (!all_same(issued.current_sigma_m_s, made.current_sigma_m_s)) return "spread of the current";
  if (!all_same(issued.wind_m_s, made.wind_m_s) || issued.wind_source != made.wind_source)
    return "wind";
  if (!all_same(issued.sea, made.sea) || issued.sea_source != made.sea_source ||
      (!issued.height_spread.empty() && !all_same(issued.height_spread, made.height_spread)))
    return "waves";
  if (!all_same(issued.sea_level.level_m, made.sea_level.level_m) ||
      !all_same(issued.sea_level.sigma_m, made.sea_level.sigma_m) ||
      issued.sea_level.source != made.sea_level.source)
    return "level of the sea";
  if (!are_first(issued.member_m_s, made.member_m_s, ingest::member_step_m_s))
    return "members' current";
  if (!are_first(issued.wind_member_m_s, made.wind_member_m_s, ingest::wind_member_step_m_s))
    return "members' wind";
  const std::vector<int>& numbers = issued.wind_member_number;
  if (numbers.size() > made.wind_member_number.size() ||
      !std::equal(numbers.begin(), numbers.end(), made.wind_member_number.begin()))
    return "choice of the weather ensemble's members";
  return {};
}

bool same_provenance(const Provenance& issued, Provenance made) {
  made.code_version = issued.code_version;
  return issued == made;
}

}  // namespace

std::string difference_of(const Snapshot& issued, const Snapshot& made) {
  if (issued.day != made.day) {
    return "its day D is " + format_day(issued.day) + ", this one's " + format_day(made.day);
  }
  if (issued.provenance.inputs != made.provenance.inputs) return "it uses other product files";
  if (issued.time != made.time || issued.depth_m != made.depth_m)
    return "its times and depths differ";
  if (issued.columns.size() != made.columns.size()) return "its columns differ";
  for (std::size_t i = 0; i < issued.columns.size(); ++i) {
    const std::string what = column_difference(issued.columns[i], made.columns[i]);
    if (!what.empty()) return "the " + what + " of column " + std::to_string(i) + " differs";
  }
  // A hindcast is stored without its members, and does not say whose winds they had.
  if (issued.members > 1 && issued.wind_ensemble != made.wind_ensemble)
    return "the weather ensemble differs";
  if (issued.headline != made.headline) return "its headline differs";
  const bool is_told_alike =
      issued.site_id == made.site_id && issued.site_name == made.site_name &&
      issued.issued == made.issued && issued.wind_policy == made.wind_policy &&
      issued.seed == made.seed && issued.degraded == made.degraded &&
      issued.contains_stokes == made.contains_stokes && issued.hindsight == made.hindsight &&
      issued.simulated_wind == made.simulated_wind && issued.averaged == made.averaged &&
      issued.attributions == made.attributions &&
      same_provenance(issued.provenance, made.provenance);
  return is_told_alike ? std::string() : "its description differs";
}

}  // namespace slackwater::api
