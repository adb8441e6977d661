#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "api/made_up/synthetic/coast.h"
#include "api/made_up/synthetic/random_series.h"
#include "api/made_up/synthetic/tide.h"
#include "api/made_up/synthetic/wave_growth.h"
#include "api/made_up/synthetic/weather.h"
#include "api/made_up/synthetic/wind_driven_column.h"
#include "fields/base/frame.h"
#include "fields/base/time.h"
#include "fields/geo/geo_point.h"

namespace slackwater::api {

/// Everything that determines a synthetic ocean.
struct SyntheticOceanSettings {
  std::uint64_t seed = 2025;
  UtcDay first_day = UtcDay(std::chrono::year{2025} / 3 / 3);
  int days = 12;  ///< the truth can be asked from first_day - 1 to first_day + days
  GeoPoint site = GeoPoint::from_degrees(48.85, -2.55);  ///< off Saint-Brieuc
  double site_depth_m = 35;
  ColumnMixing site_mixing{.eddy_viscosity_m2_s = 0.02, .bottom_friction_m_s = 1.2e-3};
};

/// What an ocean model's run says of the current minus the truth, at the surface: 1.2 cm/s per
/// component where it is an analysis (valid before the issue time, the same in every run), growing
/// by 1.5 cm/s a day of lead, drawn anew for each run. Smooth in time and space. The ocean must
/// outlive it.
class OceanModelError {
 public:
  OceanModelError(const RandomVectorField& analysis, std::uint64_t run_seed, UtcTime epoch,
                  UtcTime issued);
  [[nodiscard]] Horizontal at(PlanePoint point, UtcTime time) const noexcept;

 private:
  const RandomVectorField* analysis_;
  RandomVectorField growth_;
  UtcTime epoch_;
  UtcTime issued_;
};

/// A coastal ocean with known truth: the demonstration's sea, and the oracle of twin experiments.
///
///   U(x, y, z, t) = interior + tide + wind-driven,   Eulerian, towards, ENU
///
/// The interior drifts over days inside a bottom Ekman layer; the tide is `Tide`; the wind-driven
/// part is the column with memory of `WindDrivenColumn` under the stress 1.225 (0.79 + 0.08 |w|)
/// 1e-3 |w| w of `Weather`. Waves grow from that wind. Products and weather forecasts see it with
/// errors that are drawn from the same seed. The truth is a function of the settings alone.
/// Immutable after construction, which takes some 0.1 s; copies share nothing.
class SyntheticOcean {
 public:
  explicit SyntheticOcean(const SyntheticOceanSettings& settings = {});

  [[nodiscard]] const SyntheticOceanSettings& settings() const noexcept { return settings_; }
  /// The times for which truth exists, both included. Asking outside is a ContractViolation.
  [[nodiscard]] UtcTime begin() const noexcept { return epoch_ - std::chrono::hours{24}; }
  [[nodiscard]] UtcTime end() const noexcept { return epoch_ + std::chrono::days{settings_.days}; }

  /// The true current; nothing on land, below the bed or above the surface.
  [[nodiscard]] std::optional<Horizontal> current_truth(const GeoPoint& point, double depth_m,
                                                        UtcTime time) const;
  /// The wind-driven part alone.
  [[nodiscard]] std::optional<Horizontal> wind_driven_truth(const GeoPoint& point, double depth_m,
                                                            UtcTime time) const;
  [[nodiscard]] Horizontal wind_truth(const GeoPoint& point,
                                      UtcTime time) const;  ///< 10 m, towards
  [[nodiscard]] std::optional<SyntheticSea> sea_truth(const GeoPoint& point,
                                                      UtcTime time) const;  ///< not on land
  [[nodiscard]] std::optional<double> elevation_truth_m(const GeoPoint& point, UtcTime time) const;
  [[nodiscard]] double water_depth_m(const GeoPoint& point) const;  ///< see Coast::depth_m for land
  [[nodiscard]] bool is_land(const GeoPoint& point) const;
  [[nodiscard]] PlanePoint plane(const GeoPoint& point) const noexcept {
    return coast_.plane(point);
  }
  /// The mixing that the truth was made with, here: what a calibration should find.
  [[nodiscard]] ColumnMixing mixing_truth(const GeoPoint& point) const;
  [[nodiscard]] double coriolis_rad_s() const noexcept { return physics_.coriolis_rad_s; }

  [[nodiscard]] OceanModelError model_error(UtcTime issued) const;
  [[nodiscard]] WeatherForecast weather_forecast(UtcTime issued) const;
  [[nodiscard]] double hours_since_epoch(UtcTime time) const noexcept {
    return hours_between(epoch_, time);
  }

 private:
  friend class CurrentSeries;
  [[nodiscard]] double checked_hours(UtcTime time) const;
  [[nodiscard]] Horizontal interior_far_from_bed(PlanePoint point, double hours) const noexcept;
  [[nodiscard]] Horizontal wind_driven(PlanePoint point, double water_depth_m, double depth_m,
                                       double hours) const noexcept;

  SyntheticOceanSettings settings_;
  UtcTime epoch_;
  ColumnPhysics physics_;
  Coast coast_;
  Weather weather_;
  WaveGrowth waves_;
  RandomVectorField interior_;
  RandomVectorField analysis_error_;
  WindDrivenColumn quadratic_;  ///< driven by the part of the stress that goes with |w| w
  WindDrivenColumn cubic_;      ///< ... and with |w|^2 w
};

/// The current over many times at one place: what does not depend on time is computed once.
class CurrentSeries {
 public:
  /// Depths below the bed stay without value. The ocean must outlive the series.
  CurrentSeries(const SyntheticOcean& ocean, const GeoPoint& point,
                std::span<const double> depths_m);
  /// Writes one velocity per depth, NaN on land and below the bed.
  void at(UtcTime time, std::span<Horizontal> velocity_m_s) const;

 private:
  const SyntheticOcean* ocean_;
  PlanePoint point_;
  double water_depth_m_ = 0;
  std::vector<double> depth_m_;
  std::vector<Tide::RotaryParts> tide_;      ///< per wet depth
  std::vector<Horizontal> interior_factor_;  ///< per wet depth
};

}  // namespace slackwater::api
