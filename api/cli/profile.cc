#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/cli/command.h"
#include "api/pipeline/paths.h"
#include "api/pipeline/site.h"
#include "fields/service/snapshot.h"
#include "ingest/cf/forecast_file.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

struct ProfileArguments {
  std::string site;
  std::optional<double> latitude;
  std::optional<double> longitude;
  std::string time;
  std::vector<double> depths;
  bool csv = false;
};

/// A point within this distance of a forecast column is answered by that column.
constexpr double column_reach_m = 5000.0;
constexpr double normal_p90 = 1.2815515655446004;

struct Answer {
  store::ForecastRow row;
  Snapshot snapshot;
  std::size_t column = 0;
  UtcTime time;
  std::vector<double> depth_m;
  std::vector<CurrentSample> samples;
};

std::size_t nearest_column(const Snapshot& snapshot, const GeoPoint& point, double& distance) {
  std::size_t best = 0;
  distance = distance_m(snapshot.columns[0].point, point);
  for (std::size_t i = 1; i < snapshot.columns.size(); ++i) {
    const double d = distance_m(snapshot.columns[i].point, point);
    if (d < distance) {
      distance = d;
      best = i;
    }
  }
  return best;
}

Snapshot read(store::Store& store, const store::ForecastRow& row) {
  return ingest::read_forecast(store.content_path(row.content_sha256));
}

/// The newest forecast that covers the time, of the site or of whichever site has a column near the
/// point.
Answer find_answer(store::Store& store, const ProfileArguments& arguments, const Context& context) {
  Answer answer;
  answer.time = option_value("--time", arguments.time, parse_utc);
  store::ForecastQuery query;
  std::optional<GeoPoint> point;
  if (!arguments.site.empty()) {
    const Site site = find_site(arguments.site, site_folders(context.store_folder));
    query.site_id = site.id;
    if (arguments.latitude)
      point = GeoPoint::from_degrees(*arguments.latitude, *arguments.longitude);
  } else {
    point = GeoPoint::from_degrees(*arguments.latitude, *arguments.longitude);
  }
  std::vector<store::ForecastRow> rows = store.find_forecasts(query);
  std::reverse(rows.begin(), rows.end());  // newest day, then latest issue, first
  if (rows.empty()) {
    throw Error(ErrorKind::not_found,
                "found no issued forecast" +
                    (query.site_id.empty() ? std::string() : " for site " + query.site_id) +
                    "; run `slackwater forecast` first");
  }
  const auto covers = [&](const store::ForecastRow& row) {
    return answer.time >= row.valid_from && answer.time <= row.valid_to;
  };
  double nearest_m = 1e12;
  for (const store::ForecastRow& row : rows) {
    if (!covers(row)) continue;
    Snapshot snapshot = read(store, row);
    double distance = 0;
    std::size_t column = 0;
    if (point) {
      column = nearest_column(snapshot, *point, distance);
      nearest_m = std::min(nearest_m, distance);
      if (distance > column_reach_m) continue;
    }
    answer.row = row;
    answer.snapshot = std::move(snapshot);
    answer.column = column;
    return answer;
  }
  if (nearest_m < 1e12) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "the nearest forecast column lies %.1f km away; forecasts answer within %.0f km",
                  nearest_m / 1000, column_reach_m / 1000);
    throw Error(ErrorKind::not_found, text);
  }
  throw Error(ErrorKind::not_found,
              "no forecast covers " + arguments.time + "; the newest one is valid from " +
                  format_utc(rows.front().valid_from) + " to " + format_utc(rows.front().valid_to));
}

json to_json(const Answer& a) {
  const ForecastColumn& column = a.snapshot.columns[a.column];
  json levels = json::array();
  for (std::size_t i = 0; i < a.depth_m.size(); ++i) {
    const CurrentSample& s = a.samples[i];
    json level = {{"depth_m", a.depth_m[i]}, {"status", std::string(name_of(s.status))}};
    if (has_value(s.status)) {
      const double u = s.velocity_m_s.real();
      const double v = s.velocity_m_s.imag();
      const double spread = normal_p90 * s.sigma_m_s;
      level["eastward_sea_water_velocity"] = {
          {"value", u}, {"p10", u - spread}, {"p50", u}, {"p90", u + spread}};
      level["northward_sea_water_velocity"] = {
          {"value", v}, {"p10", v - spread}, {"p50", v}, {"p90", v + spread}};
      level["sea_water_speed"] = std::abs(s.velocity_m_s);
      level["sea_water_velocity_to_direction"] = to_direction_deg(s.velocity_m_s);
    }
    levels.push_back(std::move(level));
  }
  return {{"site", a.snapshot.site_id},
          {"latitude_deg", column.point.latitude_deg()},
          {"longitude_deg", column.point.longitude_deg()},
          {"time", format_utc(a.time)},
          {"issued", format_utc(a.snapshot.issued)},
          {"day", format_day(a.snapshot.day)},
          {"wind", a.snapshot.wind_policy},
          {"origin", a.row.origin},
          {"degraded", a.snapshot.degraded},
          {"contains_stokes", a.snapshot.contains_stokes},
          {"headline", a.snapshot.headline},
          {"water_depth_m", column.water_depth_m},
          {"units",
           {{"velocity", "m s-1"}, {"direction", "degree, towards, clockwise from true north"}}},
          {"levels", levels},
          {"attributions", a.snapshot.attributions},
          {"provenance", json::parse(a.snapshot.provenance_json, nullptr, false)}};
}

void print_csv(const Answer& a) {
  std::printf(
      "time,depth_m,east_m_s,east_p10_m_s,east_p90_m_s,north_m_s,north_p10_m_s,north_p90_m_s,speed_"
      "m_s,"
      "to_direction_deg,status\n");
  for (std::size_t i = 0; i < a.depth_m.size(); ++i) {
    const CurrentSample& s = a.samples[i];
    std::printf("%s,%g,", format_utc(a.time).c_str(), a.depth_m[i]);
    if (has_value(s.status)) {
      const double spread = normal_p90 * s.sigma_m_s;
      const double u = s.velocity_m_s.real();
      const double v = s.velocity_m_s.imag();
      std::printf("%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.1f,", u, u - spread, u + spread, v,
                  v - spread, v + spread, std::abs(s.velocity_m_s),
                  to_direction_deg(s.velocity_m_s));
    } else {
      std::printf(",,,,,,,,");
    }
    std::printf("%s\n", std::string(name_of(s.status)).c_str());
  }
}

void print_table(const Answer& a) {
  const ForecastColumn& column = a.snapshot.columns[a.column];
  std::printf("%s at %s (%.4f N %.4f E, %.0f m of water), forecast issued %s from day %s\n",
              a.snapshot.site_name.c_str(), format_utc(a.time).c_str(), column.point.latitude_deg(),
              column.point.longitude_deg(), column.water_depth_m,
              format_utc(a.snapshot.issued).c_str(), format_day(a.snapshot.day).c_str());
  if (a.snapshot.degraded) std::printf("DEGRADED: %s\n", a.snapshot.headline.c_str());
  std::printf("%8s %9s %9s %24s %24s\n", "depth m", "speed m/s", "to deg", "east m/s (p10 to p90)",
              "north m/s (p10 to p90)");
  for (std::size_t i = 0; i < a.depth_m.size(); ++i) {
    const CurrentSample& s = a.samples[i];
    if (!has_value(s.status)) {
      std::printf("%8.1f %9s\n", a.depth_m[i], std::string(name_of(s.status)).c_str());
      continue;
    }
    const double spread = normal_p90 * s.sigma_m_s;
    const double u = s.velocity_m_s.real();
    const double v = s.velocity_m_s.imag();
    std::printf("%8.1f %9.3f %9.0f  %+7.3f (%+.3f to %+.3f) %+7.3f (%+.3f to %+.3f)\n",
                a.depth_m[i], std::abs(s.velocity_m_s), to_direction_deg(s.velocity_m_s), u,
                u - spread, u + spread, v, v - spread, v + spread);
  }
  for (const std::string& line : a.snapshot.attributions) std::printf("%s\n", line.c_str());
}

void run_profile(const ProfileArguments& arguments, const Context& context) {
  if (arguments.site.empty() && !arguments.latitude) {
    throw Error(ErrorKind::usage, "give --site, or --lat and --lon");
  }
  if (arguments.latitude.has_value() != arguments.longitude.has_value()) {
    throw Error(ErrorKind::usage, "--lat and --lon go together");
  }
  for (const double depth : arguments.depths) {
    if (!std::isfinite(depth))
      throw Error(ErrorKind::usage, "--depth: expected metres below mean sea level");
  }
  if (arguments.csv && context.json)
    throw Error(ErrorKind::usage, "give --csv or --json, not both");
  store::Store store = context.open(store::OpenMode::read_only);
  Answer answer = find_answer(store, arguments, context);
  const ForecastColumn& column = answer.snapshot.columns[answer.column];
  answer.depth_m = arguments.depths;
  if (answer.depth_m.empty()) {
    for (const double depth : answer.snapshot.depth_m) {
      if (depth <= column.water_depth_m) answer.depth_m.push_back(depth);
    }
  }
  answer.samples.resize(answer.depth_m.size());
  sample_profile(answer.snapshot, answer.column, answer.time, answer.depth_m, answer.samples);
  if (context.json) {
    std::printf("%s\n",
                to_json(answer).dump(2, ' ', false, json::error_handler_t::replace).c_str());
  } else if (arguments.csv) {
    print_csv(answer);
  } else {
    print_table(answer);
  }
}

}  // namespace

void add_profile(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<ProfileArguments>();
  CLI::App* command =
      app.add_subcommand("profile", "The current profile at a place and time, with quantiles");
  command->add_option("--site", arguments->site, "id of data/sites, or path of a site's YAML file");
  command->add_option("--lat", arguments->latitude, "latitude, degrees north")
      ->check(CLI::Range(-90.0, 90.0));
  command->add_option("--lon", arguments->longitude, "longitude, degrees east")
      ->check(CLI::Range(-360.0, 360.0));
  command->add_option("--time", arguments->time, "e.g. 2025-03-10T06:00:00Z")->required();
  command
      ->add_option("--depth", arguments->depths,
                   "depths in metres below mean sea level (default: native levels)")
      ->delimiter(',');
  command->add_flag("--csv", arguments->csv, "comma-separated values");
  command->callback([arguments, &context] { run_profile(*arguments, context); });
}

}  // namespace slackwater::api
