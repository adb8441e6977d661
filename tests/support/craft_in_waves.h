#pragma once
#include <cmath>
#include <complex>

#include "fields/wave/sea_sampling.h"
#include "tests/support/surface_craft.h"
#include "twin/body/waves_at_strips.h"

namespace slackwater::tests {

/// In deep water.
struct RegularWave {
  double length_m = 0;
  double amplitude_m = 0;
  double from_direction_deg = 0;

  [[nodiscard]] double wavenumber() const { return 2 * constants::pi / length_m; }
  [[nodiscard]] double omega() const { return std::sqrt(constants::gravity_m_s2 * wavenumber()); }
  [[nodiscard]] SeaRealisation sea() const {
    const WaveWater deep{2000, {}};
    return {{wave_component(amplitude_m, omega(), FrequencyFrame::absolute, from_direction_deg, 0.3,
                            deep)
                 .value()},
            deep,
            UtcTime{}};
  }
};

/// What a craft does over what the surface under its middle does: amplitude and phase.
struct Response {
  std::complex<double> heave;    ///< of rise over elevation
  std::complex<double> pitch;    ///< bow up, over the slope along the heading
  std::complex<double> roll;     ///< over the slope that falls to starboard
  std::complex<double> carried;  ///< of its velocity along the wave over that of the water
  double drift_m_s = 0;          ///< along the wave
};

/// Above still water, where the craft is.
inline double elevation(const SeaRealisation& sea, double north_m, double east_m, double t_s) {
  const WavePlace at{east_m, north_m, 0, t_s};
  double out = 0;
  sample_elevation(sea, {&at, 1}, {&out, 1});
  return out;
}

/// Heading north.
inline Response respond(const twin::Body& body, const RegularWave& wave) {
  using namespace twin;
  const SeaRealisation sea = wave.sea();
  const double period_s = 2 * constants::pi / wave.omega();
  const int per_period = static_cast<int>(std::ceil(period_s / 0.04));
  const double dt_s = period_s / per_period;
  BodyState<double> state = afloat(body);
  const double rest_m = state.position_m.z;
  // Long enough for the free oscillations to die away, and then some whole periods.
  const int settling = static_cast<int>(std::ceil(60 / period_s)) + 4;
  constexpr int measured = 8;
  std::complex<double> rise, surface, pitch, along, roll, across, moved, flowed;
  Triple<double> from{};
  const double to = (wave.from_direction_deg + 180) * constants::pi / 180;
  for (int i = 0; i < (settling + measured) * per_period; ++i) {
    const double t = i * dt_s;
    const WaterAtStrips<double> water = waves_at_strips(sea, t + 0.5 * dt_s, body.hull, state);
    Forcing<double> forcing;
    forcing.waves = waves_met(body.hull, water);
    if (i == settling * per_period) from = state.position_m;
    if (i >= settling * per_period) {
      const auto turn = std::polar(1.0, -wave.omega() * t);
      const EulerAngles at = euler_angles(state.attitude);
      const double x = state.position_m.x, y = state.position_m.y, d = 0.01 * wave.length_m;
      const Triple<double> v = rotation_of(state.attitude).to_ned(state.nu.linear);
      moved += turn * (v.x * std::cos(to) + v.y * std::sin(to));
      // In deep water that of the surface is omega times its elevation.
      flowed += turn * (wave.omega() * elevation(sea, x, y, t));
      rise += turn * (rest_m - state.position_m.z);
      pitch += turn * at.pitch_rad;
      roll += turn * at.roll_rad;
      surface += turn * elevation(sea, x, y, t);
      along += turn * ((elevation(sea, x + d, y, t) - elevation(sea, x - d, y, t)) / (2 * d));
      across -= turn * ((elevation(sea, x, y + d, t) - elevation(sea, x, y - d, t)) / (2 * d));
    }
    state = stepped(body, state, forcing, dt_s);
  }
  const Triple<double> gone = state.position_m - from;
  return {rise / surface, pitch / along, roll / across, moved / flowed,
          (gone.x * std::cos(to) + gone.y * std::sin(to)) / (measured * period_s)};
}

}  // namespace slackwater::tests
