#pragma once
#include <filesystem>
#include <vector>

#include "fields/base/config.h"
#include "twin/curve/uniform_axis.h"

namespace slackwater::twin {

/// A battery as an equivalent circuit, at one temperature: a source whose voltage follows the state
/// of charge, a resistance, and a resistance beside a capacitor,
///
///   V = OCV(s) - I R0 - V1,   dV1/dt = I/C1 - V1/(R1 C1),   ds/dt = -I/Q.
///
/// Li-ion; counts coulombs (Peukert's law is one of lead-acid). Source: Plett, Battery Management
/// Systems I (2015), 2.
struct Battery {
  UniformAxis state_of_charge;         ///< from 0 to 1
  std::vector<double> open_circuit_v;  ///< of the pack, there; rising
  double capacity_c = 0;               ///< Q, at its temperature
  double resistance_ohm = 0;           ///< R0, at its temperature
  double rc_resistance_ohm = 0;        ///< R1, at its temperature; 0: no such pair
  double rc_capacitance_f = 0;         ///< C1
  double most_current_a = 0;           ///< continuous
  double least_voltage_v = 0;  ///< a load that holds it below this for `cut_off_delay_s` ends it
  double cut_off_delay_s = 0;
};

/// What changes in a battery; numbers only.
template <typename Real>
struct BatteryState {
  Real charge{};        ///< state of charge, 1 full, 0 empty
  Real rc_voltage_v{};  ///< V1
  Real low_for_s{};     ///< how long the voltage has been too low
  Real off{};           ///< 1: cut off or empty, and stays so
  Real drawn_c{};       ///< charge given so far
  Real delivered_j{};   ///< energy given so far
};

/// At rest at a state of charge from 0 to 1.
[[nodiscard]] BatteryState<double> rested(const Battery& battery, double state_of_charge);

/// Between the terminals without a load.
[[nodiscard]] double rest_voltage_v(const Battery& battery, const BatteryState<double>& state);

/// Energy that the source gives between two states of charge without any current to speak of: the
/// area under its curve.
[[nodiscard]] double open_circuit_energy_j(const Battery& battery, double from_charge,
                                           double to_charge);

/// Reads the `battery` of a vehicle: a pack of cells whose curve is in
/// data_folder/batteries/CHEMISTRY.yaml.
/// Throws Error(invalid_input) with file, line and reason.
[[nodiscard]] Battery read_battery(const Config& battery, const std::filesystem::path& data_folder);

}  // namespace slackwater::twin
