#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

#include "api/door/cli/command.h"
#include "api/door/cli/sea/profile_print.h"
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
  std::string from;
  std::string to;
  std::string step = "1h";
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

std::string passed_over_text(const std::string& damage) {
  return damage + "; an older forecast is used";
}

/// Forecasts of different sites may reach a place; the answer is that of the nearest column. Read
/// without members: most questions do not need them, and they are most of the file.
void choose_forecast(store::Store& store, const WantedForecast& wanted, ProfileAnswer& answer) {
  const std::vector<store::ForecastRow> rows = by_force(store, wanted);
  std::vector<store::ForecastRow> in_force;
  std::vector<std::shared_ptr<const Field>> fields;
  std::vector<std::pair<std::string, std::string>> damaged;  // by site
  std::string reach;
  for (const store::ForecastRow& row : rows) {
    if (!in_force.empty() && in_force.back().site_id == row.site_id) continue;
    if (auto damage = damage_of(store, row)) {
      damaged.emplace_back(row.site_id, std::move(*damage));
      continue;
    }
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
    throw Error(
        ErrorKind::not_found,
        "no forecast reaches " + position_text(answer.point) +
            formatted("; the nearest column lies {:.1f} km away, and", away_m / 1000) +
            " the forecasts in force reach" + reach +
            (nearest_reaching(fields, answer.point.latitude_deg(), answer.point.longitude_deg())
                 ? "; did you swap --lat and --lon?"
                 : ""));
  }
  answer.row = in_force[*nearest];
  answer.field = fields[*nearest];
  for (const auto& [site, damage] : damaged) {
    const auto is_of_site = [&id = site](const auto& row) { return row.site_id == id; };
    const bool has_whole_one = std::any_of(in_force.begin(), in_force.end(), is_of_site);
    if (site == answer.row.site_id) answer.notes.push_back(passed_over_text(damage));
    if (!has_whole_one) answer.notes.push_back(damage + "; its site cannot answer");
  }
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
                          const Context& context, UtcTime time) {
  ProfileAnswer answer;
  answer.time = time;
  WantedForecast wanted;
  wanted.valid_at = answer.time;
  if (!arguments.site.empty()) {
    const Site site = find_site(arguments.site, site_folders(context.store_folder));
    wanted.site_id = site.id;
    answer.time_zone = site.time_zone;
    answer.chart_datum = site.chart_datum;
  }
  InForce in_force = forecast_in_force(store, wanted);
  answer.row = std::move(in_force.row);
  if (arguments.latitude) {
    answer.point = GeoPoint::from_degrees(*arguments.latitude, *arguments.longitude);
    choose_forecast(store, wanted, answer);
  } else {
    for (const std::string& damage : in_force.passed_over)
      answer.notes.push_back(passed_over_text(damage));
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

/// A range may ask for as many times as an hour a minute; more is a file's work (`sample`).
constexpr std::size_t most_times = 2000;

/// The times that are asked for: one, or a range with both ends.
std::vector<UtcTime> times_of(const ProfileArguments& arguments, const Context& context) {
  if (!arguments.time.empty()) {
    if (!arguments.from.empty() || !arguments.to.empty())
      throw Error(ErrorKind::usage, "give --time, or --from and --to, not both");
    return {context.time_of("--time", arguments.time)};
  }
  if (arguments.from.empty() || arguments.to.empty())
    throw Error(ErrorKind::usage, "give --time T (or --time now), or a range: --from T --to T");
  const UtcTime from = context.time_of("--from", arguments.from);
  const UtcTime to = context.time_of("--to", arguments.to);
  const Duration step = option_value("--step", arguments.step, parse_duration);
  if (to < from) throw Error(ErrorKind::usage, "--from is later than --to");
  if (step < std::chrono::minutes(1))
    throw Error(ErrorKind::usage, "found --step " + arguments.step + ", expected 1min or more");
  if ((to - from) / step >= static_cast<Duration::rep>(most_times)) {
    throw Error(
        ErrorKind::usage,
        "found more than " + std::to_string(most_times) +
            " times between --from and --to; give a longer --step, or use `slackwater sample`");
  }
  std::vector<UtcTime> times;
  for (UtcTime time = from; time <= to; time += step) times.push_back(time);
  return times;
}

/// One forecast answers the whole range: a table of two forecasts would jump between them.
void expect_covers(const store::ForecastRow& row, UtcTime last) {
  if (last <= row.valid_to) return;
  throw Error(ErrorKind::not_found, "the forecast in force at the beginning is valid from " +
                                        format_utc(row.valid_from) + " to " +
                                        format_utc(row.valid_to) + "; give a --to in it");
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
  const std::vector<UtcTime> times = times_of(arguments, context);
  store::Store store = context.open(store::OpenMode::read_only);
  ProfileAnswer answer = find_answer(store, arguments, context, times.front());
  expect_covers(answer.row, times.back());
  add_members(answer, store, arguments);
  answer.water_depth_m = bed_of(answer);
  answer.depth_m = arguments.depths;
  if (answer.depth_m.empty()) {
    for (const double depth : answer.field->snapshot().depth_m) {
      if (depth <= answer.water_depth_m) answer.depth_m.push_back(depth);
    }
  }
  std::vector<ProfileAnswer> answers;
  for (const UtcTime time : times) {
    answers.push_back(answer);
    answers.back().time = time;
    sample(answers.back(), arguments.members);
  }
  const bool is_range = arguments.time.empty();
  if (context.json) {
    is_range ? print_profiles_json(answers) : print_profile_json(answers.front());
  } else if (arguments.csv) {
    print_profiles_csv(answers);
  } else {
    is_range ? print_profiles_table(answers) : print_profile_table(answers.front());
  }
}

}  // namespace

void add_profile(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<ProfileArguments>();
  CLI::App* command = app.add_subcommand(
      "profile",
      "The current profile at a place and time, or over a range of times, with quantiles");
  command->add_option("--site", arguments->site, "id of data/sites, or path of a site's YAML file");
  command->add_option("--lat", arguments->latitude, "latitude, degrees north")
      ->check(CLI::Range(-90.0, 90.0));
  command->add_option("--lon", arguments->longitude, "longitude, degrees east")
      ->check(CLI::Range(-360.0, 360.0));
  command->add_option("--time", arguments->time, "e.g. 2025-03-10T06:00:00Z, or now");
  command->add_option("--from", arguments->from, "a range of times instead: its first");
  command->add_option("--to", arguments->to, "its last");
  command->add_option("--step", arguments->step, "between its times (default 1h)");
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
