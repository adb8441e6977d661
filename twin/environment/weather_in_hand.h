#pragma once
#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/frame.h"
#include "fields/base/lead.h"
#include "fields/wave/sea_realisation.h"
#include "fields/wind/farm_flow.h"

namespace slackwater::twin {

struct Environment;

/// What the weather of a run is from now on, for training: whatever is absent is as the run has it
/// by itself (its forecast, or the water that its scenario makes up).
struct WeatherAsked {
  std::optional<Horizontal> wind_10m_m_s;  ///< east, north, towards: at 10 m, all over the run
  std::optional<double> significant_wave_height_m;  ///< of the same waves: period, direction stay
  std::optional<Horizontal> current_m_s;            ///< east, north, towards: at all depths
  std::optional<double> visibility_m;               ///< in air: meteorological optical range
  std::optional<double> water_visibility_m;         ///< of a black disc
  double over_s = 60;                               ///< until it is so: in a straight line
  bool operator==(const WeatherAsked&) const = default;
};
inline constexpr double least_over_s = 1, most_over_s = 3600;

/// What is led of the weather, and what follows from it. A value: the next one is another.
struct WeatherNow {
  WeatherAsked asked;    ///< last
  double settled_s = 0;  ///< when it is as asked
  Lead<Horizontal> wind_10m_m_s;
  Lead<double> significant_wave_height_m;
  Lead<Horizontal> current_m_s;
  std::shared_ptr<const SeaRealisation> sea;  ///< its height led; null: the run's own
  std::shared_ptr<const FarmFlow> farm;       ///< of the wind to come; null: the run's own
};

/// The weather in the hand of a supervisor. The one part of an environment that changes: between
/// two steps, on the thread of the run. What was asked is on the record of its commands, so that a
/// run made again has the same. Readers on any thread have the last one whole; no lock.
class WeatherInHand {
 public:
  WeatherInHand() = default;
  WeatherInHand(const WeatherInHand&) = delete;
  WeatherInHand& operator=(const WeatherInHand&) = delete;

  /// Null: as the run has it by itself. What it points at stays while the run does.
  [[nodiscard]] const WeatherNow* now() const noexcept {
    return now_.load(std::memory_order_acquire);
  }
  /// @param environment  that this is of
  /// @param t_s          from when on; not before the last one's
  void set(const WeatherAsked& asked, const Environment& environment, double t_s);
  /// Of a run that is taken up from a checkpoint, or not begun yet: nobody looks.
  void forget();

 private:
  std::vector<std::unique_ptr<const WeatherNow>> all_;
  std::atomic<const WeatherNow*> now_ = nullptr;
};

/// What speaks against it in an environment, for people; empty: nothing. Ranges as those of
/// scenarios; waves of the run's period are not higher than they can stand (`steepest_height_m`).
[[nodiscard]] std::string problem_of(const WeatherAsked& asked, const Environment& environment);

}  // namespace slackwater::twin
