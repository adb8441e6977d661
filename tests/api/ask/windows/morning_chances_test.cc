// The probabilities of `windows` beside what came, morning after morning, on oceans whose forecasts
// err otherwise than any generator of the product: run by `make soak`.
#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "api/ask/windows/windows.h"
#include "api/pipeline/past_mornings.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "tests/api/ask/windows/weather_at_a_site.h"
#include "tests/support/asked_number.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/twin/risk/said_and_came.h"

namespace slackwater::tests::morning_chances_test {
namespace {

const std::vector<std::string> tasks{"access_window", "blade_scan", "cp_anode", "scour_survey"};
/// A site has past mornings before its chances are looked at.
constexpr std::size_t first_mornings = 7;

/// What was said of a task's starts, one a morning, with what past mornings made of it and without.
struct TaskDays {
  std::vector<Day> calibrated;
  std::vector<Day> by_futures;
};
using Said = std::map<std::string, TaskDays>;

api::WindowsAnswer answer_in(const ForecastMornings& site, std::shared_ptr<const Snapshot> water,
                             bool is_what_came) {
  api::WindowsQuestion question;
  question.site = site.site.id;
  question.tasks = tasks;
  question.practice = api::AlphaPractice::of_tables({});
  question.water = api::water_of(std::move(water), {});
  question.chances_as_futures_say = question.waves_as_forecast = is_what_came;
  question.may_leave_out = true;
  question.threads = 2;
  return api::windows_of(question, site.store);
}

/// Adds a morning of a site.
void add(const ForecastMornings& site, const api::PastMorning& morning, Said& all) {
  const api::WindowsAnswer said = answer_in(site, morning.forecast, false);
  const api::WindowsAnswer came = answer_in(site, morning.came, true);
  for (const api::TaskWindows& task : said.tasks) {
    std::map<UtcTime, bool> held;
    for (const api::TaskWindows& one : came.tasks)
      for (const api::TaskStart& start : one.starts)
        if (one.id == task.id) held[start.start] = start.chance.held > 0;
    Day calibrated, by_futures;
    for (const api::TaskStart& start : task.starts) {
      if (!held.contains(start.start) || !start.forbidden.empty()) continue;
      Case one{start.probability, start.chance.by_threshold, start.chance.by_alpha.value_or(false),
               held[start.start]};
      calibrated.push_back(one);
      one.probability = start.by_futures;
      by_futures.push_back(one);
    }
    if (calibrated.empty()) continue;
    all[task.id].calibrated.push_back(std::move(calibrated));
    all[task.id].by_futures.push_back(std::move(by_futures));
  }
}

/// The mornings of an ocean whose truth was in by its last day.
void add_all(const ForecastMornings& site, Said& all) {
  store::Store store = store::Store::open(site.store, store::OpenMode::read_only);
  const auto newest = store.list_forecasts().back();
  const Snapshot last = ingest::read_forecast(store.proven_content(newest.content_sha256));
  const auto mornings = api::past_mornings(site.store, site.site, last, 2);
  // What came of the last two of them was not known for the whole of the day that they speak of.
  for (std::size_t i = first_mornings; i + 2 < mornings.size(); ++i) add(site, mornings[i], all);
}

api::SyntheticOcean ocean_of(std::uint64_t seed, int days) {
  api::SyntheticOceanSettings settings;
  settings.seed = seed;
  settings.days = 4 + days + 6;
  return api::SyntheticOcean(settings);
}

Weather weather_of(const api::SyntheticOcean& ocean) {
  const GeoPoint site = ocean.settings().site;
  const auto within = [&ocean](UtcTime time) {
    return std::clamp(time, ocean.begin(), ocean.end());
  };
  return {[&ocean, site, within](UtcTime time) { return ocean.wind_truth(site, within(time)); },
          [&ocean, site, within](UtcTime time) {
            const auto sea = *ocean.sea_truth(site, within(time));
            return SeaState{sea.significant_height_m, sea.peak_period_s, sea.from_direction_deg};
          }};
}

/// Hours of alpha ventus from one on: wind speed, m/s, and significant height, m.
struct MeasuredHours {
  UtcTime first;  ///< when they are said to have been
  std::vector<double> wind_m_s;
  std::vector<double> height_m;

  [[nodiscard]] double at(const std::vector<double>& values, UtcTime time) const {
    const double h =
        std::clamp(hours_between(first, time), 0.0, static_cast<double>(values.size()) - 1.001);
    const auto low = static_cast<std::size_t>(h);
    const double share = h - static_cast<double>(low);
    return (1 - share) * values[low] + share * values[low + 1];
  }
};

/// @param from  of the record's hours  @param first  when they are said to have been
MeasuredHours alpha_ventus(std::size_t from, std::size_t hours, UtcTime first) {
  MeasuredHours made{first, {}, {}};
  std::ifstream in(*shared_folder() / "data" / "weather_windows" /
                   "alpha_ventus_weather_2002_2014.csv");
  std::string line;
  std::getline(in, line);
  for (std::size_t i = 0; std::getline(in, line) && made.wind_m_s.size() < hours; ++i) {
    if (i < from) continue;
    const auto height = line.rfind(','), wind = line.rfind(',', height - 1);
    made.wind_m_s.push_back(std::stod(line.substr(wind + 1)));
    made.height_m.push_back(std::stod(line.substr(height + 1)));
  }
  return made;
}

/// The record tells no direction and no period: the wind turns slowly about south-west, and the sea
/// is as steep as a wind sea.
Weather weather_of(const MeasuredHours& measured) {
  return {[&measured](UtcTime time) {
            const double turn = 0.7 * std::sin(hours_between(measured.first, time) / 30);
            return std::polar(measured.at(measured.wind_m_s, time), 0.8 + turn);
          },
          [&measured](UtcTime time) {
            const double height_m = measured.at(measured.height_m, time);
            return SeaState{height_m, 1.2 + 4.2 * std::sqrt(height_m), 240};
          }};
}

void print_deciles(const std::vector<Day>& days) {
  for (std::size_t decile = 0; decile < 10; ++decile) {
    double count = 0, said = 0, came = 0;
    for (const Day& day : days)
      for (const Case& one : day)
        if (decile_of(one.probability) == decile) {
          count += 1;
          said += one.probability;
          came += one.held ? 1 : 0;
        }
    if (count < 100) continue;
    const auto [low, high] =
        by_day(days, 0.95, [&](const auto& sample) { return off_in(sample, decile); });
    std::printf("  %.3f  %.3f  %5.0f  %+.3f to %+.3f%s\n", said / count, came / count, count, low,
                high, low > 0 || high < 0 ? "  outside" : "");
  }
}

std::vector<Day> of_all(const Said& all, std::vector<Day> TaskDays::*which) {
  std::vector<Day> days;
  for (const auto& [task, of] : all)
    days.insert(days.end(), (of.*which).begin(), (of.*which).end());
  return days;
}

double brier_of(const std::vector<const Day*>& days) {
  double sum = 0, count = 0;
  for (const Day* day : days)
    for (const Case& one : *day) {
      sum += brier(one.probability, one.held);
      count += 1;
    }
  return sum / count;
}

double brier_of(const std::vector<Day>& days) {
  std::vector<const Day*> all;
  for (const Day& day : days) all.push_back(&day);
  return brier_of(all);
}

/// The Brier score of one way less that of the other, days drawn anew.
std::pair<double, double> brier_between(const std::vector<Day>& one,
                                        const std::vector<Day>& other) {
  return by_day(one, 0.95, [&](const std::vector<const Day*>& sample) {
    std::vector<const Day*> same;
    for (const Day* day : sample) same.push_back(&other[static_cast<std::size_t>(day - &one[0])]);
    return brier_of(sample) - brier_of(same);
  });
}

TEST(MorningChances, ComeTrueOnOceansThatErrOtherwise) {
  const int oceans = static_cast<int>(asked_number("SLACKWATER_OCEANS", 0));
  if (oceans == 0)
    GTEST_SKIP() << "makes weeks of daily forecasts: `make soak` (SLACKWATER_OCEANS) runs it";
  const int days = static_cast<int>(asked_number("SLACKWATER_MORNINGS", 40));
  const bool has_measured = shared_folder().has_value();
  Said all;
  for (int o = 0; o < oceans; ++o) {
    const TemporaryFolder folder;
    const api::SyntheticOcean ocean = ocean_of(501 + static_cast<std::uint64_t>(o), days);
    // Every other one has the weather that was measured in the German Bight, from another season.
    const MeasuredHours measured =
        has_measured && o % 2 == 1
            ? alpha_ventus(static_cast<std::size_t>(2000 + 9000 * o),
                           static_cast<std::size_t>(24 * (days + 12)), ocean.begin())
            : MeasuredHours{};
    const Weather weather = measured.wind_m_s.empty() ? weather_of(ocean) : weather_of(measured);
    std::printf("ocean %d: %s\n", o + 1,
                measured.wind_m_s.empty() ? "synthetic weather" : "alpha ventus");
    std::fflush(stdout);
    add_all(
        forecast_mornings(folder.path(), ocean, weather, days, static_cast<std::uint64_t>(o) + 1),
        all);
  }
  for (const auto& [task, of] : all) {
    std::printf("%s: %zu starts; Brier %.4f, as the futures say %.4f\n", task.c_str(),
                cases_in(of.calibrated), brier_of(of.calibrated), brier_of(of.by_futures));
    expect_better_than("threshold", of.calibrated, [](const Case& c) { return c.by_threshold; });
    expect_better_than("alpha", of.calibrated, [](const Case& c) { return c.by_alpha; });
    const auto [low, high] = brier_between(of.calibrated, of.by_futures);
    std::printf("Brier score less that as the futures say: %.4f to %.4f\n", low, high);
    print_deciles(of.calibrated);
  }
  const std::vector<Day> calibrated = of_all(all, &TaskDays::calibrated);
  const std::vector<Day> by_futures = of_all(all, &TaskDays::by_futures);
  const auto [low, high] = brier_between(calibrated, by_futures);
  std::printf("all tasks: Brier score less that as the futures say: %.4f to %.4f\n", low, high);
  EXPECT_LT(high, 0);
  std::printf("as the futures say; P said, came true, cases, 95 %% interval of the difference\n");
  print_deciles(by_futures);
  std::printf("with past mornings\n");
  print_deciles(calibrated);
}

}  // namespace
}  // namespace slackwater::tests::morning_chances_test
