#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "api/ask/rehearse/rehearsal.h"
#include "api/show/rehearse/rehearsal_json.h"
#include "fields/base/numbers/quantile.h"

namespace slackwater::api {

/// What came of one part of a vehicle's work, flight by flight: of all flights or, where the
/// vehicle has no such work, of none.
template <typename Outcome>
class OverFlights {
 public:
  OverFlights(const StartOutcome& start, std::size_t vehicle,
              std::optional<Outcome> twin::VehicleAccount::*part) {
    for (const twin::Flight& flight : start.flights)
      if (const auto& outcome = flight.vehicles[vehicle].*part) all_.push_back(&*outcome);
  }
  [[nodiscard]] bool empty() const noexcept { return all_.empty(); }
  [[nodiscard]] const Outcome& first() const { return *all_.front(); }
  [[nodiscard]] auto begin() const noexcept { return all_.begin(); }
  [[nodiscard]] auto end() const noexcept { return all_.end(); }

  /// @param of  a number of an outcome
  template <typename Of>
  [[nodiscard]] std::vector<double> values(const Of& of) const {
    std::vector<double> values;
    for (const Outcome* outcome : all_) values.push_back(of(*outcome));
    return values;
  }
  /// P10, P50 and P90.
  template <typename Of>
  [[nodiscard]] nlohmann::json quantiles(const Of& of) const {
    return quantiles_json(values(of));
  }
  template <typename Of>
  [[nodiscard]] double quantile(double share, const Of& of) const {
    return quantile_of(values(of), share).value_or(0);
  }

 private:
  std::vector<const Outcome*> all_;
};

}  // namespace slackwater::api
