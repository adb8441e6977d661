#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "fields/base/frame.h"
#include "fields/base/numbers/random.h"
#include "fields/base/time.h"

namespace slackwater::api {

/// Place on the plane of the synthetic ocean, metres east and north of its site.
struct PlanePoint {
  double east_m = 0;
  double north_m = 0;
};

/// A smooth random vector field in time and space, drawn once and then analytic:
///
///   w(x, y, t) = s sqrt(1/n) sum_j exp{i [w_j t + k_j x + l_j y + p_j]},
///
/// with n terms, frequencies of both senses of rotation and random phases. The standard deviation
/// of each component over the ensemble of draws is s / sqrt 2. Same seed and stream name: same
/// field, on every machine.
class RandomVectorField {
 public:
  struct Scales {
    double component_sigma_m_s = 0;  ///< standard deviation of the east and of the north component
    double shortest_period_h = 12;   ///< periods are spread evenly in frequency between the two
    double longest_period_h = 48;
    double shortest_wavelength_m = 1e5;  ///< horizontal; large means nearly uniform
    int terms = 12;
  };
  RandomVectorField(const Scales& scales, std::uint64_t run_seed, std::string_view stream_name);
  /// The field `hours` after the ocean's epoch. No allocation, thread-safe.
  [[nodiscard]] Horizontal at(PlanePoint point, double hours) const noexcept;

 private:
  struct Term {
    double frequency_rad_h = 0;
    double east_rad_m = 0;
    double north_rad_m = 0;
    double phase_rad = 0;
  };
  std::vector<Term> terms_;
  double amplitude_m_s_ = 0;
};

}  // namespace slackwater::api
