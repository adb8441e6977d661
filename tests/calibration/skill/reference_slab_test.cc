#include "calibration/skill/reference_slab.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "calibration/skill/slab_response.h"
#include "fields/base/constants.h"
#include "tests/support/shared_data.h"

namespace slackwater::calibration::reference_slab_test {
namespace {

const UtcDay day_d = parse_day("2023-11-02");

TEST(SlabResponse, SteadyStressGivesTheClosedFormTimesItsKnownFactor) {
  // Closed form at 54 N, h = 20 m, r = 1/(2 d), 0.194775 Pa to the east (u, v in m/s after 3, 6, 12
  // h).
  const double f =
      3600.0 * 2.0 * constants::earth_rotation_rad_s * std::sin(54.0 * constants::pi / 180.0);
  const Slab slab{
      .damping_per_h = 1.0 / 48.0, .coriolis_rad_h = f, .density_kg_m3 = 1025.0, .depth_m = 20.0};
  const std::vector<Horizontal> stress(13, Horizontal(0.194775, 0.0));
  const std::vector<Horizontal> response = slab_response(stress, slab);
  const Horizontal lambda(slab.damping_per_h, f);
  const Horizontal factor = lambda / (1.0 - std::exp(-lambda));  // sum of a geometric series
  const std::map<std::size_t, Horizontal> closed{
      {3, {0.07503128396933052, -0.054742831189193125}},
      {6, {0.046444514586597645, -0.13717844653933786}},
      {12, {-0.055201610113967584, -0.05969666379758239}}};
  for (const auto& [hour, exact] : closed)
    EXPECT_NEAR(std::abs(response[hour] - exact * factor), 0.0, 1e-9) << hour;
}

TEST(SlabResponse, WithoutStressItOnlyTurnsAndDecays) {
  std::vector<Horizontal> stress(100);
  stress[0] = {1.0, 0.5};
  const Slab slab{.damping_per_h = 0.02, .coriolis_rad_h = -0.4};
  const auto response = slab_response(stress, slab);
  for (std::size_t i = 2; i < response.size(); ++i) {
    const Horizontal turned =
        response[1] * std::exp(-Horizontal(0.02, -0.4) * static_cast<double>(i - 1));
    EXPECT_NEAR(std::abs(response[i] - turned), 0.0, 1e-15);
  }
}

TEST(ReferenceStress, IsContinuousEnoughAndPointsWithTheWind) {
  EXPECT_NEAR(std::abs(reference_stress_pa({10.0, 0.0}) - 1.225 * 1.59e-3 * 100.0), 0.0, 1e-15);
  EXPECT_NEAR(std::abs(reference_stress_pa({0.0, 30.0}) - Horizontal(0.0, 1.225 * 2.43e-3 * 900.0)),
              0.0, 1e-12);
  EXPECT_EQ(reference_stress_pa({}), Horizontal());
}

/// The table of a golden: lines of a key and numbers.
struct Golden {
  std::map<std::string, std::vector<std::vector<double>>> rows;
  double number(const std::string& key) const { return rows.at(key).at(0).at(0); }
};

Golden read_golden(const std::filesystem::path& file) {
  Golden golden;
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line)) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    std::string key;
    words >> key;
    golden.rows[key].emplace_back();
    for (double x = 0; words >> x;) golden.rows[key].back().push_back(x);
  }
  return golden;
}

VectorColumn column_of(const std::vector<std::vector<double>>& rows, double last_h) {
  VectorColumn column;
  const std::size_t levels = (rows.front().size() - 1) / 2;
  column.levels_m.resize(levels);
  for (const auto& row : rows) {
    if (row[0] > last_h) continue;
    column.time.push_back(TimeCell::instant(add_hours(UtcTime(day_d), row[0])));
    for (std::size_t k = 0; k < levels; ++k) {
      column.value.emplace_back(row[1 + 2 * k], row[2 + 2 * k]);
      column.status.push_back(SampleStatus::ok);
    }
  }
  return column;
}

TEST(ReferenceSlab, EqualsTheIndependentImplementation) {
  const Golden golden = read_golden(tests::source_folder() / "tests/golden/reference_slab.golden");
  const VectorColumn current = column_of(golden.rows.at("current"), 24.0);
  const VectorColumn wind = column_of(golden.rows.at("wind"), 1e9);
  for (const bool persist : {false, true}) {
    const VectorColumn expected = column_of(golden.rows.at(persist ? "persist" : "best"), 1e9);
    const BaselineInput input{day_d, current, &wind,
                              Angle::from_degrees(golden.number("latitude_deg")), persist};
    const BaselineOutcome outcome = reference_slab_forecast(input, expected.time);
    ASSERT_TRUE(outcome.forecast.has_value()) << outcome.reason;
    for (std::size_t i = 0; i < expected.value.size(); ++i) {
      EXPECT_TRUE(outcome.forecast->has(i));
      EXPECT_NEAR(std::abs(outcome.forecast->value[i] - expected.value[i]), 0.0,
                  golden.number("tolerance_m_s"));
    }
  }
}

/// Hourly current on D from a function of the hours since its end.
template <typename Function>
VectorColumn hourly(Function value, bool means, double days = 1.0) {
  VectorColumn column;
  const UtcTime end = UtcTime(day_d) + std::chrono::days(1);
  for (double t_h = -24.0 * days; t_h < (means ? -0.5 : 0.5); t_h += 1.0) {
    const UtcTime from = add_hours(end, t_h);
    column.time.push_back(means ? TimeCell{from, from + std::chrono::hours(1)}
                                : TimeCell::instant(from));
    column.value.push_back(value(means ? t_h + 0.5 : t_h));
    column.status.push_back(SampleStatus::ok);
  }
  return column;
}

TEST(ReferenceSlab, CarriesAnInertialCircleIntoTheNextDay) {
  // W = a + c e^{-(r + i f) t}: in the model but for the ridge, which shrinks c by n 1e-3 of its n:
  // 0.1 %; the mean residual of the last hours gives part of that back.
  const double f =
      3600.0 * 2.0 * constants::earth_rotation_rad_s * std::sin(47.0 * constants::pi / 180.0);
  const Horizontal lambda(1.0 / 48.0, f);
  const Horizontal a(0.05, -0.1);
  const auto truth = [&](double t_h) { return a + 0.3 * std::exp(-lambda * t_h); };
  const VectorColumn current = hourly(truth, false);
  const BaselineInput input{day_d, current, nullptr, Angle::from_degrees(47.0), false};
  std::vector<TimeCell> cells;
  for (int i = 1; i <= 24; ++i)
    cells.push_back(TimeCell::instant(add_hours(UtcTime(day_d), 24.0 + i)));
  const BaselineOutcome outcome = reference_slab_forecast(input, cells);
  ASSERT_TRUE(outcome.forecast.has_value());
  for (int i = 1; i <= 24; ++i)
    EXPECT_NEAR(std::abs(outcome.forecast->value[static_cast<std::size_t>(i - 1)] - truth(i)), 0.0,
                2e-3);
}

TEST(ReferenceSlab, TurningCurrentAndWindTurnsTheForecast) {
  const auto current_at = [](double t_h) {
    return Horizontal(0.1, 0.02) + 0.2 * std::polar(1.0, -0.4 * t_h) + Horizontal(0.01 * t_h, 0.0);
  };
  VectorColumn current = hourly(current_at, true, 3.0);
  VectorColumn wind =
      hourly([](double t_h) { return std::polar(8.0 + 0.1 * t_h, 0.2 * t_h); }, false, 5.0);
  std::vector<TimeCell> cells;
  for (int i = 0; i < 24; ++i) {
    const UtcTime from = add_hours(UtcTime(day_d), 24.0 + i);
    cells.push_back({from, from + std::chrono::hours(1)});
  }
  const Angle latitude = Angle::from_degrees(42.0);
  const auto before = reference_slab_forecast({day_d, current, &wind, latitude, true}, cells);
  const Horizontal turn = std::polar(1.0, 2.2);
  for (Horizontal& value : current.value) value *= turn;
  for (Horizontal& value : wind.value) value *= turn;
  const auto after = reference_slab_forecast({day_d, current, &wind, latitude, true}, cells);
  for (std::size_t i = 0; i < cells.size(); ++i)
    EXPECT_NEAR(std::abs(after.forecast->value[i] - turn * before.forecast->value[i]), 0.0, 1e-12);
}

TEST(ReferenceSlab, AWindThatBeginsAfterDIsNoWind) {
  const VectorColumn current =
      hourly([](double t_h) { return std::polar(0.2, -0.4 * t_h); }, false);
  VectorColumn late;
  late.time.push_back(TimeCell::instant(add_hours(UtcTime(day_d), 25.0)));
  late.value.emplace_back(20.0, 0.0);
  late.status.push_back(SampleStatus::ok);
  const std::vector<TimeCell> cells{TimeCell::instant(add_hours(UtcTime(day_d), 30.0))};
  const Angle latitude = Angle::from_degrees(42.0);
  const auto with = reference_slab_forecast({day_d, current, &late, latitude, false}, cells);
  const auto without = reference_slab_forecast({day_d, current, nullptr, latitude, false}, cells);
  EXPECT_EQ(with.forecast->value[0], without.forecast->value[0]);
}

TEST(ReferenceSlab, TwoValuesOnDAreTooFew) {
  VectorColumn current = hourly([](double) { return Horizontal(0.1, 0.0); }, false);
  for (std::size_t i = 2; i < current.status.size(); ++i) current.status[i] = SampleStatus::missing;
  const std::vector<TimeCell> cells{TimeCell::instant(add_hours(UtcTime(day_d), 30.0))};
  const auto outcome =
      reference_slab_forecast({day_d, current, nullptr, Angle::from_degrees(42.0), false}, cells);
  EXPECT_FALSE(outcome.forecast.has_value());
  EXPECT_NE(outcome.reason.find("fewer than 3 values on 2023-11-02"), std::string::npos);
}

}  // namespace
}  // namespace slackwater::calibration::reference_slab_test
