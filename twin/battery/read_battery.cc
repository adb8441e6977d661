#include <cmath>

#include "fields/base/text.h"
#include "twin/battery/battery.h"
#include "twin/curve/named_file.h"

namespace slackwater::twin {
namespace {

struct Line {
  std::vector<double> x;
  std::vector<double> y;
};

/// Two lists of equal length, the first rising.
Line read_line(const Config& config, const char* x_key, Range x_range, const char* y_key,
               Range y_range) {
  Line line{config.numbers(x_key, x_range), config.numbers(y_key, y_range)};
  if (line.x.size() < 2) config.refuse(x_key, "give two values at least");
  if (line.y.size() != line.x.size()) {
    config.refuse(y_key, "found " + std::to_string(line.y.size()) + " values for the " +
                             std::to_string(line.x.size()) + " of " + x_key +
                             "; give one for each");
  }
  for (std::size_t i = 1; i < line.x.size(); ++i) {
    if (!(line.x[i] > line.x[i - 1]))
      config.refuse(x_key, formatted("found {:g} after {:g}; give them in rising order", line.x[i],
                                     line.x[i - 1]));
  }
  return line;
}

struct Cell {
  UniformAxis state_of_charge;
  std::vector<double> open_circuit_v;
};

Cell read_cell(const Config& cell) {
  const Line curve = read_line(cell, "state_of_charge", {0, 1}, "open_circuit_voltage_v", {0.5, 5});
  if (curve.x.front() != 0 || curve.x.back() != 1)
    cell.refuse("state_of_charge",
                formatted("found values from {:g} to {:g}; the curve reaches from 0 "
                          "(empty) to 1 (full)",
                          curve.x.front(), curve.x.back()));
  for (std::size_t i = 1; i < curve.y.size(); ++i) {
    if (!(curve.y[i] > curve.y[i - 1]))
      cell.refuse(
          "open_circuit_voltage_v",
          formatted("found {:g} V at the state of charge {:g}, no more than before it; a cell's "
                    "voltage rises with its charge",
                    curve.y[i], curve.x[i]));
  }
  const auto axis = uniform_axis_through(curve.x, 501);
  if (!axis)
    cell.refuse("state_of_charge", "the values have no common step of 0.002 or more; round them");
  return {*axis, on_axis(*axis, curve.x, curve.y)};
}

/// The factor at a temperature, of a table that must reach there.
double read_factor(const Config& cell, const char* key, const Config& pack,
                   double temperature_degc) {
  const Config c = cell.child(key);
  const Line line = read_line(c, "temperature_degc", {-60, 100}, "factor", {0.01, 20});
  if (temperature_degc < line.x.front() || temperature_degc > line.x.back())
    pack.refuse(
        "temperature_degc",
        formatted("found {:g}, but what is known of these cells reaches from {:g} to {:g} degrees",
                  temperature_degc, line.x.front(), line.x.back()));
  const UniformAxis there{temperature_degc, 1, 1};
  return on_axis(there, line.x, line.y).front();
}

void expect_voltage_of_pack(const Config& pack, const Battery& battery) {
  const double low = battery.open_circuit_v.front();
  const double high = battery.open_circuit_v.back();
  if (battery.least_voltage_v >= 0.6 * low && battery.least_voltage_v < high) return;
  pack.refuse(
      "least_voltage_v",
      formatted(
          "found {:g} V for a pack of {:g} V when empty and {:g} V when full; give the pack's "
          "voltage (not a cell's) below which a load ends it",
          battery.least_voltage_v, low, high));
}

/// A current that empties the pack in an hour must leave most of its voltage: catches mAh and mOhm.
void expect_resistance_suits_capacity(const Config& pack, double capacity_ah, double resistance_ohm,
                                      double full_v) {
  if (capacity_ah * resistance_ohm <= 0.5 * full_v) return;
  pack.refuse("capacity_ah",
              formatted("{:g} A, which would empty the pack in an hour, would cost {:g} V in its "
                        "resistance, of {:g} V; check the units (Ah, not mAh; ohm, not milliohm)",
                        capacity_ah, capacity_ah * resistance_ohm, full_v));
}

}  // namespace

Battery read_battery(const Config& pack, const std::filesystem::path& data_folder) {
  const Config cell = open_named(pack, "chemistry", data_folder / "batteries");
  (void)cell.text("name");
  (void)cell.text("source");
  const Cell curve = read_cell(cell);
  // Between the North Sea of winter and of summer; a pack in a hull takes on the temperature of the
  // water.
  const double temperature_degc = pack.optional_number("temperature_degc", {-40, 80}).value_or(15);
  const double capacity_factor = read_factor(cell, "capacity", pack, temperature_degc);
  const double resistance_factor = read_factor(cell, "resistance", pack, temperature_degc);
  cell.expect_all_read();

  const double cells = pack.integer("cells_in_series", 1, 400);
  Battery battery;
  battery.state_of_charge = curve.state_of_charge;
  for (const double v : curve.open_circuit_v) battery.open_circuit_v.push_back(cells * v);
  const double capacity_ah = pack.number("capacity_ah", {0.05, 20000});
  const double resistance_ohm = pack.number("resistance_ohm", {1e-6, 5});
  const double rc_resistance_ohm = pack.number("rc_resistance_ohm", {0, 5});
  battery.rc_capacitance_f = pack.number("rc_capacitance_f", {1, 1e9});
  expect_resistance_suits_capacity(pack, capacity_ah, resistance_ohm + rc_resistance_ohm,
                                   battery.open_circuit_v.back());
  battery.capacity_c = 3600 * capacity_ah * capacity_factor;
  battery.resistance_ohm = resistance_ohm * resistance_factor;
  battery.rc_resistance_ohm = rc_resistance_ohm * resistance_factor;
  battery.most_current_a = pack.number("most_current_a", {0.01, 1e5});
  battery.least_voltage_v = pack.number("least_voltage_v", {0.1, 5000});
  expect_voltage_of_pack(pack, battery);
  // ArduPilot acts on a low battery after so long (BATT_LOW_TIMER).
  battery.cut_off_delay_s = pack.optional_number("cut_off_delay_s", {0, 600}).value_or(10);
  return battery;
}

}  // namespace slackwater::twin
