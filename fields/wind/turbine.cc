#include "fields/wind/turbine.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "fields/base/config.h"

namespace slackwater {
namespace {

constexpr double betz_limit = 16.0 / 27.0;

void check_lengths(const Config& config, const std::vector<double>& speed,
                   const std::vector<double>& column, std::string_view key) {
  if (column.size() != speed.size()) {
    config.refuse(key, "found " + std::to_string(column.size()) + " values beside " +
                           std::to_string(speed.size()) +
                           " of wind_speed_m_s; give one for each wind speed");
  }
}

}  // namespace

Turbine Turbine::load(const std::filesystem::path& file) { return read(Config::load(file)); }

Turbine Turbine::parse(std::string_view yaml, std::string_view name) {
  return read(Config::parse(yaml, name));
}

Turbine Turbine::read(const Config& config) {
  Turbine out;
  out.name = config.text("name");
  out.source = config.text("source");
  out.rotor_diameter_m = config.number("rotor_diameter_m", {1, 500});
  out.hub_height_m = config.number("hub_height_m", {1, 500});
  out.rated_power_w = config.number("rated_power_w", {1e3, 1e8});
  out.cut_in_speed_m_s = config.number("cut_in_speed_m_s", {0.1, 20});
  out.rated_speed_m_s = config.number("rated_speed_m_s", {1, 40});
  out.cut_out_speed_m_s = config.number("cut_out_speed_m_s", {1, 60});
  out.air_density_kg_m3 = config.number("air_density_kg_m3", {0.8, 1.5});
  out.wind_speed_m_s_ = config.numbers("wind_speed_m_s", {0, 60});
  out.power_coefficient_ = config.numbers("power_coefficient", {0, betz_limit});
  out.thrust_coefficient_ = config.numbers("thrust_coefficient", {0, 0.999});
  config.expect_all_read();

  const std::vector<double>& speed = out.wind_speed_m_s_;
  if (speed.size() < 2) {
    config.refuse("wind_speed_m_s", "found fewer than two wind speeds; give the whole curve");
  }
  check_lengths(config, speed, out.power_coefficient_, "power_coefficient");
  check_lengths(config, speed, out.thrust_coefficient_, "thrust_coefficient");
  if (std::adjacent_find(speed.begin(), speed.end(), std::greater_equal<>()) != speed.end()) {
    config.refuse("wind_speed_m_s", "found speeds that do not rise; sort the rows by wind speed");
  }
  if (speed.front() != out.cut_in_speed_m_s || speed.back() != out.cut_out_speed_m_s) {
    config.refuse("wind_speed_m_s",
                  "the curve must begin at cut_in_speed_m_s and end at cut_out_speed_m_s");
  }
  if (2 * out.hub_height_m <= out.rotor_diameter_m) {
    config.refuse("hub_height_m", "the blades would strike the sea; check rotor_diameter_m");
  }
  return out;
}

double Turbine::look_up(const std::vector<double>& column, double speed_m_s) const noexcept {
  if (std::isnan(speed_m_s)) return speed_m_s;
  if (speed_m_s < cut_in_speed_m_s || speed_m_s > cut_out_speed_m_s) return 0;
  const auto above =
      std::upper_bound(wind_speed_m_s_.begin(), wind_speed_m_s_.end() - 1, speed_m_s);
  const auto i = static_cast<std::size_t>(above - wind_speed_m_s_.begin());
  const double step = wind_speed_m_s_[i] - wind_speed_m_s_[i - 1];
  const double weight = (speed_m_s - wind_speed_m_s_[i - 1]) / step;
  return column[i - 1] + weight * (column[i] - column[i - 1]);
}

double Turbine::power_coefficient(double speed_m_s) const noexcept {
  return look_up(power_coefficient_, speed_m_s);
}

double Turbine::thrust_coefficient(double speed_m_s) const noexcept {
  return look_up(thrust_coefficient_, speed_m_s);
}

double Turbine::power_w(double speed_m_s) const noexcept {
  const double power = 0.5 * air_density_kg_m3 * rotor_area_m2() * power_coefficient(speed_m_s) *
                       speed_m_s * speed_m_s * speed_m_s;
  return power > rated_power_w ? rated_power_w : power;
}

}  // namespace slackwater
