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
  std::optional<Fit> fit;
  std::string no_fit;                ///< why there is none
  std::optional<Mixture> mixture;    ///< absent: no current is forecast
  std::vector<std::string> sources;  ///< whose values count, in words
  std::vector<std::string> notes;    ///< in words
  friend bool operator==(const ForecastMaking&, const ForecastMaking&) = default;
};

[[nodiscard]] ForecastMaking making_of(const DailyForecast& forecast);

}  // namespace slackwater::calibration
