#include "calibration/residuals/column_rows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "fields/base/numbers/random.h"
#include "fields/current/coriolis.h"
#include "tests/support/unsteady_column.h"

namespace slackwater::calibration::column_rows_test {
namespace {

const UtcTime midnight = parse_utc("2024-03-01T00:00:00Z");

struct Case {
  ColumnDay day;
  std::vector<double> estimate;
  [[nodiscard]] std::string name() const {
    const ParameterLayout& l = day.layout;
    return std::string(name_of(l.form)) + " latitude " + std::to_string(day.latitude.degrees()) +
           (l.has_wind ? " wind" : "") + (l.is_unsteady ? " unsteady" : "") +
           (day.time.front().is_mean() ? " means" : " instants");
  }
};

HourlyStress random_hours(Rng& rng) {
  HourlyStress hourly;
  hourly.first = add_hours(midnight, -72);
  for (int i = 0; i <= 96; ++i) {
    hourly.is_known.push_back(i < 20 || i > 24);
    hourly.stress_pa.push_back(
        hourly.is_known.back() ? Horizontal(0.2 * rng.normal(), 0.2 * rng.normal()) : Horizontal{});
  }
  return hourly;
}

std::vector<double> random_estimate(const ParameterLayout& layout, Rng& rng) {
  std::vector<double> estimate(layout.count());
  for (double& x : estimate) x = 0.3 * rng.normal();
  if (layout.has_shape) {
    estimate[ParameterLayout::log_viscosity] = rng.uniform(std::log(1e-3), std::log(0.5));
    estimate[ParameterLayout::log_bottom] = rng.uniform(std::log(1e-5), std::log(2e-2));
  }
  if (layout.has_layer()) estimate[layout.log_layer()] = rng.uniform(std::log(4), std::log(40));
  return estimate;
}

/// Every combination: form, wind, unsteady, instants or means, place.
std::vector<Case> all_cases() {
  Rng rng(7, "tests/column_rows");
  std::vector<Case> cases;
  for (int code = 0; code < 72; ++code) {
    Case c;
    ParameterLayout& layout = c.day.layout;
    layout.form = std::vector{SteadyForm::finite_depth, SteadyForm::three_layer,
                              SteadyForm::mixed_layer}[static_cast<std::size_t>(code % 3)];
    const int place = code / 3 % 3;
    layout.has_shape = place != 2;
    layout.has_wind = layout.has_shape && code / 9 % 2 == 1;
    layout.is_unsteady = code / 18 % 2 == 1;
    const bool is_mean = code / 36 == 1;
    c.day.latitude =
        Angle::from_degrees(place == 2 ? 1.5 : (place == 0 ? 1 : -1) * rng.uniform(5, 70));
    c.day.water_depth_m = 45;
    c.day.depth_m = {0.5, 6, 13, 21, 34, 44};
    c.day.start = midnight;
    c.day.hourly = random_hours(rng);
    for (const double h : {0.0, 5.0, 11.5, 17.0, 22.0}) {
      c.day.time.push_back({add_hours(midnight, h), add_hours(midnight, is_mean ? h + 1.5 : h)});
      c.day.stress_pa.emplace_back(layout.has_wind ? 0.2 * rng.normal() : 0.0,
                                   layout.has_wind ? 0.2 * rng.normal() : 0.0);
    }
    c.estimate = random_estimate(layout, rng);
    cases.push_back(std::move(c));
  }
  return cases;
}

TEST(ColumnRows, EveryDerivativeAgreesWithCentralDifferencesForEveryLayout) {
  const double h = 1e-5;  // truncation 1e-10 of the third derivative, rounding 1e-16/h
  for (const Case& c : all_cases()) {
    ColumnRows rows(c.day);
    rows.evaluate(c.estimate.data(), true);
    ColumnRows moved(c.day);
    for (std::size_t i = 0; i < c.estimate.size(); ++i) {
      std::vector<double> estimate = c.estimate;
      estimate[i] += h;
      moved.evaluate(estimate.data(), false);
      const ColumnRows::Matrix up = moved.model();
      estimate[i] -= 2 * h;
      moved.evaluate(estimate.data(), false);
      const ColumnRows::Matrix difference = (up - moved.model()) / (2 * h);
      const double miss = (difference - rows.derivative(i)).cwiseAbs().maxCoeff();
      EXPECT_LT(miss, 1e-7 * (1 + difference.cwiseAbs().maxCoeff()))
          << c.name() << " parameter " << i;
    }
  }
}

TEST(ColumnRows, TheModelIsTheSameWithAndWithoutDerivatives) {
  for (const Case& c : all_cases()) {
    ColumnRows rows(c.day);
    rows.evaluate(c.estimate.data(), false);
    const ColumnRows::Matrix plain = rows.model();
    rows.evaluate(c.estimate.data(), true);
    // The products over modes are summed in another order: rounding, no more.
    EXPECT_LT((rows.model() - plain).cwiseAbs().maxCoeff(), 1e-13) << c.name();
  }
}

SteadyParameters parameters_of(const Case& c) {
  const ParameterLayout& l = c.day.layout;
  SteadyParameters p;
  p.interior_east_m_s = c.estimate[0];
  p.interior_north_m_s = c.estimate[1];
  if (l.has_shape) {
    p.eddy_viscosity_m2_s = std::exp(c.estimate[2]);
    p.bottom_friction_m_s = p.base_friction_m_s = p.bottom_eddy_viscosity_m2_s =
        std::exp(c.estimate[3]);
  }
  if (l.has_wind) p.stress_factor = std::exp(c.estimate[l.log_factor()]);
  if (l.has_layer()) p.mixed_layer_depth_m = std::exp(c.estimate[l.log_layer()]);
  return p;
}

/// The mean of a function of hours since midnight over the cell: Simpson, 200 parts; or its value.
Horizontal over(const TimeCell& cell, const std::function<Horizontal(double)>& value) {
  const double from = hours_between(midnight, cell.start);
  if (!cell.is_mean()) return value(from);
  const double width = hours_between(cell.start, cell.end);
  Horizontal sum{};
  for (int i = 0; i <= 200; ++i)
    sum += (i == 0 || i == 200 ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * value(from + width * i / 200);
  return sum / 600.0;
}

/// Root of x tan x = biot in (0, pi/2) by halving.
double gravest_root(double biot) {
  double low = 0;
  double high = 0.5 * constants::pi;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (middle * std::tan(middle) < biot ? low : high) = middle;
  }
  return low;
}

Horizontal inertial_part(const Case& c, const SteadyParameters& p, const TimeCell& cell, double d) {
  const ParameterLayout& l = c.day.layout;
  const bool is_layer = l.form == SteadyForm::mixed_layer;
  const double layer_m = is_layer ? p.mixed_layer_depth_m : c.day.water_depth_m;
  const double k = gravest_root(p.bottom_friction_m_s * layer_m / p.eddy_viscosity_m2_s) / layer_m;
  const double taper = d > layer_m ? std::exp(-4 * (d - layer_m) / layer_m) : 1.0;
  const Horizontal lambda_1_h =
      3600.0 * Horizontal(p.eddy_viscosity_m2_s * k * k, coriolis_parameter_rad_s(c.day.latitude));
  return Horizontal(c.estimate[l.inertial()], c.estimate[l.inertial() + 1]) *
         std::cos(k * std::min(d, layer_m)) * taper *
         over(cell, [&](double hour) { return std::exp(-lambda_1_h * hour); });
}

TEST(ColumnRows, TheModelIsSteadyFormPlusTransientPlusInertialMotion) {
  for (const Case& c : all_cases()) {
    const ParameterLayout& l = c.day.layout;
    const SteadyParameters p = parameters_of(c);
    const LevelResponses r =
        level_responses(l.form, p, c.day.latitude, c.day.water_depth_m, c.day.depth_m);
    const UnsteadyColumn column(l.form, p, c.day.latitude, c.day.water_depth_m, c.day.depth_m,
                                c.day.hourly);
    ColumnRows rows(c.day);
    rows.evaluate(c.estimate.data(), false);
    for (std::size_t t = 0; t < c.day.time.size(); ++t) {
      const TimeCell& cell = c.day.time[t];
      std::vector<Horizontal> transient(c.day.depth_m.size());
      if (l.is_unsteady && l.has_wind) column.transient(cell, transient);
      const double days = hours_between(midnight, cell.centre()) / 24 - 0.5;
      Horizontal flow = p.interior_m_s();
      if (l.is_unsteady)
        flow += days * Horizontal(c.estimate[l.trend()], c.estimate[l.trend() + 1]);
      for (std::size_t k = 0; k < c.day.depth_m.size(); ++k) {
        const Horizontal wind = c.day.stress_pa[t] * r.stress(k) + transient[k];
        Horizontal expected = flow * r.interior(k) + wind;
        if (l.has_modes()) expected += inertial_part(c, p, cell, c.day.depth_m[k]);
        const auto row = static_cast<Eigen::Index>(t);
        const auto level = static_cast<Eigen::Index>(k);
        EXPECT_LT(std::abs(rows.model()(row, level) - expected), 1e-11 * (1 + std::abs(expected)))
            << c.name() << " time " << t << " level " << k;
        EXPECT_LT(std::abs(rows.wind_driven()(row, level) - (l.has_wind ? wind : 0.0)), 1e-12)
            << c.name();
      }
    }
  }
}

}  // namespace
}  // namespace slackwater::calibration::column_rows_test
