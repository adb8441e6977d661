#include "api/door/morning/make_morning.h"

#include <algorithm>
#include <chrono>

#include "api/pipeline/filed_making.h"
#include "api/pipeline/load_site_data.h"
#include "api/show/morning/morning_page.h"
#include "api/show/morning/verified_text.h"
#include "calibration/day/daily_forecast.h"
#include "data/store/store.h"
#include "fields/base/attempt.h"

namespace slackwater::api {
namespace {

using std::chrono::days;

/// The row of the forecast that a morning rests on; nothing where it is a file's.
std::optional<store::ForecastRow> row_of(store::Store& store, const Morning& morning) {
  store::ForecastQuery query;
  query.site_id = morning.windows.site_id;
  for (store::ForecastRow& row : store.find_forecasts(query))
    if (row.content_sha256 == morning.windows.water.forecast_sha256) return std::move(row);
  return std::nullopt;
}

void write(const MadeMorning& made, const Site& site, const std::string& generated) {
  const Field& field = *made.morning.windows.water.surround.field;
  ForecastPage page =
      page_of(std::make_shared<const Snapshot>(field.snapshot()), site, made.known, generated);
  page.about = day_of(made.morning.windows.from);
  write_report(morning_page(made.morning, page), made.html);
}

}  // namespace

KnownForecast known_of(const Morning& morning, const Site& site,
                       const std::filesystem::path& store_folder) {
  KnownForecast known;
  known.past.not_verified =
      "past forecasts of this site were not checked: this forecast comes from a file";
  if (!morning.question.windows.forecast.empty()) return known;
  store::Store store = store::Store::open(store_folder, store::OpenMode::read_only);
  const auto row = row_of(store, morning);
  if (!row) return known;
  known.making = filed_making(row->summary_json);
  const Snapshot& snapshot = morning.windows.water.surround.field->snapshot();
  const auto failure = attempt([&] {
    const SiteData data =
        load_site_data(store, site, UtcTime(snapshot.day) - days(14) - calibration::history_wanted,
                       snapshot.issued);
    known.past =
        verify_past(store, site, data, snapshot, snapshot.wind_policy.value_or(WindPolicy::best));
  });
  if (failure) known.past.not_verified = "Not verified: " + failure->why;
  return known;
}

ForecastPage page_of(std::shared_ptr<const Snapshot> forecast, const Site& site,
                     const KnownForecast& known, const std::string& generated) {
  ForecastPage page;
  page.forecast = std::move(forecast);
  page.making = known.making;
  page.time_zone = site.time_zone;
  page.chart_datum = site.chart_datum;
  page.verified = verified_text(known.past);
  page.skill = known.past.entries;
  page.skill_note =
      "Root mean square vector error of the forecasts of the last two weeks whose truth is in, all "
      "levels; lower is better, pairs of days weigh the same. A baseline \"in part\" has fewer "
      "days or values than the forecast, whose error over the same ones stands beside it. "
      "oracle-mean knows the day itself: a yardstick, not a forecast.";
  page.generated = generated;
  return page;
}

std::filesystem::path reports_folder(const std::filesystem::path& store_folder,
                                     const std::string& site_id) {
  return store_folder / "reports" / site_id;
}

MadeMorning make_morning(const MakeMorning& how, const Site& site,
                         const std::filesystem::path& store_folder) {
  MadeMorning made;
  made.morning = morning_of(how.question, store_folder);
  made.known = how.known ? *how.known : known_of(made.morning, site, store_folder);
  made.html = !how.html.empty()
                  ? how.html
                  : reports_folder(store_folder, site.id) /
                        (format_day(day_of(made.morning.windows.from)) + how.page_mark + ".html");
  write(made, site, how.generated);
  if (!how.fly) return made;
  if (how.on_first_page) how.on_first_page(made);
  Morning flown = made.morning;
  const auto failure = attempt([&] {
    FlyWindows fly = *how.fly;
    fly.with_advice = true;
    if (flown.today) {  // half of the time at most, and first
      const auto begun = std::chrono::steady_clock::now();
      FlyWindows half = fly;
      half.most_wall_s /= 2;
      if (const auto grounded = attempt([&] {
            fly_windows(today_of(flown).question.windows, half, store_folder, *flown.today,
                        how.on_progress);
          }))
        flown.windows.notes.push_back("nothing was flown for today: " + grounded->why);
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
      fly.most_wall_s = std::max(0.5 * fly.most_wall_s, fly.most_wall_s - took.count());
    }
    fly_windows(flown.question.windows, fly, store_folder, flown.windows, how.on_progress);
    plan_anew(flown, store_folder);
  });
  if (failure)
    made.morning.windows.notes.push_back("nothing was flown: " + failure->why);
  else
    made.morning = std::move(flown);
  write(made, site, how.generated);
  return made;
}

}  // namespace slackwater::api
