#pragma once
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "fields/current/local_flow.h"
#include "fields/service/field.h"
#include "fields/wave/sea_realisation.h"
#include "fields/wind/farm_flow.h"
#include "twin/body/body.h"
#include "twin/environment/weather_in_hand.h"
#include "twin/risk/wave_futures.h"
#include "twin/scene/structure.h"

namespace slackwater::twin {

/// A foundation that turns the current aside, between its ends.
struct StandingPile {
  Pile pile;
  Horizontal axis_m;                                          ///< east, north of the site's origin
  double top_m = -std::numeric_limits<double>::infinity();    ///< z, down
  double bottom_m = std::numeric_limits<double>::infinity();  ///< z, down
};

/// The turbines of a site.
struct StandingTurbines {
  std::shared_ptr<const Turbine> kind;  ///< of all of them
  std::vector<Horizontal> at_m;         ///< east, north of the origin
};

/// What the vehicles of a run live in: one member of a forecast, a sea of sinusoids, turbines and
/// foundations. Shared by any threads; immutable, but for the weather in somebody's hand.
struct Environment {
  std::shared_ptr<const Field> field;
  std::size_t member = 0;
  GeoPoint origin;                            ///< of the local frame
  UtcTime epoch;                              ///< t_s = 0
  std::shared_ptr<const SeaRealisation> sea;  ///< about the same origin and epoch; null: calm
  double sea_peak_period_s = 0;               ///< that its sinusoids were made of
  /// The state of a sea that is not the forecast's, the same at all times; absent: as forecast.
  std::optional<SeaState> stated_sea;
  /// What the heights of the member's waves are instead of the forecast's; null: as forecast.
  std::shared_ptr<const WaveFutures> waves;
  std::shared_ptr<const FarmFlow> farm;      ///< null: no wakes
  std::optional<StandingTurbines> turbines;  ///< absent: the site has none
  std::vector<StandingPile> piles;
  std::vector<Structure> structures;       ///< that a vehicle can strike
  std::shared_ptr<WeatherInHand> weather;  ///< null: nobody may lead it
};

/// Degrees per metre at a site: the plane that a run's positions lie in.
///
/// Ten kilometres off along the diagonal the plane is tan(latitude) d^2/R, some 20 m, from where
/// the ellipsoid has the place: a hundredth of a cell of the finest product. Waypoints in degrees
/// are turned into metres by the exact `LocalFrame`.
struct DegreesPerMetre {
  double east = 0;
  double north = 0;
};
[[nodiscard]] DegreesPerMetre degrees_per_metre(const GeoPoint& origin) noexcept;

/// The water at a place.
struct WaterSample {
  FluidMotion<double> motion;
  Triple<double> current_m_s;                   ///< of it, NED, without the waves
  SampleStatus status = SampleStatus::missing;  ///< ok where the numbers hold
};

/// Samples an environment, with what it needs worked out once. Const, thread-safe, no allocation,
/// no lock.
class EnvironmentSampler {
 public:
  explicit EnvironmentSampler(const Environment& environment);

  /// Current and orbital motion, mean over a hull of `height_m` about the position (NED), with the
  /// shear of the current over it. A place above the surface has the water of the surface and no
  /// orbital motion.
  [[nodiscard]] WaterSample water(const Triple<double>& position_m, double height_m,
                                  double t_s) const noexcept;
  /// The same without the waves: what a craft that meets them by `waves_at_strips` has besides.
  [[nodiscard]] WaterSample current(const Triple<double>& position_m, double height_m,
                                    double t_s) const noexcept;
  /// The current of the forecast at a point, as if no foundation stood in it: limits are on that.
  [[nodiscard]] CurrentSample forecast_current(const Triple<double>& position_m,
                                               double t_s) const noexcept;
  /// The mean wind, NED, with what wakes leave of it. Heights are held within those of the profile.
  struct Wind {
    Triple<double> velocity_m_s;
    double ratio = 1;  ///< of the wake
    SampleStatus status = SampleStatus::missing;
  };
  [[nodiscard]] Wind wind(const Triple<double>& position_m, double t_s) const noexcept;
  /// The same as if no rotor turned there.
  [[nodiscard]] Wind free_wind(const Triple<double>& position_m, double t_s) const noexcept;
  /// What wakes make of the standard deviation of the gusts there: 1 outside of them, more where
  /// rotors stir the air. A wind that is led has as much more of them as it is stronger.
  [[nodiscard]] double gust_ratio(const Triple<double>& position_m, double t_s) const noexcept;
  /// The flow of the farm for the wind now, the sinusoids of the sea now; null: none.
  [[nodiscard]] const FarmFlow* farm() const noexcept;
  [[nodiscard]] const SeaRealisation* waves() const noexcept;
  /// How far one sees in air and under water, where somebody says so; the run itself does not.
  [[nodiscard]] std::optional<double> visibility_m() const noexcept;
  [[nodiscard]] std::optional<double> water_visibility_m() const noexcept;
  /// The state of the sea there and then: that of the forecast with the member's error of its
  /// height, if it has one, or the state that was stated.
  [[nodiscard]] SeaSample sea(const Triple<double>& position_m, double t_s) const noexcept;
  /// Above mean sea level, of the environment's member. The tide moves no vehicle: the water that
  /// it swims in keeps its surface at mean sea level.
  [[nodiscard]] SeaLevelSample sea_level(const Triple<double>& position_m,
                                         double t_s) const noexcept;
  /// m; what the field says of the bed there.
  [[nodiscard]] BedSample bed(const Triple<double>& position_m) const noexcept;

  [[nodiscard]] const Environment& environment() const noexcept { return *environment_; }

 private:
  [[nodiscard]] Place place(const Triple<double>& position_m, double vertical_m,
                            double t_s) const noexcept;
  /// Null: nothing of the weather is led.
  [[nodiscard]] const WeatherNow* led() const noexcept;
  /// The current of the forecast, led.
  [[nodiscard]] Horizontal led_current(Horizontal forecast_m_s, double t_s) const noexcept;
  const Environment* environment_;
  DegreesPerMetre per_m_;
};

/// A sampler that keeps its environment alive, so that agents outlive what they were set up from.
[[nodiscard]] std::shared_ptr<const EnvironmentSampler> sampler_of(
    const std::shared_ptr<const Environment>& environment);

}  // namespace slackwater::twin
