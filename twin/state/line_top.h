#pragma once
#include "twin/body/spatial.h"

namespace slackwater::twin {

/// The upper end of a tether, NED: fixed, or on the deck of a carrier, where it is that of the last
/// barrier, carried on at its velocity of then. Numbers only.
struct LineTop {
  Triple<double> place_m;  ///< at `since_s`
  Triple<double> velocity_m_s;
  double since_s = 0;
  Triple<double> pull_n;  ///< of the line on it, in the line's last step

  [[nodiscard]] Triple<double> at(double t_s) const noexcept {
    return place_m + (t_s - since_s) * velocity_m_s;
  }
};

/// How the lines that hang from a vehicle's deck pull at it, NED, about its origin: as of the last
/// barrier, and held until the next. Numbers only.
struct LinesBorne {
  Triple<double> force_n;
  Triple<double> moment_n_m;
};

}  // namespace slackwater::twin
