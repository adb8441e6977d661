#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/door/cli/command.h"
#include "api/door/cli/output_file.h"
#include "api/door/cli/sea/morning_of_forecast.h"
#include "api/door/morning/make_morning.h"
#include "api/pipeline/fetch/download_lines.h"
#include "api/pipeline/issue_forecast.h"
#include "api/pipeline/job_summary.h"
#include "api/program/paths.h"
#include "api/show/morning/verdict_json.h"
#include "api/show/morning/verified_text.h"
#include "api/show/report/forecast_page.h"
#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "fields/base/whole_file.h"
#include "fields/service/speed_quantiles.h"
#include "fields/service/wave_source.h"
#include "fields/wave/height_error.h"
#include "fields/wave/height_spread.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "ingest/copernicus/product_catalogue.h"

namespace slackwater::api {
namespace {

using nlohmann::json;
using std::chrono::days;

struct ForecastArguments {
  std::string site;
  std::string day;
  std::string horizon = "72h";
  std::string wind = "best";
  std::string out;
  bool hindsight = false;
  std::string html;
  std::optional<double> html_depth_m;
  std::optional<double> slack_below_m_s;
  bool print_downloads = false;
  std::string history;
  MorningAsked morning;
};

void print_calibration(const calibration::ColumnForecast& column) {
  if (column.calibration() == nullptr) {
    std::printf("  not calibrated: %s\n", column.calibration_problem.c_str());
    return;
  }
  const calibration::Calibration& c = *column.calibration();
  std::printf("Calibration: %s form, rms misfit %.3f m/s over %zu values. %s\n",
              std::string(name_of(c.form)).c_str(), c.rms_m_s, c.observations,
              c.termination.c_str());
  for (const calibration::Parameter& p : c.parameters) {
    const double low = p.is_logarithmic ? p.value * std::exp(-p.sigma) : p.value - p.sigma;
    const double high = p.is_logarithmic ? p.value * std::exp(p.sigma) : p.value + p.sigma;
    std::printf("  %-22s %11.5g %-6s (%.4g to %.4g)%s%s\n", p.name.c_str(), p.value, p.unit.c_str(),
                low, high, p.at_bound ? "  AT ITS BOUND" : "",
                p.weakly_determined ? "  weakly determined by this day" : "");
  }
  if (column.forms.size() > 1) {
    std::printf("  forms by evidence:");
    for (std::size_t f = 0; f < column.forms.size(); ++f) {
      std::printf(" %s %.0f%%", std::string(name_of(column.forms[f].form)).c_str(),
                  100 * column.form_weight[f]);
    }
    std::printf("\n");
  }
  for (const std::string& warning : c.warnings) std::printf("  warning: %s\n", warning.c_str());
  for (const std::string& note : column.notes) std::printf("  note: %s\n", note.c_str());
}

/// "forecast 80%, provider 20%".
std::string shares_text(const calibration::Blend& blend) {
  std::string text;
  for (const calibration::CandidateShare& share : blend.share) {
    if (share.weight <= 0) continue;
    text += (text.empty() ? "" : ", ") + std::string(name_of(share.method)) +
            formatted(" {:.0f}%", 100 * share.weight);
  }
  return text;
}

void print_blend(const calibration::DailyForecast& forecast) {
  if (!forecast.earned) return;
  const calibration::Earned& earned = *forecast.earned;
  std::printf("Issued: %s. %s\n", shares_text(earned.blend).c_str(),
              earned.blend.provenance.c_str());
  for (std::size_t day = 0; day < earned.later.size(); ++day) {
    std::printf("  %zu to %zu h: %s\n", 24 * (day + 1), 24 * (day + 2),
                shares_text(earned.later[day]).c_str());
  }
  if (earned.simulated_days > 0) {
    std::printf(
        "%zu of the rehearsed days have no stored wind run from that time: the later analysis with "
        "a random forecast error is used\n",
        earned.simulated_days);
  }
  std::printf("Spread times %.2f. %s\n", forecast.earned->spread.scale,
              forecast.earned->spread.provenance.c_str());
}

/// Where the waves come from, with what the headline does not say yet.
void print_waves(const calibration::DailyForecast& forecast, WindPolicy wind) {
  std::string text = wave_sources_text(forecast.snapshot);
  if (text.empty()) return;
  const auto& computed = forecast.computed_waves;
  if (computed && !calibration::is_degradation(*computed, wind))
    text += ": " + calibration::text_of(*computed);
  std::printf("Waves: %s.\n", text.c_str());
}

void print_days(const Snapshot& snapshot, const std::optional<TimeZone>& zone) {
  const ForecastColumn& column = snapshot.columns.front();
  const std::size_t levels = snapshot.depth_m.size();
  const std::vector<double> spread = height_spread_of(snapshot, column);
  if (zone) std::printf("%-22s ", zone->name().c_str());
  std::printf("%-22s %24s %7s %9s %23s %6s  %s\n", "UTC", "surface m/s (p10 to p90)", "to deg",
              "wind m/s", "Hs m (p10 to p90)", "Tp s", "waves");
  for (std::size_t t = 0; t < snapshot.time.size(); t += 3) {
    if (zone) std::printf("%-22s ", zone->text(snapshot.time[t]).c_str());
    std::printf("%-22s", format_utc(snapshot.time[t]).c_str());
    if (levels > 0 && has_value(column.current_status[t * levels])) {
      const Horizontal u = column.current_m_s[t * levels];
      const SpeedQuantiles speed =
          speed_quantiles(std::abs(u), column.current_sigma_m_s[t * levels]);
      std::printf(" %8.2f (%.2f to %.2f) %7.0f", speed.p50_m_s, speed.p10_m_s, speed.p90_m_s,
                  to_direction_deg(u));
    } else {
      std::printf(" %23s %7s", "-", "-");
    }
    if (t < column.wind_m_s.size()) {
      std::printf(" %9.1f", std::abs(column.wind_m_s[t]));
    } else {
      std::printf(" %9s", "-");
    }
    if (t < column.sea.size() && !std::isnan(column.sea[t].significant_height_m)) {
      const SeaState& sea = column.sea[t];
      const auto height_m = [&](double z) {
        return height_error::height_at(sea.significant_height_m, spread[t], z);
      };
      std::printf(" %7.2f (%.2f to %.2f)", sea.significant_height_m,
                  height_m(-constants::normal_p90), height_m(constants::normal_p90));
      if (sea.peak_period_s > 0) {
        std::printf(" %6.1f", sea.peak_period_s);
      } else {
        std::printf(" %6s", "-");  // calm water, or a height without a period
      }
      std::printf("  %s\n", std::string(wave_source_words(column.sea_source[t])).c_str());
    } else {
      std::printf(" %22s %6s\n", "-", "-");
    }
  }
}

void write_html(const ForecastArguments& arguments, const Context& context, const Site& site,
                const Issue& issue) {
  ForecastPage page =
      page_of(std::make_shared<const Snapshot>(issue.job.forecast.snapshot), site,
              {calibration::making_of(issue.job.forecast), issue.past}, made_by(context));
  page.depth_m = arguments.html_depth_m;
  page.slack_below_m_s = arguments.slack_below_m_s.value_or(page.slack_below_m_s);
  write_report(forecast_page(page), arguments.html);
}

/// Why what was made is no forecast that was issued, in words.
std::string why_a_hindcast(const calibration::ForecastOptions& options) {
  if (options.hindsight) return "it was made in hindsight";
  return "a forecast of this day or of a later one was issued before and stays in force; leave "
         "--day out for a forecast of the newest day";
}

json issue_json(const Issue& issue) {
  const Snapshot& snapshot = issue.job.forecast.snapshot;
  json out = job_summary(issue.job);
  out["id"] = issue.filed.id;
  out["already_issued"] = !issue.filed.is_new;
  out["origin"] = name_of(issue.origin);
  out["degraded"] = snapshot.degraded;
  out["headline"] = snapshot.headline;
  out["verified"] = verified_text(issue.past);
  out["verdict"] = verdict_json(issue.past.verdict);
  out["valid_from"] = format_utc(snapshot.time.front());
  out["valid_to"] = format_utc(snapshot.time.back());
  out["attributions"] = snapshot.attributions;
  return out;
}

void print_issue(const Site& site, const Issue& issue,
                 const calibration::ForecastOptions& options) {
  const calibration::DailyForecast& forecast = issue.job.forecast;
  const Snapshot& snapshot = forecast.snapshot;
  const auto id = static_cast<long long>(issue.filed.id);
  std::printf("%s, issued %s: forecast %lld for %s to %s\n", site.name.c_str(),
              format_utc(snapshot.issued).c_str(), id, format_utc(snapshot.time.front()).c_str(),
              format_utc(snapshot.time.back()).c_str());
  if (!issue.filed.is_new)
    std::printf("already issued as %lld: the same inputs and options at the same time\n", id);
  if (issue.origin == ForecastOrigin::hindcast)
    std::printf("filed as a hindcast: %s\n", why_a_hindcast(options).c_str());
  std::printf("%s%s\n%s\n", snapshot.degraded ? "DEGRADED: " : "", snapshot.headline.c_str(),
              verified_text(issue.past).c_str());
  print_calibration(forecast.columns.front());
  print_blend(forecast);
  if (snapshot.columns.size() > 1)
    std::printf("  … and %zu more columns\n", snapshot.columns.size() - 1);
  print_waves(forecast, options.wind);
  for (const SourceUse& use : forecast.columns.front().sources)
    std::printf("from %s\n", text_of(use).c_str());
  print_days(snapshot, site.time_zone);
  for (const std::string& line : snapshot.attributions) std::printf("%s\n", line.c_str());
}

void print_downloads(const ForecastArguments& arguments, const Context& context, const Site& site,
                     const calibration::ForecastOptions& options) {
  const auto products =
      ingest::ProductCatalogue::load(data_folder() / "products", own_product_folders());
  WantedTimes wanted{options.day.value_or(day_of(options.issued) - days(1)), options.issued,
                     options.horizon};
  if (!arguments.history.empty()) wanted.history = history_from(arguments.history);
  const auto lines = download_lines(products, site, wanted);
  if (context.json) {
    std::printf(
        "%s\n",
        json{{"site", site.id}, {"day", format_day(wanted.day)}, {"lines", lines}}.dump(2).c_str());
    return;
  }
  for (const std::string& line : lines) std::printf("%s\n", line.c_str());
}

void run_forecast(const ForecastArguments& arguments, const Context& context) {
  const Site site = find_site(arguments.site, site_folders(context.store_folder));
  calibration::ForecastOptions options;
  options.issued = context.now();
  options.seen_by = options.issued;
  options.horizon = horizon_from(arguments.horizon);
  options.wind = option_value("--wind", arguments.wind, wind_policy_from);
  options.hindsight = arguments.hindsight;
  if (options.hindsight && options.wind != WindPolicy::best) {
    throw Error(ErrorKind::usage, "found --hindsight with --wind " + arguments.wind +
                                      ", expected it only with --wind best: the other policies "
                                      "never use later data; leave one of the two out");
  }
  if (!arguments.day.empty()) options.day = option_value("--day", arguments.day, parse_day);
  if (!arguments.history.empty() && !arguments.print_downloads) {
    throw Error(ErrorKind::usage,
                "found --history without --print-downloads; it says how long a past to fetch, and "
                "a forecast uses all that is stored: add --print-downloads, or leave it out");
  }
  if (arguments.print_downloads) return print_downloads(arguments, context, site, options);
  // A job for a past day without --at is issued when that day ends at the earliest.
  if (options.day && UtcTime(*options.day) + days(1) > options.issued) {
    throw Error(ErrorKind::usage, "day D " + arguments.day + " has not ended at " +
                                      format_utc(options.issued) +
                                      "; give an earlier --day, or --at");
  }
  expect_output("--out", arguments.out, {".nc"});
  expect_output("--html", arguments.html, {".html"});
  expect_readable(arguments.morning);
  if (arguments.html.empty() && (arguments.html_depth_m || arguments.slack_below_m_s)) {
    throw Error(ErrorKind::usage,
                std::string("found ") +
                    (arguments.html_depth_m ? "--html-depth" : "--slack-below") +
                    " without --html; it is an option of that page: add --html FILE.html");
  }
  store::Store store = context.open(store::OpenMode::create_or_write);
  const Issue issue = issue_forecast(store, site, options, [&](const Snapshot& made) {
    if (!arguments.html.empty()) static_cast<void>(page_depth_m(made, arguments.html_depth_m));
  });
  const Snapshot& snapshot = issue.job.forecast.snapshot;
  if (!arguments.out.empty()) {
    write_beside(arguments.out, [&](const std::filesystem::path& partial) {
      ingest::write_forecast(partial, snapshot);
    });
  }
  if (!arguments.html.empty()) write_html(arguments, context, site, issue);
  const auto morning_now = [&] {
    MorningAsked asked = arguments.morning;
    asked.site = arguments.site;
    const MorningDone done = morning_of_forecast(store, site, issue, asked, context);
    std::fputs(done.notes.c_str(), stderr);
    return done;
  };
  if (context.json) {
    json out = issue_json(issue);
    out["morning"] = morning_now().json;
    std::printf("%s\n", out.dump(2, ' ', false, json::error_handler_t::replace).c_str());
    return;
  }
  print_issue(site, issue, options);
  std::fflush(stdout);  // the forecast is read while what it means for the tasks is worked out
  const MorningDone morning = morning_now();
  if (!morning.text.empty()) std::printf("\n%s", morning.text.c_str());
}

}  // namespace

void add_forecast(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<ForecastArguments>();
  CLI::App* command = app.add_subcommand(
      "forecast", "The daily job: calibrate on day D, forecast to the horizon, store as issued");
  command->add_option("--site", arguments->site, "id of data/sites, or path of a site's YAML file")
      ->required();
  command->add_option("--day", arguments->day,
                      "day D, e.g. 2025-03-09 (default: the newest whole day in the store)");
  command->add_option("--horizon", arguments->horizon, "how far beyond the end of D (default 72h)");
  command->add_option("--wind", arguments->wind,
                      "best | forecast | persist: where tomorrow's wind comes from (default best)");
  command->add_flag("--hindsight", arguments->hindsight,
                    "with --at in the past and --wind best: also use wind and waves that were not "
                    "known then; the forecast is marked");
  command->add_option("--out", arguments->out, "also write the forecast as FILE.nc (CF NetCDF)");
  command->add_option("--html", arguments->html,
                      "also write a page for people: slack times, current, wind and waves with "
                      "their bands; one file, opens offline");
  command->add_option("--html-depth", arguments->html_depth_m,
                      "depth that the page opens with, m below mean sea level (default 10)");
  command
      ->add_option("--slack-below", arguments->slack_below_m_s,
                   "the page calls the current slack below this speed, m/s (default 0.5)")
      ->check(CLI::Range(0.01, 5.0));
  command->add_option("--fly", arguments->morning.fly,
                      "of a site that lists tasks: fly the starts that the limits leave open, for "
                      "so long at most, e.g. 15min");
  command->add_flag("--pdf", arguments->morning.is_pdf,
                    "of a site that lists tasks: print the morning report too (with Chromium)");
  command->add_option("--at", context.at,
                      "issue time, e.g. 2025-03-10T05:00:00Z (default: the clock)");
  command->add_flag(
      "--print-downloads", arguments->print_downloads,
      "print the lines that fetch what this forecast wants (copernicusmarine, curl), and stop");
  command->add_option("--history", arguments->history,
                      "with --print-downloads: how long before day D to fetch, e.g. 60d (default "
                      "3d)");
  command->callback([arguments, &context] { run_forecast(*arguments, context); });
}

}  // namespace slackwater::api
