#pragma once
#include <optional>

#include "twin/environment/environment.h"

namespace slackwater::people {

/// What the turbines of a site make now.
struct FarmNow {
  double power_w = 0, rated_w = 0;
  std::size_t turbines = 0;
};

/// What they make of the wind, wakes and all. Worked out anew once the wind is
/// another by what changes the answer; not thread-safe.
class FarmOutput {
 public:
  explicit FarmOutput(twin::StandingTurbines turbines) : turbines_(std::move(turbines)) {}
  /// @param hub_wind_m_s  free wind at hub height, towards
  [[nodiscard]] FarmNow at(Horizontal hub_wind_m_s);

 private:
  twin::StandingTurbines turbines_;
  std::optional<Horizontal> worked_out_for_m_s_;
  FarmNow now_;
};

}  // namespace slackwater::people
