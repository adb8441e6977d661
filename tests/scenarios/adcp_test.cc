#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <set>
#include <vector>

#include "tests/support/point_series_for_tests.h"
#include "tests/support/shared_data.h"
#include "tests/support/store_for_tests.h"

// Moored profilers as the only source: ingested, forecast as if live, scored against what they saw
// next, all with the program itself.

namespace slackwater::tests::adcp_test {
namespace {

using nlohmann::json;

std::filesystem::path site_file(const StoreForTests& store, const std::string& id, double latitude,
                                double longitude, double water_depth_m) {
  const auto path = store.file(id + ".yaml");
  write_bytes(path, "id: " + id + "\nname: " + id + "\nlatitude_deg: " + std::to_string(latitude) +
                        "\nlongitude_deg: " + std::to_string(longitude) +
                        "\nwater_depth_m: " + std::to_string(water_depth_m) + "\n");
  return path;
}

std::filesystem::path only_file(const std::filesystem::path& folder, const std::string& prefix) {
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().filename().string().starts_with(prefix)) return entry.path();
  throw std::runtime_error("no " + prefix + " in " + folder.string());
}

using ErrorOfDay = std::map<std::string, double>;  ///< m/s, by day

/// What a hindcast scored over the whole column, in (0, 24] h but for `by_lead`.
struct Scores {
  std::set<std::string> days;
  std::set<std::string> truths;
  std::map<std::string, double> rmse_m_s;  ///< by method, days equal, days of the forecast only
  std::string skipped;
  /// Of the 80 % band over all pairs, with its interval where they are not few.
  std::optional<double> coverage_80;
  std::optional<std::pair<double, double>> coverage_80_interval;
  /// By the hours that a lead begins and ends with, and by method.
  std::map<std::pair<double, double>, std::map<std::string, ErrorOfDay>> by_lead;
};

Scores hindcast(const StoreForTests& store, const std::filesystem::path& site, const char* from,
                const char* to) {
  const ProgramResult run = store.run({"hindcast", "--site", site.string(), "--from", from, "--to",
                                       to, "--horizon", "72h", "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  Scores scores;
  scores.skipped = run.err;
  std::map<std::string, std::pair<double, int>> sums;
  const json list = json::parse(run.out);
  for (const json& entry : list) {
    if (entry.contains("variable") && entry["variable"] != "sea_water_velocity") continue;
    if (!entry["column"].is_null()) continue;
    if (!entry.contains("depth_m") || !entry["depth_m"].is_array() || entry["depth_m"][0] != 0.0 ||
        entry["depth_m"][1] < 1000)
      continue;
    scores.by_lead[{entry["lead_h"][0], entry["lead_h"][1]}][entry["method"]][entry["day"]] =
        entry["rmse_m_s"];
    if (entry["lead_h"] != json::array({0.0, 24.0})) continue;
    auto& [squares, days] = sums[entry["method"]];
    squares += std::pow(entry["rmse_m_s"].get<double>(), 2);
    ++days;
    scores.truths.insert(entry["truth"]);
    if (entry["method"] != "forecast") continue;
    scores.days.insert(entry["day"]);
    const json& set = entry["set"];
    if (set["coverage_80"].is_number()) scores.coverage_80 = set["coverage_80"];
    if (set["coverage_80_interval_95"].is_array())
      scores.coverage_80_interval = {set["coverage_80_interval_95"][0],
                                     set["coverage_80_interval_95"][1]};
  }
  for (const auto& [method, sum] : sums)
    scores.rmse_m_s[method] = std::sqrt(sum.first / sum.second);
  return scores;
}

void print(const char* set, const Scores& scores) {
  std::printf("%s, %zu pairs:", set, scores.days.size());
  for (const auto& [method, rmse] : scores.rmse_m_s) std::printf("  %s %.4f", method.c_str(), rmse);
  if (scores.coverage_80) std::printf("  80 %% band holds %.1f %%", 100 * *scores.coverage_80);
  if (scores.coverage_80_interval) {
    std::printf(" [%.1f, %.1f]", 100 * scores.coverage_80_interval->first,
                100 * scores.coverage_80_interval->second);
  }
  std::printf("\n");
}

/// On the days that have a harmonic tide, which needs a record of 15 days: the forecast is at 24 to
/// 48 h and at 48 to 72 h no worse than tide-harmonic, but for two standard errors of the mean
/// difference of their squares. Neighbouring days share weather and truth: blocks of five days are
/// taken for independent.
void expect_no_worse_than_harmonic_tide(const char* set, const Scores& scores) {
  constexpr std::size_t block = 5;
  for (const auto& lead : {std::pair(24.0, 48.0), std::pair(48.0, 72.0)}) {
    const auto& methods = scores.by_lead.at(lead);
    std::vector<double> more;
    double forecast = 0;
    double tide = 0;
    for (const auto& [day, error] : methods.at("tide-harmonic")) {
      const double ours = methods.at("forecast").at(day);
      more.push_back(ours * ours - error * error);
      forecast += ours * ours;
      tide += error * error;
    }
    const auto n = static_cast<double>(more.size());
    std::printf("%s, %.0f to %.0f h, %zu days: forecast %.4f, tide-harmonic %.4f m/s\n", set,
                lead.first, lead.second, more.size(), std::sqrt(forecast / n), std::sqrt(tide / n));
    ASSERT_GE(more.size(), 2 * block);
    const double mean = (forecast - tide) / n;
    double squares = 0;
    std::size_t blocks = 0;
    for (std::size_t first = 0; first + block <= more.size(); first += block, ++blocks) {
      double sum = 0;
      for (std::size_t i = first; i < first + block; ++i) sum += more[i] - mean;
      squares += sum * sum / (block * block);
    }
    const auto count = static_cast<double>(blocks);
    const double standard_error = std::sqrt(squares / (count * std::max(1.0, count - 1)));
    EXPECT_LE(mean, 2 * standard_error) << set << " from " << lead.first << " h";
    EXPECT_LE(std::sqrt(forecast), 1.05 * std::sqrt(tide)) << "however noisy the days are";
  }
}

TEST(AdcpRottnest, ForecastsFromTheProfilerAloneAreIssuedAndScoredAgainstIt) {
  SLACKWATER_NEEDS_SHARED(shared);
  const StoreForTests store;
  store.ingest(only_file(shared / "data/adcp", "IMOS"));
  const auto site = site_file(store, "rottnest", -32.0, 115.4, 48);
  const Scores scores = hindcast(store, site, "2018-08-16", "2018-08-22");
  print("Rottnest", scores);
  // 08-16 starts at 08:00 and 08-22 ends at 06:00: neither is a whole day.
  EXPECT_EQ(scores.days, (std::set<std::string>{"2018-08-17", "2018-08-18", "2018-08-19",
                                                "2018-08-20", "2018-08-21"}));
  EXPECT_NE(scores.skipped.find("2018-08-16"), std::string::npos);
  EXPECT_EQ(scores.truths, std::set<std::string>{"station NRSROT-ADCP"});
  // Five days of half an hour: the figure of the README, and the best naive rival.
  EXPECT_LT(scores.rmse_m_s.at("forecast"), 0.1951 + 0.001);
  for (const char* naive : {"persistence", "day-mean", "same-hour"}) {
    if (scores.rmse_m_s.count(naive) == 0) continue;
    EXPECT_LT(scores.rmse_m_s.at("forecast"), scores.rmse_m_s.at(naive)) << naive;
  }
  EXPECT_EQ(scores.rmse_m_s.count("tide-harmonic"), 0U) << "six days are no record of the tide";
}

TEST(AdcpRottnest, AForecastSaysThatItRestsOnTheStationAlone) {
  SLACKWATER_NEEDS_SHARED(shared);
  const StoreForTests store;
  store.ingest(only_file(shared / "data/adcp", "IMOS"));
  const auto site = site_file(store, "rottnest", -32.0, 115.4, 48);
  const ProgramResult run = store.run({"forecast", "--site", site.string(), "--day", "2018-08-20",
                                       "--at", "2018-08-21T05:00:00Z", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("currents of station NRSROT-ADCP"), std::string::npos) << run.out;
}

TEST(AdcpWashington, GarbageEnsemblesAreRejectedAndCountedAndTheRestIsForecast) {
  SLACKWATER_NEEDS_SHARED(shared);
  const StoreForTests store;
  const ProgramResult ingest =
      store.run({"ingest", only_file(shared / "data/adcp", "eh2").string()});
  ASSERT_EQ(ingest.exit_code, 0) << ingest.err;
  // Counted by hand in the raw file: 23 ensembles faster than 3 m/s, 5 of nothing but zeros.
  EXPECT_NE(ingest.out.find("rejected 23 ensembles"), std::string::npos) << ingest.out;
  EXPECT_NE(ingest.out.find("rejected 5 ensembles"), std::string::npos) << ingest.out;
  const auto site = site_file(store, "washington", 47.60, -124.59, 45.5);
  const Scores scores = hindcast(store, site, "2005-05-30", "2005-07-18");
  print("Washington", scores);
  EXPECT_EQ(scores.days.size(), 45U);  // 05-31 to 07-14; the garbage lies on 07-15 to 07-17
  EXPECT_EQ(*scores.days.begin(), "2005-05-31");
  EXPECT_EQ(*scores.days.rbegin(), "2005-07-14");
  EXPECT_EQ(scores.truths, std::set<std::string>{"station EH2"});
  // No vector of the shelf's truth or forecast comes near garbage (up to 45 m/s).
  for (const auto& [method, rmse] : scores.rmse_m_s) EXPECT_LT(rmse, 0.3) << method;
  EXPECT_LT(scores.rmse_m_s.at("forecast"), 0.1378 + 0.001);
  ASSERT_TRUE(scores.coverage_80_interval) << "45 pairs are not few";
  EXPECT_LT(scores.coverage_80_interval->first, 0.80);
  EXPECT_GT(scores.coverage_80_interval->second, 0.80);
  for (const char* naive : {"persistence", "day-mean", "same-hour", "reference-slab"}) {
    if (scores.rmse_m_s.count(naive) == 0) continue;
    EXPECT_LT(scores.rmse_m_s.at("forecast"), scores.rmse_m_s.at(naive)) << naive;
  }
  expect_no_worse_than_harmonic_tide("Washington", scores);
}

/// Two months off the Frisian coast: M2 and S2, the slab's answer to a wind that turns, a slow
/// drift.
class NorthSea {
 public:
  static constexpr double latitude = 54.0;
  NorthSea() {
    const double f = 2 * 7.2921e-5 * std::sin(latitude * std::numbers::pi / 180) * 3600;
    Horizontal s{};
    for (int h = 0; h <= hours_; ++h) {
      slab_.push_back(s);
      const Horizontal w = wind(UtcTime(first()) + std::chrono::hours(h));
      const double drag = (0.79 + 0.08 * std::abs(w)) * 1e-3;
      const Horizontal force = 1.225 * drag * std::abs(w) * w / (1026.0 * 25) * 3600.0;
      s = s * std::exp(Horizontal{-1.0 / 18, -f}) + force;
    }
  }
  static UtcDay first() { return parse_day("2019-10-01"); }

  [[nodiscard]] static Horizontal wind(UtcTime time) {
    const double h = hours_between(UtcTime(first()), time);
    return Horizontal{3, 1} + std::polar(6.0, 2 * std::numbers::pi * h / 71) +
           std::polar(3.0, 2.1 - 2 * std::numbers::pi * h / 29);
  }
  [[nodiscard]] Horizontal current(UtcTime time, double depth_m) const {
    const double h = hours_between(UtcTime(first()), time);
    const double m2 = 2 * std::numbers::pi * h / 12.4206;
    const double s2 = 2 * std::numbers::pi * h / 12;
    const Horizontal tide{0.5 * std::cos(m2) + 0.15 * std::cos(s2 + 1),
                          0.2 * std::sin(m2) + 0.05 * std::sin(s2 + 1)};
    const auto low = std::min(static_cast<std::size_t>(h), slab_.size() - 2);
    const double share = h - static_cast<double>(low);
    const Horizontal driven = (1 - share) * slab_[low] + share * slab_[low + 1];
    return (1 - 0.4 * std::pow(depth_m / 30, 3)) * tide + std::exp(-depth_m / 12) * driven +
           std::polar(0.04, 2 * std::numbers::pi * h / 400);
  }

 private:
  int hours_ = 62 * 24;
  std::vector<Horizontal> slab_;
};

PointSeriesForTests profiler(const NorthSea& sea, int minutes) {
  PointSeriesForTests series;
  series.station = "NS1";
  series.time = stepping_times(NorthSea::first(), 61, minutes);
  series.depth_m = {3, 7, 11, 15, 19, 23, 27};
  series.value = [&sea](UtcTime time, double depth) { return sea.current(time, depth); };
  return series;
}

PointSeriesForTests mast(double latitude, double longitude) {
  PointSeriesForTests series;
  series.station = "MAST";
  series.latitude_deg = latitude;
  series.longitude_deg = longitude;
  series.time = stepping_times(NorthSea::first(), 61, 60);
  series.value = [](UtcTime time, double) { return NorthSea::wind(time); };
  return series;
}

/// Ten days in the second month.
Scores ten_days(const StoreForTests& store) {
  return hindcast(store, site_file(store, "northsea", 54.0, 6.5, 30), "2019-11-05", "2019-11-14");
}

TEST(AdcpNorthSea, TwoMonthsOfCurrentAndWindAsPointSeriesAreForecastAndBeatTheTide) {
  const NorthSea sea;
  const StoreForTests store;
  store.ingest(write_point_series(store.file("current.nc"), profiler(sea, 60)));
  store.ingest(write_point_series(store.file("wind.nc"), mast(54.05, 6.55)));
  const Scores scores = ten_days(store);
  print("North Sea, hourly", scores);
  EXPECT_EQ(scores.days.size(), 10U);
  EXPECT_EQ(scores.truths, std::set<std::string>{"station NS1"});
  EXPECT_LT(scores.rmse_m_s.at("forecast"), 0.47 * scores.rmse_m_s.at("persistence"));
  EXPECT_LT(scores.rmse_m_s.at("reference-slab"), 0.87 * scores.rmse_m_s.at("tide-phase"));
  expect_no_worse_than_harmonic_tide("North Sea, hourly", scores);
}

TEST(AdcpNorthSea, TheLayoutOfTheFilesDoesNotMoveTheScores) {
  const NorthSea sea;
  const auto scores_of = [&](SeriesLevelsForTests layout, bool speeds) {
    const StoreForTests store;
    PointSeriesForTests series = profiler(sea, 60);
    series.levels = layout;
    series.as_speed_and_direction = speeds;
    store.ingest(write_point_series(store.file("current.nc"), series));
    PointSeriesForTests wind = mast(54.05, 6.55);
    wind.as_speed_and_direction = speeds;
    store.ingest(write_point_series(store.file("wind.nc"), wind));
    return ten_days(store);
  };
  const Scores plain = scores_of(SeriesLevelsForTests::depth_axis, false);
  for (const auto layout : {SeriesLevelsForTests::own_variables, SeriesLevelsForTests::own_stations,
                            SeriesLevelsForTests::above_bed}) {
    SCOPED_TRACE(static_cast<int>(layout));
    const Scores other = scores_of(layout, true);
    EXPECT_EQ(other.days, plain.days);
    for (const auto& [method, rmse] : plain.rmse_m_s)  // floats and degrees round differently
      EXPECT_NEAR(other.rmse_m_s.at(method), rmse, 2e-4) << method;
  }
}

TEST(AdcpNorthSea, AFileForEachDepthIsOneProfile) {
  const NorthSea sea;
  const StoreForTests store;
  for (const double depth : {3.0, 15.0, 27.0}) {
    PointSeriesForTests series = profiler(sea, 60);
    series.station = "NS1-" + std::to_string(static_cast<int>(depth));
    series.levels = SeriesLevelsForTests::own_variables;
    series.depth_m = {depth};
    store.ingest(write_point_series(store.file(series.station + ".nc"), series));
  }
  store.ingest(write_point_series(store.file("wind.nc"), mast(54.05, 6.55)));
  const ProgramResult run =
      store.run({"forecast", "--site", site_file(store, "northsea", 54.0, 6.5, 30).string(),
                 "--day", "2019-11-10", "--at", "2019-11-11T05:00:00Z"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const ProgramResult profile =
      store.run({"profile", "--site", site_file(store, "northsea", 54.0, 6.5, 30).string(),
                 "--time", "2019-11-11T12:00:00Z", "--json"});
  ASSERT_EQ(profile.exit_code, 0) << profile.err;
  for (const char* depth : {"3.0", "15.0", "27.0"})
    EXPECT_NE(profile.out.find(depth), std::string::npos) << depth << profile.out;
}

TEST(AdcpNorthSea, HolesOfAnHourOrTwoDoNotCostTheDayAndADayOfSilenceDoes) {
  const NorthSea sea;
  const StoreForTests store;
  PointSeriesForTests series = profiler(sea, 10);
  std::erase_if(series.time, [](UtcTime time) {
    const double h = hours_between(UtcTime(parse_day("2019-11-06")), time);
    return (h > 3 && h < 5) ||              // two hours of 11-06
           (h > 23.1 && h < 24.9) ||        // its last fifty minutes, and of 11-07 the first
           (h > 3 * 24 && h < 4 * 24 - 2);  // most of 11-09
  });
  store.ingest(write_point_series(store.file("current.nc"), series));
  store.ingest(write_point_series(store.file("wind.nc"), mast(54.1, 6.8)));  // 22 km away
  const Scores scores = ten_days(store);
  print("North Sea, ten minutes with holes", scores);
  EXPECT_NE(scores.skipped.find("skipped 2019-11-09"), std::string::npos) << scores.skipped;
  EXPECT_EQ(scores.skipped.find("skipped 2019-11-05"), std::string::npos) << scores.skipped;
  EXPECT_EQ(scores.skipped.find("skipped 2019-11-10"), std::string::npos) << scores.skipped;
  EXPECT_LT(scores.rmse_m_s.at("forecast"), 0.47 * scores.rmse_m_s.at("persistence"));
}

}  // namespace
}  // namespace slackwater::tests::adcp_test
