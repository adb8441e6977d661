#pragma once
#include <vector>

namespace slackwater::twin {

/// What a black body radiates within a band of wavelengths, W/(m2 sr), and back: Planck's law,
///
///   B(T) = int_l1^l2 2 h c^2 / (l^5 (exp(hc/(l k T)) - 1)) dl
///        = sigma T^4/pi (F(l2 T) - F(l1 T)),
///   F = 15/pi^4 sum_n exp(-n x)/n (x^3 + 3 x^2/n + 6 x/n^2 + 6/n^3),   x = c2/(l T),
///
/// held in a table of tenths of a kelvin from 150 to 500 K, and linear in between: within 1e-5 of
/// B, and both ways each other's inverse. Outside it is held.
/// Sources: Chang and Rhee (1984), Int. Comm. Heat Mass Transfer 11, 451 (the sum); CODATA 2018.
class BandRadiance {
 public:
  /// @param from_m, to_m  wavelengths, from 1 um on
  BandRadiance(double from_m, double to_m);

  [[nodiscard]] double of(double temperature_k) const noexcept;
  /// The temperature of a black body that radiates so: the apparent one.
  [[nodiscard]] double temperature_k(double radiance) const noexcept;
  /// dB/dT, W/(m2 sr K), of the table's step.
  [[nodiscard]] double slope(double temperature_k) const noexcept;

  /// By the sum, without the table.
  [[nodiscard]] static double exact(double from_m, double to_m, double temperature_k) noexcept;

 private:
  static constexpr double coldest_k = 150, step_k = 0.1;
  static constexpr std::size_t steps = 3500;
  [[nodiscard]] std::size_t step_of(double temperature_k) const noexcept;
  std::vector<double> radiance_;
};

}  // namespace slackwater::twin
