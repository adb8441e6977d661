#pragma once
#include "fields/base/constants.h"
#include "twin/tether/lay_tether.h"
#include "twin/tether/tether_dynamics.h"

namespace slackwater::tests {

/// Blue Robotics' Fathom ROV Tether (R2): 7.6 mm, 0.043 kg/m, 350 lbf.
inline twin::Tether fathom() {
  twin::Tether tether;
  tether.diameter_m = 0.0076;
  tether.mass_per_m_kg = 0.043;
  tether.axial_stiffness_n = 5e4;
  tether.breaking_load_n = 1557;
  tether.longest_m = 150;
  tether.water_density_kg_m3 = constants::sea_water_density_kg_m3;
  return tether;
}

inline double section_m2(const twin::Tether& tether) {
  return constants::pi / 4 * tether.diameter_m * tether.diameter_m;
}

inline double weight_in_water_n_m(const twin::Tether& tether) {
  return constants::gravity_m_s2 *
         (tether.mass_per_m_kg - tether.water_density_kg_m3 * section_m2(tether));
}

/// A line that stretches by parts in a million and neither sinks nor rises.
inline twin::Tether stiff_and_neutral() {
  twin::Tether tether = fathom();
  tether.axial_stiffness_n = 5e7;
  tether.breaking_load_n = 1e6;
  tether.mass_per_m_kg = tether.water_density_kg_m3 * section_m2(tether);
  tether.tangential_drag_coefficient = 0;
  return tether;
}

/// A line that has come to rest between two ends held in steady water.
struct SettledLine {
  twin::TetherState<double> state;
  twin::TetherPull<double> pull;
};

inline SettledLine settled_line(const twin::Tether& tether, const twin::Triple<double>& top_m,
                                const twin::Triple<double>& vehicle_m, double length_m,
                                const twin::SteadyWater& water,
                                const twin::Triple<double>& bow = {1, 0.1, 0.2}) {
  SettledLine line;
  line.state = twin::settled(tether, twin::laid_out(tether, top_m, vehicle_m, length_m, bow), top_m,
                             vehicle_m, water);
  twin::TetherState<double> next = line.state;
  line.pull = twin::pull(tether, next, twin::TetherEnds<double>{top_m, {}, vehicle_m, {}},
                         twin::water_at_nodes(line.state, top_m, vehicle_m, water), 0.02);
  return line;
}

}  // namespace slackwater::tests
