#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

#include "api/cli/command.h"
#include "api/cli/profile_print.h"
#include "api/issued/in_force.h"
#include "api/program/paths.h"
#include "fields/base/text.h"
#include "fields/site/site.h"

namespace slackwater::api {
namespace {

struct ProfileArguments {
  std::string site;
  std::optional<double> latitude;
  std::optional<double> longitude;
  std::string time;
  std::vector<double> depths;
  bool csv = false;
  std::size_t member = 0;
  bool members = false;  ///< list them all
};

/// The geodesic to the column nearest to a point.
double nearest_column_m(const Field& field, const GeoPoint& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const ForecastColumn& column : field.snapshot().columns)
    nearest = std::min(nearest, distance_m(column.point, point));
  return nearest;
}

/// Forecasts of different sites may reach a place; the answer is that of the nearest site. Read
/// without members: most questions do not need them, and they are most of the file.
void choose_forecast(store::Store& store, const WantedForecast& wanted, ProfileAnswer& answer) {
  const std::vector<store::ForecastRow> rows = by_force(store, wanted);
  std::vector<store::ForecastRow> in_force;
  std::vector<std::shared_ptr<const Field>> fields;
  std::string reach;
  for (const store::ForecastRow& row : rows) {
    if (!in_force.empty() && in_force.back().site_id == row.site_id) continue;
    in_force.push_back(row);
    fields.push_back(read_field(store, row, ingest::Members::none));
    reach += " " + row.site_id + " (" + fields.back()->range().text() + ")";
  }
  const auto nearest =
      nearest_reaching(fields, answer.point.longitude_deg(), answer.point.latitude_deg());
  if (!nearest) {
    double away_m = std::numeric_limits<double>::infinity();
    for (const auto& field : fields)
      away_m = std::min(away_m, nearest_column_m(*field, answer.point));
    throw Error(ErrorKind::not_found,
                "no forecast reaches " + position_text(answer.point) +
                    formatted("; the nearest column lies {:.1f} km away, and", away_m / 1000) +
                    " the forecasts in force reach" + reach);
  }
  answer.row = in_force[*nearest];
  answer.field = fields[*nearest];
}

/// Reads the forecast again with its members where the question is about them.
void add_members(ProfileAnswer& answer, store::Store& store, const ProfileArguments& arguments) {
  const std::size_t members = answer.field->snapshot().members;
  if (arguments.member >= members) {
    const std::size_t last = members - 1;
    throw Error(ErrorKind::not_found,
                "found no member " + std::to_string(arguments.member) + "; this forecast has " +
                    (last == 0 ? "member 0, the central one, alone"
                               : "members 0 (the central one) to " + std::to_string(last)));
  }
  answer.member = arguments.member;
  if (arguments.member == 0 && !arguments.members) return;
  answer.field = read_field(store, answer.row, ingest::Members::all);
}

/// Samples the central forecast and what was asked for of the others.
void sample(ProfileAnswer& answer, bool all_members) {
  const auto of_member = [&](std::size_t member) {
    std::vector<CurrentSample> samples(answer.depth_m.size());
    answer.field->sample_profile(answer.point.longitude_deg(), answer.point.latitude_deg(),
                                 answer.time, answer.depth_m, samples, member);
    return samples;
  };
  answer.central = of_member(0);
  answer.samples = of_member(answer.member);
  if (!all_members) return;
  const std::size_t members = answer.field->snapshot().members;
  for (std::size_t m = 0; m < members; ++m) answer.members.push_back(of_member(m));
}

/// The forecast in force that covers the time, of the site or of the nearest site that reaches the
/// point; a site without a point is asked at its first column.
ProfileAnswer find_answer(store::Store& store, const ProfileArguments& arguments,
                          const Context& context) {
  ProfileAnswer answer;
  answer.time = option_value("--time", arguments.time, parse_utc);
  WantedForecast wanted;
  wanted.valid_at = answer.time;
  if (!arguments.site.empty())
    wanted.site_id = find_site(arguments.site, site_folders(context.store_folder)).id;
  answer.row = forecast_in_force(store, wanted);
  if (arguments.latitude) {
    answer.point = GeoPoint::from_degrees(*arguments.latitude, *arguments.longitude);
    choose_forecast(store, wanted, answer);
  } else {
    answer.field = read_field(store, answer.row, ingest::Members::none);
    answer.point = answer.field->snapshot().columns.front().point;
  }
  return answer;
}

/// The bed at the answer's place.
double bed_of(const ProfileAnswer& answer) {
  const Place place{answer.point.longitude_deg(), answer.point.latitude_deg(), 0, answer.time};
  BedSample bed;
  answer.field->sample_bed({&place, 1}, {&bed, 1});
  return bed.water_depth_m;
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
  if (arguments.members && !context.json)
    throw Error(ErrorKind::usage,
                "--members lists all members in --json only; --member N shows one");
  store::Store store = context.open(store::OpenMode::read_only);
  ProfileAnswer answer = find_answer(store, arguments, context);
  add_members(answer, store, arguments);
  answer.water_depth_m = bed_of(answer);
  answer.depth_m = arguments.depths;
  if (answer.depth_m.empty()) {
    for (const double depth : answer.field->snapshot().depth_m) {
      if (depth <= answer.water_depth_m) answer.depth_m.push_back(depth);
    }
  }
  sample(answer, arguments.members);
  if (context.json) {
    print_profile_json(answer);
  } else if (arguments.csv) {
    print_profile_csv(answer);
  } else {
    print_profile_table(answer);
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
  command
      ->add_option("--member", arguments->member,
                   "one member of the ensemble, 0 the central one (default: 0)")
      ->check(CLI::NonNegativeNumber);
  command->add_flag("--members", arguments->members, "list every member, with --json");
  command->callback([arguments, &context] { run_profile(*arguments, context); });
}

}  // namespace slackwater::api
