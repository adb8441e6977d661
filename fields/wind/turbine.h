#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "fields/base/angle.h"
#include "fields/base/constants.h"

namespace slackwater {

class Config;

/// A wind turbine as its curves: what it draws from the wind that meets its rotor.
///
/// Loaded once from `data/turbines/*.yaml` and shared; the curves are looked up without allocation.
class Turbine {
 public:
  /// Throws Error(not_found) or Error(invalid_input): wind speeds must rise from cut-in to cut-out,
  /// the three columns be equally long, 0 <= Cp <= 16/27 (Betz) and 0 <= Ct < 1.
  [[nodiscard]] static Turbine load(const std::filesystem::path& file);
  [[nodiscard]] static Turbine parse(std::string_view yaml, std::string_view name);

  /// Electrical power (W) from the mean wind over the rotor, 0.5 rho A Cp(U) U^3, held at rated
  /// power; Cp is linear between the rows. 0 below cut-in and above cut-out; NaN for NaN.
  [[nodiscard]] double power_w(double speed_m_s) const noexcept;
  /// Thrust coefficient, linear between the rows. 0 below cut-in and above cut-out (a parked rotor
  /// leaves no wake that these models know); NaN for NaN.
  [[nodiscard]] double thrust_coefficient(double speed_m_s) const noexcept;
  /// Cp as tabulated, without the limit of rated power.
  [[nodiscard]] double power_coefficient(double speed_m_s) const noexcept;

  [[nodiscard]] double rotor_area_m2() const noexcept {
    return 0.25 * constants::pi * rotor_diameter_m * rotor_diameter_m;
  }
  [[nodiscard]] bool operator==(const Turbine&) const = default;

  std::string name;
  std::string source;
  double rotor_diameter_m = 0;
  double hub_height_m = 0;
  double rated_power_w = 0;
  double rated_speed_m_s = 0;
  double cut_in_speed_m_s = 0;
  double cut_out_speed_m_s = 0;
  double air_density_kg_m3 = constants::air_density_kg_m3;

 private:
  static Turbine read(const Config& config);
  [[nodiscard]] double look_up(const std::vector<double>& column, double speed_m_s) const noexcept;
  std::vector<double> wind_speed_m_s_;
  std::vector<double> power_coefficient_;
  std::vector<double> thrust_coefficient_;
};

}  // namespace slackwater
