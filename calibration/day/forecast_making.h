#pragma once
#include <optional>
#include <string>
#include <vector>

namespace slackwater::calibration {

struct DailyForecast;

/// How a forecast was made, as far as its readers are told: of its first column.
struct ForecastMaking {
  struct FittedParameter {
    std::string name;
    std::string unit;
    double value = 0;
    double prior = 0;
    bool at_bound = false;
    bool weakly_determined = false;
    friend bool operator==(const FittedParameter&, const FittedParameter&) = default;
  };
  struct Fit {
    std::vector<FittedParameter> parameters;
    double rms_m_s = 0;
    std::size_t observations = 0;
    std::string termination;
    friend bool operator==(const Fit&, const Fit&) = default;
  };
  struct Share {
    std::string method;
    double weight = 0;
    friend bool operator==(const Share&, const Share&) = default;
  };
  /// What was mixed.
  struct Mixture {
    std::vector<std::vector<Share>> by_day;  ///< of lead, at least one; the same methods in each
    std::string provenance;
    double spread_scale = 1;
    std::string spread_provenance;
    std::size_t simulated_days = 0;  ///< rehearsed with a run of the wind that was simulated
    friend bool operator==(const Mixture&, const Mixture&) = default;
  };
  /// The highest of the waves that were computed from the wind over an assumed fetch.
  struct HighestWave {
    double as_assumed_m = 0;
    double half_fetch_m = 0;
    double twice_fetch_m = 0;
    friend bool operator==(const HighestWave&, const HighestWave&) = default;
  };
  std::optional<Fit> fit;
  std::string no_fit;                       ///< why there is none
  std::optional<Mixture> mixture;           ///< absent: no current is forecast
  std::vector<std::string> sources;         ///< whose values count, in words
  std::vector<std::string> notes;           ///< in words
  std::optional<HighestWave> highest_wave;  ///< absent: the fetch is given, or a product's waves
  friend bool operator==(const ForecastMaking&, const ForecastMaking&) = default;
};

[[nodiscard]] ForecastMaking making_of(const DailyForecast& forecast);

}  // namespace slackwater::calibration
