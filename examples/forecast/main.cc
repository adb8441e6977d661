// forecast [--as-analysis] LATITUDE LONGITUDE DAY TIME FILE…: a forecast without a store. Reads the
// product files, fits DAY and forecasts the day after it as of the end of DAY; prints what it is
// made of, the current over depth at TIME and, where the files hold the day after, how well it did.
#include <charconv>
#include <chrono>
#include <cstdio>
#include <string>
#include <string_view>

#include "calibration/day/daily_forecast.h"
#include "calibration/verify/score_forecast.h"
#include "fields/base/error.h"
#include "fields/service/field.h"
#include "ingest/read_pieces.h"

namespace {

using namespace slackwater;
constexpr std::chrono::hours horizon{24};

double degrees(std::string_view text) {
  double value = 0;
  const auto [stop, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem == std::errc{} && stop == text.data() + text.size()) return value;
  throw Error(ErrorKind::usage, "found '" + std::string(text) + "', expected degrees, e.g. 48.85");
}

SiteData read(const Site& site, UtcDay day, std::span<const ingest::FileToRead> files) {
  const UtcTime end = UtcTime(day) + std::chrono::days(1);
  ingest::ReadPieces read =
      ingest::read_pieces(files, ingest::ProductCatalogue::load(PRODUCTS), site,
                          UtcTime(day) - calibration::history_wanted, end + horizon);
  for (const std::string& warning : read.warnings)
    std::fprintf(stderr, "warning: %s\n", warning.c_str());
  return site_data_of(site, std::move(read.pieces));
}

void print_weights(const calibration::Earned& earned) {
  std::printf("Issued:");
  for (const calibration::CandidateShare& share : earned.blend.share)
    if (share.weight > 0)
      std::printf(" %s %.0f%%", name_of(share.method).data(), 100 * share.weight);
  std::printf(". %s\nSpread times %.2f. %s\n", earned.blend.provenance.c_str(), earned.spread.scale,
              earned.spread.provenance.c_str());
}

void print_profile(const Snapshot& snapshot, const GeoPoint& point, UtcTime time) {
  const Field field(std::make_shared<const Snapshot>(snapshot));
  for (const double depth_m : snapshot.depth_m) {
    const CurrentSample at =
        field.current({point.longitude_deg(), point.latitude_deg(), depth_m, time});
    if (!has_value(at.status)) {
      std::printf("%8g m  %s; valid: %s\n", depth_m, name_of(at.status).data(),
                  field.range().text().c_str());
      continue;
    }
    const CurrentQuantiles q = quantiles_of(at);
    std::printf("%8g m  east %+.4f (%+.4f to %+.4f)  north %+.4f (%+.4f to %+.4f) m/s\n", depth_m,
                at.velocity_m_s.real(), q.p10_m_s.real(), q.p90_m_s.real(), at.velocity_m_s.imag(),
                q.p10_m_s.imag(), q.p90_m_s.imag());
  }
}

void print_score(const SiteData& data, const calibration::DailyForecast& forecast) {
  calibration::VerifyOptions options;
  options.bands = {{0, calibration::whole_column_m}};
  options.leads = {{0, 24}};
  options.by_hour = false;
  const calibration::ForecastSkill skill =
      calibration::score_forecast(data, forecast.snapshot, {forecast.plan.dataset}, options);
  for (const calibration::SkillEntry& entry : skill.entries) {
    if (entry.variable == "sea_water_velocity" &&
        (entry.method == calibration::Method::forecast ||
         entry.method == calibration::Method::persistence))
      std::printf("%s is off by %.4f m/s\n", name_of(entry.method).data(), entry.vector.rmse_m_s);
  }
}

}  // namespace

int main(int argc, char** argv) try {
  ingest::IngestOptions options;
  if (argc > 1 && std::string_view(argv[1]) == "--as-analysis") {
    options.as = DataStatus::analysis;  // files lie about this: see ingest --as
    --argc, ++argv;
  }
  if (argc < 6) {
    std::fputs("usage: forecast [--as-analysis] LATITUDE LONGITUDE DAY TIME FILE…\n", stderr);
    return 2;
  }
  Site site;
  site.id = site.name = "here";
  site.point = GeoPoint::from_degrees(degrees(argv[1]), degrees(argv[2]));
  calibration::ForecastOptions job;
  job.day = parse_day(argv[3]);
  job.issued = UtcTime(*job.day) + std::chrono::days(1);
  job.horizon = horizon;
  std::vector<ingest::FileToRead> files;
  for (int i = 5; i < argc; ++i) files.push_back({argv[i], options});

  const SiteData data = read(site, *job.day, files);
  calibration::RehearsedDays rehearsals(data);  // kept for further days of these data
  job.rehearsals = &rehearsals;
  const calibration::DailyForecast forecast = calibration::make_forecast(data, job);
  std::printf("%s\n", forecast.snapshot.headline.c_str());
  if (forecast.earned) print_weights(*forecast.earned);
  print_profile(forecast.snapshot, site.point, parse_utc(argv[4]));
  print_score(data, forecast);
  for (const std::string& line : forecast.snapshot.attributions) std::printf("%s\n", line.c_str());
} catch (const slackwater::Error& problem) {
  std::fprintf(stderr, "forecast: %s\n", problem.what());
  return 1 + static_cast<int>(problem.kind());  // the exit codes of the program
} catch (const std::exception& problem) {
  return std::fprintf(stderr, "forecast: %s\n", problem.what()), 1;
}
