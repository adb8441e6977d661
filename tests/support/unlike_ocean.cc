#include "tests/support/unlike_ocean.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"

namespace slackwater::tests {
namespace {

constexpr std::size_t cells = 34;
constexpr double cell_m = UnlikeOcean::water_depth_m / static_cast<double>(cells);
constexpr double step_s = 120.0;
constexpr int steps_an_hour = 30;
constexpr double coriolis_rad_s = 1.18e-4;  // at 54 N
constexpr double drag_of_bed = 2.5e-3;

Horizontal normal(Rng& random) {
  const double east = random.normal();
  return {east, random.normal()};
}

/// Gauss-Markov twice over: smooth, of standard deviation sigma a component.
std::vector<Horizontal> smooth_series(std::size_t hours, double sigma, double memory_h,
                                      double smoothing_h, Rng& random) {
  const double a = std::exp(-1.0 / memory_h);
  const double b = std::exp(-1.0 / smoothing_h);
  Horizontal rough{};
  Horizontal smooth{};
  std::vector<Horizontal> series;
  const auto spin_up = static_cast<std::size_t>(8 * memory_h);
  for (std::size_t h = 0; h < spin_up + hours; ++h) {
    rough = a * rough + std::sqrt(1 - a * a) * normal(random);
    smooth = b * smooth + (1 - b) * rough;
    if (h >= spin_up) series.push_back(smooth);
  }
  // Of the sum of two exponential memories: var = (tau_1)/(tau_1 + tau_2).
  const double kept = std::sqrt(memory_h / (memory_h + smoothing_h));
  for (Horizontal& value : series) value *= sigma / kept;
  return series;
}

/// Stress over density, m2/s2: a drag of calm air, of wind, and a roof over storms.
Horizontal stress_of(Horizontal wind) {
  const double speed = std::abs(wind);
  const double drag = 1e-3 * std::clamp(0.9 + 0.06 * (speed - 4.0), 0.9, 2.0);
  return 1.22 / 1025.0 * drag * speed * wind;
}

/// Jets in the upper layer: a front comes within four hours and stays a day or so.
std::vector<Horizontal> fronts(std::size_t hours, Rng& random) {
  std::vector<Horizontal> jet(hours);
  double at = 40.0 + 150.0 * random.uniform();
  while (at < static_cast<double>(hours)) {
    const double lasting_h = 18.0 + 30.0 * random.uniform();
    const Horizontal size = 0.10 * normal(random);
    for (std::size_t h = 0; h < hours; ++h) {
      const double since = static_cast<double>(h) - at;
      jet[h] += size * 0.5 * (std::tanh(since / 2.0) - std::tanh((since - lasting_h) / 6.0));
    }
    at += 80.0 + 200.0 * random.uniform();
  }
  return jet;
}

/// The slope of the sea surface that tides and eddies make, as the current that it would drive.
struct Forcing {
  std::vector<Horizontal> interior;
  std::vector<Horizontal> jet;
  std::vector<Horizontal> wind;
  double layer_m = 15;
};

/// Acceleration by the tide's slope, m/s2.
Horizontal tide_slope(double hour) {
  const auto line = [&](double period_h, double plus, double minus, double phase) {
    const double angle = 2 * std::numbers::pi * hour / period_h + phase;
    return plus * std::polar(1.0, angle) + minus * std::polar(1.0, -angle);
  };
  return 1e-4 * (line(12.4206, 0.12, 0.05, 0.3) + line(12.0, 0.04, 0.02, 1.4) +
                 line(25.8193, 0.02, 0.01, 2.0) + line(23.9345, 0.02, 0.01, 0.2));
}

class Water {
 public:
  Water() : w_(cells), upper_(cells) {}

  void step(const Forcing& forcing, double hour) {
    const auto h = static_cast<std::size_t>(hour);
    const double share = hour - static_cast<double>(h);
    const auto now = [&](const std::vector<Horizontal>& series) {
      return (1 - share) * series[h] + share * series[h + 1];
    };
    const Horizontal stress = stress_of(now(forcing.wind));
    mix(stress, forcing.layer_m * (1.0 + 0.2 * std::sin(hour / 37.0)));
    const Horizontal turning = i_ * coriolis_rad_s;
    const Horizontal slope = tide_slope(hour) + turning * now(forcing.interior);
    for (std::size_t j = 0; j < cells; ++j) {
      const double depth = (static_cast<double>(j) + 0.5) * cell_m;
      const double upper = 0.5 * (1.0 - std::tanh((depth - 12.0) / 4.0));
      w_[j] += step_s * (slope + turning * upper * now(forcing.jet));
      w_[j] *= std::polar(1.0, -coriolis_rad_s * step_s);
    }
    diffuse(stress);
  }
  [[nodiscard]] const std::vector<Horizontal>& cells_now() const { return w_; }

 private:
  /// Viscosity at the faces: 0.4 u* d of both boundary layers, little below the mixed layer.
  void mix(Horizontal stress, double layer_m) {
    const double wind_u = std::sqrt(std::abs(stress));
    const double bed_u = std::sqrt(drag_of_bed) * std::abs(w_.back());
    for (std::size_t j = 0; j + 1 < cells; ++j) {
      const double depth = static_cast<double>(j + 1) * cell_m;
      const double height = UnlikeOcean::water_depth_m - depth;
      const double in_layer = std::max(0.0, 1.0 - depth / layer_m);
      const double in_bed_layer = std::max(0.0, 1.0 - height / 18.0);
      viscosity_[j] = 2e-4 + 0.4 * wind_u * (depth + 1.0) * in_layer +
                      0.4 * bed_u * height * in_bed_layer * in_bed_layer;
    }
  }
  /// Backward Euler.
  void diffuse(Horizontal stress) {
    const double k = step_s / (cell_m * cell_m);
    w_[0] += step_s * stress / cell_m;
    double above = 0;
    for (std::size_t j = 0; j < cells; ++j) {
      const double below = j + 1 < cells ? k * viscosity_[j] : 0.0;
      double diagonal = 1.0 + above + below;
      if (j + 1 == cells) diagonal += step_s * drag_of_bed * std::abs(w_[j]) / cell_m;
      const double pivot = diagonal - (j > 0 ? above * upper_[j - 1] : 0.0);
      upper_[j] = below / pivot;
      w_[j] = (w_[j] + (j > 0 ? above * w_[j - 1] : Horizontal{})) / pivot;
      above = below;
    }
    for (std::size_t j = cells - 1; j-- > 0;) w_[j] += upper_[j] * w_[j + 1];
  }

  static constexpr Horizontal i_{0, 1};
  std::vector<Horizontal> w_;
  std::vector<double> upper_;
  std::array<double, cells> viscosity_{};
};

}  // namespace

UnlikeOcean::UnlikeOcean(std::uint64_t seed, UtcDay first_day, int days) : start_(first_day) {
  expects(days > 0, "an ocean lasts some days");
  const auto hours = static_cast<std::size_t>(24 * days + 2);
  constexpr std::size_t spin_up = 96;
  const auto stream = [&](const char* name) {
    return Rng(seed, "tests/unlike_ocean/" + std::string(name));
  };
  Rng weather = stream("wind");
  Rng analysis = stream("analysis");
  Rng eddies = stream("interior");
  Rng jets = stream("fronts");
  Rng season = stream("season");
  Forcing forcing;
  forcing.wind = smooth_series(spin_up + hours, 5.0, 24.0, 3.0, weather);
  const Horizontal prevailing = std::polar(3.0, 2 * std::numbers::pi * season.uniform());
  for (Horizontal& wind : forcing.wind) wind += prevailing;
  forcing.interior = smooth_series(spin_up + hours, 0.07, 90.0, 20.0, eddies);
  forcing.jet = fronts(spin_up + hours, jets);
  forcing.layer_m = 11.0 + 14.0 * season.uniform();
  const std::vector<Horizontal> error = smooth_series(hours, 1.0, 6.0, 0.7, analysis);
  Water water;
  for (std::size_t h = 0; h + 1 < spin_up + hours; ++h) {
    if (h >= spin_up) {
      const auto& now = water.cells_now();
      current_.insert(current_.end(), now.begin(), now.end());
      wind_.push_back(forcing.wind[h]);
      analysed_wind_.push_back(forcing.wind[h] + error[h - spin_up]);
    }
    for (int s = 0; s < steps_an_hour; ++s)
      water.step(forcing, static_cast<double>(h) + static_cast<double>(s) / steps_an_hour);
  }
}

Horizontal UnlikeOcean::hourly(const std::vector<Horizontal>& series, UtcTime time) const {
  const double hour = hours_between(start_, time);
  expects(hour >= 0 && hour <= static_cast<double>(series.size() - 1), "a time of this ocean");
  const auto h = std::min(static_cast<std::size_t>(hour), series.size() - 2);
  const double share = hour - static_cast<double>(h);
  return (1 - share) * series[h] + share * series[h + 1];
}

Horizontal UnlikeOcean::wind(UtcTime time) const { return hourly(wind_, time); }
Horizontal UnlikeOcean::analysed_wind(UtcTime time) const { return hourly(analysed_wind_, time); }

Horizontal UnlikeOcean::current(UtcTime time, double depth_m) const {
  const double hour = hours_between(start_, time);
  const std::size_t hours = current_.size() / cells;
  expects(hour >= 0 && hour <= static_cast<double>(hours - 1), "a time of this ocean");
  const auto h = std::min(static_cast<std::size_t>(hour), hours - 2);
  const double later = hour - static_cast<double>(h);
  const double x = std::clamp(depth_m / cell_m - 0.5, 0.0, static_cast<double>(cells - 1));
  const auto j = std::min(static_cast<std::size_t>(x), cells - 2);
  const double deeper = x - static_cast<double>(j);
  const auto at = [&](std::size_t hour_of) {
    return (1 - deeper) * current_[hour_of * cells + j] +
           deeper * current_[hour_of * cells + j + 1];
  };
  return (1 - later) * at(h) + later * at(h + 1);
}

}  // namespace slackwater::tests
