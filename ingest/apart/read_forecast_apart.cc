#include "ingest/apart/read_forecast_apart.h"

#include "ingest/apart/packed.h"
#include "ingest/apart/read_apart.h"

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

Snapshot read_forecast_apart(const std::filesystem::path& file) {
  if (!is_alone()) return read_forecast(file);
  return unpacked<Snapshot>(read_apart(
      file, allowance_for(file), [&](const TellShare&) { return packed(read_forecast(file)); }));
}

}  // namespace ingest
}  // namespace slackwater
