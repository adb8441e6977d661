#include <algorithm>
#include <cmath>
#include <map>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/curve/named_file.h"
#include "twin/thruster/read_propeller.h"
#include "twin/thruster/thruster.h"

namespace slackwater::twin {
namespace {

/// 2 rho A of a propeller in the fluid that the file names by its density.
double read_disc(const Config& c, double diameter_m, double density_kg_m3) {
  return 2 * c.optional_number("fluid_density_kg_m3", {0.5, 1100}).value_or(density_kg_m3) *
         disc_area_m2(diameter_m);
}

/// Power of a loss-free disc over the power said to be drawn must be one a propeller has: catches
/// kgf for N, mm for m.
void expect_propeller_of_this_world(const Config& c, const char* key, double disc_kg_m,
                                    double thrust_n, double power_w) {
  const double share = disc_power_w(disc_kg_m, thrust_n, 0.0) / power_w;
  if (share >= 0.05 && share <= 1) return;
  c.refuse(
      key,
      formatted("{:g} N at rest for {:g} W is {:g} of what a disc of that size needs without loss, "
                "where propellers have 0.05 to 1 of their power; check the units (N, not "
                "kgf; metres) and the density",
                thrust_n, power_w, share));
}

// ---- a measured table

/// One voltage's measurements.
struct Measured {
  double voltage_v = 0;
  std::vector<double> command;
  std::vector<double> thrust_n;
  std::vector<double> power_w;
};

/// Servo pulse to command: -1 and 1 at the ends, 0 in the middle.
struct Pulse {
  double least_us = 0;
  double zero_us = 0;
  double most_us = 0;
  [[nodiscard]] double command(double us) const {
    return us < zero_us ? (us - zero_us) / (zero_us - least_us)
                        : (us - zero_us) / (most_us - zero_us);
  }
};

Pulse read_pulse(const Config& c) {
  constexpr Range range{500, 2500};
  const Pulse pulse{c.number("pwm_least_us", range), c.number("pwm_zero_us", range),
                    c.number("pwm_most_us", range)};
  if (!(pulse.least_us < pulse.zero_us && pulse.zero_us < pulse.most_us))
    c.refuse("pwm_zero_us", "expected pwm_least_us < pwm_zero_us < pwm_most_us");
  return pulse;
}

void expect_thrust_to_rise(const Config& c, const Measured& m) {
  for (std::size_t i = 0; i < m.command.size(); ++i) {
    if (i > 0 && !(m.command[i] > m.command[i - 1]))
      c.refuse("pwm_us", "give the pulses in rising order");
    if (i > 0 && m.thrust_n[i] < m.thrust_n[i - 1])
      c.refuse("thrust_n",
               formatted("found {:g} N after {:g} N; a greater command pushes no less. Smooth "
                         "the scatter of the measurement out",
                         m.thrust_n[i], m.thrust_n[i - 1]));
    if (m.command[i] == 0 && m.thrust_n[i] != 0)
      c.refuse("thrust_n", formatted("found {:g} N at pwm_zero_us; expected 0", m.thrust_n[i]));
  }
  const bool has_zero = std::find(m.command.begin(), m.command.end(), 0) != m.command.end();
  if (m.command.front() != -1 || m.command.back() != 1 || !has_zero)
    c.refuse("pwm_us", "give measurements at pwm_least_us, pwm_zero_us and pwm_most_us");
  if (!(m.thrust_n.front() < 0 && m.thrust_n.back() > 0))
    c.refuse("thrust_n", "expected negative thrust at pwm_least_us and positive at pwm_most_us");
}

Measured read_measured(const Config& c, const Pulse& pulse) {
  Measured m;
  m.voltage_v = c.number("voltage_v", {1, 1000});
  for (const double us : c.numbers("pwm_us", {pulse.least_us, pulse.most_us}))
    m.command.push_back(pulse.command(us));
  m.thrust_n = c.numbers("thrust_n", {-1e5, 1e5});
  m.power_w = c.numbers("power_w", {0, 1e7});
  if (m.command.size() < 3 || m.thrust_n.size() != m.command.size() ||
      m.power_w.size() != m.command.size()) {
    c.refuse("pwm_us", "found " + std::to_string(m.command.size()) + " pulses, " +
                           std::to_string(m.thrust_n.size()) + " of thrust_n and " +
                           std::to_string(m.power_w.size()) +
                           " of power_w; give one of each for three pulses at least");
  }
  expect_thrust_to_rise(c, m);
  return m;
}

UniformAxis axis_through(const Config& c, std::vector<double> points, const char* what) {
  std::sort(points.begin(), points.end());
  const auto same = [](double a, double b) { return std::abs(a - b) < 1e-9; };
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
  if (points.size() < 2) c.refuse("measured", std::string("give two ") + what + " at least");
  const auto axis = uniform_axis_through(points, 1001);
  if (!axis) c.refuse("measured", std::string("the ") + what + " have no common step; round them");
  return *axis;
}

/// Straight lines between the measurements, at the places of both axes.
std::vector<double> spread(const ThrustTable& table, const std::vector<Measured>& measured,
                           std::vector<double> Measured::*quantity) {
  std::vector<double> volts;
  std::vector<std::vector<double>> rows;
  for (const Measured& m : measured) {
    volts.push_back(m.voltage_v);
    rows.push_back(on_axis(table.command, m.command, m.*quantity));
  }
  const std::size_t columns = table.command.count;
  std::vector<double> values(table.voltage_v.count * columns);
  for (std::size_t j = 0; j < columns; ++j) {
    std::vector<double> down;
    down.reserve(rows.size());
    for (const auto& row : rows) down.push_back(row[j]);
    const std::vector<double> column = on_axis(table.voltage_v, volts, down);
    for (std::size_t i = 0; i < column.size(); ++i) values[i * columns + j] = column[i];
  }
  return values;
}

void read_table(const Config& c, Thruster& thruster) {
  ThrustTable& table = thruster.table;
  table.disc_kg_m = read_disc(c, c.number("propeller_diameter_m", diameter_range),
                              constants::sea_water_density_kg_m3);
  const Pulse pulse = read_pulse(c);
  std::vector<Measured> measured;
  std::vector<double> commands, volts;
  for (const Config& entry : c.children("measured")) {
    measured.push_back(read_measured(entry, pulse));
    const Measured& m = measured.back();
    if (!volts.empty() && !(m.voltage_v > volts.back()))
      entry.refuse("voltage_v", "give the voltages in rising order");
    expect_propeller_of_this_world(entry, "thrust_n", table.disc_kg_m, m.thrust_n.back(),
                                   m.power_w.back());
    volts.push_back(m.voltage_v);
    commands.insert(commands.end(), m.command.begin(), m.command.end());
  }
  table.voltage_v = axis_through(c, volts, "voltages");
  table.command = axis_through(c, commands, "pulses");
  table.thrust_n = spread(table, measured, &Measured::thrust_n);
  table.power_w = spread(table, measured, &Measured::power_w);
  index_thrusts(table);
  thruster.least_command = -1;
  thruster.most_command = 1;
}

// ---- formulas

void read_rotor(const Config& c, Thruster& thruster) {
  Rotor& rotor = thruster.rotor;
  const double diameter_m = c.number("propeller_diameter_m", diameter_range);
  rotor.radius_m = diameter_m / 2;
  rotor.disc_kg_m = read_disc(c, diameter_m, constants::air_density_kg_m3);
  rotor.thrust_n_s2 = c.number("thrust_n_s2", {1e-9, 10});
  rotor.torque_arm_m = c.number("torque_arm_m", {0, 1});
  rotor.efficiency = c.number("efficiency", efficiency_range);
  rotor.drag_n_s2_m = c.optional_number("drag_n_s2_m", {0, 1}).value_or(0);
  rotor.most_rad_s = c.number("most_shaft_rad_s", shaft_speed_range);
  rotor.full_speed_voltage_v = read_full_speed_voltage(c);
  // Thrust coefficient T/(rho A (w R)^2); 0.02 and more would be beyond any blade, 1e-4 no lift at
  // all.
  const double tip = rotor.radius_m;
  const double coefficient = 2 * rotor.thrust_n_s2 / (rotor.disc_kg_m * tip * tip);
  if (coefficient < 1e-4 || coefficient > 0.1)
    c.refuse("thrust_n_s2",
             formatted("makes a thrust coefficient of {:g}, where rotors have 0.002 to "
                       "0.05; give T/w^2 in N and rad/s, and the diameter in metres",
                       coefficient));
  thruster.most_command = rotor.most_rad_s;
}

void read_drive(const Config& c, Thruster& thruster) {
  Drive& drive = thruster.drive;
  drive.disc_kg_m = read_disc(c, c.number("propeller_diameter_m", diameter_range),
                              constants::sea_water_density_kg_m3);
  drive.most_thrust_n = c.number("most_thrust_n", {0.1, 1e7});
  drive.least_thrust_n = c.number("least_thrust_n", {-1e7, 0});
  drive.efficiency = c.number("efficiency", efficiency_range);
  drive.idle_power_w = c.optional_number("idle_power_w", {0, 1e7}).value_or(0);
  if (const auto most_w = c.optional_number("most_power_w", {1, 1e8})) {
    if (!(*most_w > drive.idle_power_w))
      c.refuse("most_power_w", formatted("found {:g} W, no more than the idle power", *most_w));
    drive.full_power_induced_m_s =
        std::cbrt(drive.efficiency * (*most_w - drive.idle_power_w) / drive.disc_kg_m);
  }
  // Grams per kilowatt hour are what engines are sold by; 150 is the best there is.
  if (const auto g_kwh = c.optional_number("fuel_g_kwh", {150, 1000}))
    drive.fuel_kg_j = *g_kwh / 1000 / 3.6e6;
  thruster.least_command = drive.least_thrust_n;
  thruster.most_command = drive.most_thrust_n;
}

void read_lag(const Config& c, Thruster& thruster) {
  constexpr Range range{0, 60};
  thruster.rise_time_constant_s = c.number("rise_time_constant_s", range);
  thruster.fall_time_constant_s = c.number("fall_time_constant_s", range);
}

Thruster read_described(const Config& c) {
  struct Reader {
    ThrusterKind kind;
    void (*read)(const Config&, Thruster&);
  };
  static const std::map<std::string, Reader, std::less<>> readers{
      {"table", {ThrusterKind::table, read_table}},
      {"propeller", {ThrusterKind::propeller, read_propeller}},
      {"rotor", {ThrusterKind::rotor, read_rotor}},
      {"drive", {ThrusterKind::drive, read_drive}}};
  (void)c.optional_text("name");
  (void)c.optional_text("source");
  const std::string kind = c.text("kind");
  const auto found = readers.find(kind);
  if (found == readers.end())
    c.refuse("kind", "found " + kind + ", expected table, propeller, rotor or drive");
  Thruster thruster;
  thruster.kind = found->second.kind;
  found->second.read(c, thruster);
  read_lag(c, thruster);
  return thruster;
}

}  // namespace

Thruster read_thruster(const Config& thruster, const std::filesystem::path& data_folder) {
  if (!thruster.has("model")) return read_described(thruster);
  const Config model = open_named(thruster, "model", data_folder / "thrusters");
  Thruster read = read_described(model);
  model.expect_all_read();
  return read;
}

}  // namespace slackwater::twin
