#pragma once
#include <algorithm>
#include <cmath>

namespace slackwater::twin {

/// How a place on a vessel goes up and down, over the last minutes: exponentially weighted moments
/// of its height and its vertical velocity. Numbers only.
struct DeckMotion {
  double mean_m = 0;
  double variance_m2 = 0;
  double velocity_variance_m2_s2 = 0;
  double weight = 0;  ///< 0: nothing seen yet; towards 1

  /// @param memory_s  how long a look counts (1/e)
  void look(double down_m, double down_m_s, double since_last_s, double memory_s = 120) noexcept {
    const double keep = std::exp(-since_last_s / memory_s), take = 1 - keep;
    weight = keep * weight + take;
    const double share = take / weight;
    const double off_m = down_m - mean_m;
    mean_m += share * off_m;
    variance_m2 = (1 - share) * (variance_m2 + share * off_m * off_m);
    velocity_variance_m2_s2 += share * (down_m_s * down_m_s - velocity_variance_m2_s2);
  }
  /// Four standard deviations: the significant height of the motion, crest to trough.
  [[nodiscard]] double significant_m() const noexcept { return 4 * std::sqrt(variance_m2); }
  /// Two standard deviations of its acceleration, as of a narrow band: sigma_a = sigma_v^2/sigma_z.
  [[nodiscard]] double significant_acceleration_m_s2() const noexcept {
    return variance_m2 > 1e-12 ? 2 * velocity_variance_m2_s2 / std::sqrt(variance_m2) : 0;
  }
};

/// The mass with which a vessel's bow, at `forward_m` of its centre, resists a push up or down:
/// 1/m = 1/m_heave + x^2/I_pitch, added masses with them.
[[nodiscard]] inline double bow_mass_kg(double heave_kg, double pitch_kg_m2,
                                        double forward_m) noexcept {
  return 1 / (1 / heave_kg + forward_m * forward_m / pitch_kg_m2);
}

}  // namespace slackwater::twin
