#include "api/door/cli/sea/profile_print.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "api/door/cli/command.h"
#include "api/pipeline/snapshot_json.h"
#include "fields/service/speed_quantiles.h"
#include "fields/service/wave_source.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

json component_json(const ProfileAnswer& a, std::size_t level,
                    double (*component)(const Horizontal&)) {
  const CurrentQuantiles quantiles = quantiles_of(a.central[level]);
  json result = {{"value", component(a.samples[level].velocity_m_s)},
                 {"p10", component(quantiles.p10_m_s)},
                 {"p50", component(quantiles.p50_m_s)},
                 {"p90", component(quantiles.p90_m_s)}};
  if (a.members.empty()) return result;
  json values = json::array();
  for (const std::vector<CurrentSample>& member : a.members) {
    const CurrentSample& s = member[level];
    values.push_back(has_value(s.status) ? json(component(s.velocity_m_s)) : json());
  }
  result["members"] = std::move(values);
  return result;
}

/// Behind the numbers of a level that carries those of a higher one.
const char* mark_of(SampleStatus status) {
  return status == SampleStatus::carried ? "  carried" : "";
}

json level_json(const ProfileAnswer& a, std::size_t i) {
  const CurrentSample& s = a.samples[i];
  json level = {{"depth_m", a.depth_m[i]}, {"status", std::string(name_of(s.status))}};
  if (!has_value(s.status)) return level;
  level["eastward_sea_water_velocity"] =
      component_json(a, i, [](const Horizontal& w) { return w.real(); });
  level["northward_sea_water_velocity"] =
      component_json(a, i, [](const Horizontal& w) { return w.imag(); });
  level["sea_water_speed"] = std::abs(s.velocity_m_s);
  level["sea_water_velocity_to_direction"] = to_direction_deg(s.velocity_m_s);
  return level;
}

/// The waves there and then.
struct WavesThen {
  SeaState sea;
  std::string_view source;
};

std::optional<WavesThen> waves_of(const ProfileAnswer& a) {
  const Place place{a.point.longitude_deg(), a.point.latitude_deg(), 0, a.time};
  SeaSample sample;
  a.field->sample_sea({&place, 1}, {&sample, 1});
  const auto source = wave_source_at(a.field->snapshot(), a.time);
  if (!has_value(sample.status) || !source) return std::nullopt;
  return WavesThen{sample.sea, wave_source_words(*source)};
}

json waves_json(const ProfileAnswer& a) {
  const auto waves = waves_of(a);
  if (!waves) return nullptr;
  return {
      {"sea_surface_wave_significant_height", waves->sea.significant_height_m},
      {"sea_surface_wave_period_at_variance_spectral_density_maximum", waves->sea.peak_period_s},
      {"sea_surface_wave_from_direction", waves->sea.from_direction_deg},
      {"source", waves->source}};
}

/// The level of the sea there and then, of the central forecast.
std::optional<SeaLevelSample> sea_level_of(const ProfileAnswer& a) {
  const Place place{a.point.longitude_deg(), a.point.latitude_deg(), 0, a.time};
  SeaLevelSample sample;
  a.field->sample_sea_level({&place, 1}, {&sample, 1});
  if (!has_value(sample.status)) return std::nullopt;
  return sample;
}

json sea_level_json(const ProfileAnswer& a) {
  const auto level = sea_level_of(a);
  if (!level) return nullptr;
  const SeaLevelQuantiles q = quantiles_of(*level);
  json out = {{"sea_surface_height_above_geoid", level->level_m},
              {"standard_deviation", level->sigma_m},
              {"p10", q.p10_m},
              {"p50", q.p50_m},
              {"p90", q.p90_m},
              {"chart_datum", chart_datum_json(a.chart_datum)}};
  if (!a.chart_datum) return out;
  const ChartDatum& datum = *a.chart_datum;
  out["water_surface_height_above_reference_datum"] = {{"value", datum.above_m(level->level_m)},
                                                       {"p10", datum.above_m(q.p10_m)},
                                                       {"p50", datum.above_m(q.p50_m)},
                                                       {"p90", datum.above_m(q.p90_m)}};
  return out;
}

json levels_json(const ProfileAnswer& a) {
  json levels = json::array();
  for (std::size_t i = 0; i < a.depth_m.size(); ++i) levels.push_back(level_json(a, i));
  return levels;
}

json to_json(const ProfileAnswer& a) {
  const Snapshot& snapshot = a.field->snapshot();
  return {{"site", snapshot.site_id},
          {"latitude_deg", a.point.latitude_deg()},
          {"longitude_deg", a.point.longitude_deg()},
          {"time", format_utc(a.time)},
          {"issued", format_utc(snapshot.issued)},
          {"day", format_day(snapshot.day)},
          {"wind", name_of(a.row.wind_policy)},
          {"origin", name_of(a.row.origin)},
          {"member", a.member},
          {"members", snapshot.members},
          {"seed", snapshot.seed},
          {"degraded", snapshot.degraded},
          {"contains_stokes", snapshot.contains_stokes},
          {"hindsight", snapshot.hindsight},
          {"simulated_wind", snapshot.simulated_wind},
          {"averaged", averaged_json(snapshot.averaged)},
          {"headline", snapshot.headline},
          {"notes", a.notes},
          {"water_depth_m", a.water_depth_m},
          {"units",
           {{"velocity", "m s-1"}, {"direction", "degree, towards, clockwise from true north"}}},
          {"levels", levels_json(a)},
          {"waves", waves_json(a)},
          {"sea_level", sea_level_json(a)},
          {"attributions", snapshot.attributions},
          {"provenance", provenance_json(snapshot.provenance)}};
}

/// "21 members" beside the central forecast, or which of them the table shows.
std::string members_text(const ProfileAnswer& a) {
  const std::size_t members = a.field->snapshot().members;
  if (members < 2) return {};
  const std::string count = std::to_string(members) + " members";
  if (a.member == 0) return ", " + count;
  return ", member " + std::to_string(a.member) + " of " + count + " (p10 to p90 of all)";
}

/// The time in UTC, and by the site's clocks where they are known.
std::string time_text(const ProfileAnswer& a) {
  return format_utc(a.time) + (a.time_zone ? " (" + a.time_zone->text(a.time) + ")" : "");
}

void print_csv_rows(const ProfileAnswer& a) {
  for (std::size_t i = 0; i < a.depth_m.size(); ++i) {
    const CurrentSample& s = a.samples[i];
    std::printf("%s,%g,", format_utc(a.time).c_str(), a.depth_m[i]);
    if (has_value(s.status)) {
      const CurrentQuantiles q = quantiles_of(a.central[i]);
      std::printf("%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.1f,", s.velocity_m_s.real(),
                  q.p10_m_s.real(), q.p90_m_s.real(), s.velocity_m_s.imag(), q.p10_m_s.imag(),
                  q.p90_m_s.imag(), std::abs(s.velocity_m_s), to_direction_deg(s.velocity_m_s));
    } else {
      std::printf(",,,,,,,,");
    }
    std::printf("%s\n", std::string(name_of(s.status)).c_str());
  }
}

}  // namespace

void print_profile_json(const ProfileAnswer& answer) {
  std::printf("%s\n", to_json(answer).dump(2, ' ', false, json::error_handler_t::replace).c_str());
}

void print_profiles_json(const std::vector<ProfileAnswer>& answers) {
  json document = to_json(answers.front());
  document.erase("time");
  document.erase("levels");
  document.erase("waves");
  document.erase("sea_level");
  json profiles = json::array();
  for (const ProfileAnswer& a : answers)
    profiles.push_back({{"time", format_utc(a.time)},
                        {"levels", levels_json(a)},
                        {"waves", waves_json(a)},
                        {"sea_level", sea_level_json(a)}});
  document["profiles"] = std::move(profiles);
  std::printf("%s\n", document.dump(2, ' ', false, json::error_handler_t::replace).c_str());
}

void print_profiles_csv(const std::vector<ProfileAnswer>& answers) {
  for (const std::string& note : answers.front().notes)
    std::fprintf(stderr, "slackwater: %s\n", note.c_str());
  std::printf(
      "time,depth_m,east_m_s,east_p10_m_s,east_p90_m_s,north_m_s,north_p10_m_s,north_p90_m_s,speed_"
      "m_s,"
      "to_direction_deg,status\n");
  for (const ProfileAnswer& a : answers) print_csv_rows(a);
}

void print_profile_table(const ProfileAnswer& a) {
  const Snapshot& snapshot = a.field->snapshot();
  std::printf("%s at %s (%.4f N %.4f E, %.0f m of water), forecast issued %s from day %s%s\n",
              snapshot.site_name.c_str(), time_text(a).c_str(), a.point.latitude_deg(),
              a.point.longitude_deg(), a.water_depth_m, format_utc(snapshot.issued).c_str(),
              format_day(snapshot.day).c_str(), members_text(a).c_str());
  if (snapshot.degraded) {
    std::printf("DEGRADED: %s\n", snapshot.headline.c_str());
  } else if (snapshot.hindsight || snapshot.simulated_wind) {
    std::printf("%s\n", snapshot.headline.c_str());
  }
  for (const std::string& note : a.notes) std::printf("note: %s\n", note.c_str());
  // Near slack the speed of the mean is below what is likely: both are named.
  std::printf("%8s %9s %9s %24s %24s %27s\n", "depth m", "speed m/s", "to deg",
              "east m/s (p10 to p90)", "north m/s (p10 to p90)", "likely speed (p10 to p90)");
  for (std::size_t i = 0; i < a.depth_m.size(); ++i) {
    const CurrentSample& s = a.samples[i];
    if (!has_value(s.status)) {
      std::printf("%8.1f %9s\n", a.depth_m[i], std::string(name_of(s.status)).c_str());
      continue;
    }
    const CurrentQuantiles q = quantiles_of(a.central[i]);
    const SpeedQuantiles likely =
        speed_quantiles(std::abs(a.central[i].velocity_m_s), a.central[i].sigma_m_s);
    std::printf(
        "%8.1f %9.3f %9.0f  %+7.3f (%+.3f to %+.3f) %+7.3f (%+.3f to %+.3f)"
        "   %7.3f (%.3f to %.3f)%s\n",
        a.depth_m[i], std::abs(s.velocity_m_s), to_direction_deg(s.velocity_m_s),
        s.velocity_m_s.real(), q.p10_m_s.real(), q.p90_m_s.real(), s.velocity_m_s.imag(),
        q.p10_m_s.imag(), q.p90_m_s.imag(), likely.p50_m_s, likely.p10_m_s, likely.p90_m_s,
        mark_of(s.status));
  }
  if (const auto waves = waves_of(a)) {
    std::printf("Waves: Hs %.2f m, Tp %.1f s, from %.0f deg (%s)\n",
                waves->sea.significant_height_m, waves->sea.peak_period_s,
                waves->sea.from_direction_deg, std::string(waves->source).c_str());
  }
  if (const auto level = sea_level_of(a)) {
    const SeaLevelQuantiles q = quantiles_of(*level);
    std::printf("Level of the sea: %+.2f m over mean sea level (p10 to p90: %+.2f to %+.2f); ",
                level->level_m, q.p10_m, q.p90_m);
    if (const auto& datum = a.chart_datum) {
      std::printf("%+.2f m over chart datum, %s (p10 to p90: %+.2f to %+.2f)\n",
                  datum->above_m(level->level_m), datum->name.c_str(), datum->above_m(q.p10_m),
                  datum->above_m(q.p90_m));
    } else {
      std::printf("the site states no chart datum\n");
    }
  }
  for (const std::string& line : snapshot.attributions) std::printf("%s\n", line.c_str());
}

void print_profiles_table(const std::vector<ProfileAnswer>& answers) {
  const ProfileAnswer& first = answers.front();
  const Snapshot& snapshot = first.field->snapshot();
  std::printf("%s (%s, %.0f m of water), forecast issued %s from day %s%s\n",
              snapshot.site_name.c_str(), position_text(first.point).c_str(), first.water_depth_m,
              format_utc(snapshot.issued).c_str(), format_day(snapshot.day).c_str(),
              members_text(first).c_str());
  if (snapshot.degraded) std::printf("DEGRADED: %s\n", snapshot.headline.c_str());
  if (first.time_zone) std::printf("%-22s ", first.time_zone->name().c_str());
  std::printf("%-20s %8s %9s %6s %9s %9s\n", "UTC", "depth m", "speed m/s", "to deg", "east m/s",
              "north m/s");
  for (const ProfileAnswer& a : answers) {
    for (std::size_t i = 0; i < a.depth_m.size(); ++i) {
      const CurrentSample& s = a.samples[i];
      if (a.time_zone) std::printf("%-22s ", i == 0 ? a.time_zone->text(a.time).c_str() : "");
      std::printf("%-20s %8.1f", i == 0 ? format_utc(a.time).c_str() : "", a.depth_m[i]);
      if (has_value(s.status)) {
        std::printf(" %9.3f %6.0f %+9.3f %+9.3f%s\n", std::abs(s.velocity_m_s),
                    to_direction_deg(s.velocity_m_s), s.velocity_m_s.real(), s.velocity_m_s.imag(),
                    mark_of(s.status));
      } else {
        std::printf(" %9s\n", std::string(name_of(s.status)).c_str());
      }
    }
  }
  for (const std::string& line : snapshot.attributions) std::printf("%s\n", line.c_str());
}

}  // namespace slackwater::api
