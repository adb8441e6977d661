#include "ingest/apart/read_forecast_apart.h"

#include "ingest/apart/value_apart.h"

namespace slackwater {

template <typename Archive>
void serialize(Archive& archive, SeaState& sea) {
  auto& [significant_height_m, peak_period_s, from_direction_deg] = sea;
  archive(significant_height_m, peak_period_s, from_direction_deg);
}
template <typename Archive>
void serialize(Archive& archive, SeaLevel& level) {
  auto& [level_m, sigma_m, source] = level;
  archive(level_m, sigma_m, source);
}
template <typename Archive>
double save_minimal(const Archive& /*archive*/, const Angle& angle) {
  return angle.radians();
}
template <typename Archive>
void load_minimal(const Archive& /*archive*/, Angle& angle, const double& radians) {
  angle = Angle::from_radians(radians);
}
template <typename Archive>
void serialize(Archive& archive, GeoPoint& point) {
  auto& [latitude, longitude] = point;
  archive(latitude, longitude);
}
template <typename Archive>
void serialize(Archive& archive, ForecastColumn& column) {
  auto& [point, water_depth_m, water_depth_source, current_m_s, current_sigma_m_s, current_status,
         member_m_s, wind_m_s, wind_source, wind_member_m_s, wind_member_number, sea, sea_source,
         height_spread, sea_level] = column;
  archive(point, water_depth_m, water_depth_source, current_m_s, current_sigma_m_s, current_status,
          member_m_s, wind_m_s, wind_source, wind_member_m_s, wind_member_number, sea, sea_source,
          height_spread, sea_level);
}
template <typename Archive>
void serialize(Archive& archive, AveragedCurrents& averaged) {
  auto& [averaging, holds_part_of_the_tide, unresolved_tide_m_s, tidal_record] = averaged;
  archive(averaging, holds_part_of_the_tide, unresolved_tide_m_s, tidal_record);
}
template <typename Archive>
void serialize(Archive& archive, ProductFiles& files) {
  auto& [product, sha256] = files;
  archive(product, sha256);
}
template <typename Archive>
void serialize(Archive& archive, CalibrationSummary& summary) {
  auto& [form, rms_m_s, termination, parameters] = summary;
  archive(form, rms_m_s, termination, parameters);
}
template <typename Archive>
void serialize(Archive& archive, Provenance& provenance) {
  auto& [site, issued, inputs, code_version, calibration] = provenance;
  archive(site, issued, inputs, code_version, calibration);
}
template <typename Archive>
void serialize(Archive& archive, Snapshot& forecast) {
  auto& [site_id, site_name, day, issued, wind_policy, time, depth_m, columns, members, seed,
         degraded, contains_stokes, hindsight, simulated_wind, wind_ensemble, averaged, headline,
         attributions, provenance] = forecast;
  archive(site_id, site_name, day, issued, wind_policy, time, depth_m, columns, members, seed,
          degraded, contains_stokes, hindsight, simulated_wind, wind_ensemble, averaged, headline,
          attributions, provenance);
}

namespace ingest {
namespace {

/// What `read_forecast` promises, whoever took its process over: each list is empty or whole.
void expect_whole_forecast(const Snapshot& forecast) {
  const std::size_t times = forecast.time.size(), values = times * forecast.depth_m.size();
  bool is_whole = times > 0 && !forecast.columns.empty() && forecast.members > 0;
  const auto holds = [&](std::size_t size, std::size_t each) {
    is_whole = is_whole && (size == 0 || size == each);
  };
  for (const ForecastColumn& column : forecast.columns) {
    holds(column.current_m_s.size(), values);
    holds(column.current_sigma_m_s.size(), column.current_m_s.size());
    holds(column.current_status.size(), column.current_m_s.size());
    holds(column.member_m_s.size(), (forecast.members - 1) * values);
    holds(column.wind_m_s.size(), times);
    holds(column.wind_source.size(), times);
    holds(column.wind_member_m_s.size(), (forecast.members - 1) * times);
    holds(column.wind_member_number.size(), forecast.members - 1);
    holds(column.sea.size(), times);
    holds(column.sea_source.size(), times);
    holds(column.height_spread.size(), times);
    holds(column.sea_level.level_m.size(), times);
    holds(column.sea_level.sigma_m.size(), times);
    holds(column.sea_level.source.size(), times);
  }
  if (!is_whole) refuse("its reader told of another forecast than there is");
}

}  // namespace

Snapshot read_forecast_apart(const std::filesystem::path& file) {
  if (!is_alone()) return read_forecast(file);
  return value_apart<Snapshot>(
      file, [&] { return read_forecast(file); }, expect_whole_forecast);
}

}  // namespace ingest
}  // namespace slackwater
