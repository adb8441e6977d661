// Vehicles of data/vehicles beside figures of theirs that others published, or that follow from
// published tables by another's arithmetic: tests/golden/vehicles/VEHICLE.golden, a row each,
//
//   vehicle | figure | inputs | value | tolerance | source
//
// with `%` of the value in the tolerance, or a number in its unit. A new vehicle is a file there
// and one in data/vehicles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "fields/base/constants.h"
#include "tests/support/vehicle_for_tests.h"
#include "twin/body/mass_matrix.h"
#include "twin/step/open_loop.h"
#include "twin/step/vehicle_step.h"
#include "twin/vehicle/balance.h"
#include "twin/vehicle/level_flight.h"

namespace slackwater::twin::published_figures_test {
namespace {

namespace fs = std::filesystem;
using constants::degree;

struct Inputs {
  std::map<std::string, double> value;
  [[nodiscard]] double operator[](const std::string& key) const {
    const auto found = value.find(key);
    if (found == value.end()) throw std::out_of_range("no input " + key);
    return found->second;
  }
};

/// What the water does to a vehicle that is held level at a speed, with a drift and a turn.
Spatial<double> force_of_water(const Vehicle& vehicle, const Spatial<double>& nu,
                               double rudder_rad) {
  const Body& body = vehicle.body;
  BodyState<double> way;
  way.position_m.z = body.hull.strips > 0
                         ? floating_depth_m(body.hull, body.mass_kg, body.fluid_density_kg_m3)
                         : 1000;
  way.attitude = attitude_of({0, 0, 0});
  way.nu = nu;
  Forcing<double> forcing;
  if (has_fins(vehicle)) forcing.tau = fins_force(vehicle, nu, rudder_rad, 0.0);
  return sum_of(body.rigid_mass, body.added_mass) * acceleration(body, way, forcing);
}

double thrust_at_speed_n(const Vehicle& vehicle, double speed_m_s) {
  return -force_of_water(vehicle, {{speed_m_s, 0, 0}, {}}, 0).linear.x;
}

/// Where a push that may fall with the speed is what the water takes.
double speed_of_push_m_s(const Vehicle& vehicle, const std::function<double(double)>& push_n) {
  double low = 0, high = 40;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (thrust_at_speed_n(vehicle, middle) < push_n(middle) ? low : high) = middle;
  }
  return low;
}

double speed_at_shaft_m_s(const Vehicle& vehicle, double turns_a_minute) {
  return speed_of_push_m_s(vehicle, [&](double speed_m_s) {
    ThrusterSurroundings<double> around;
    around.advance_m_s = speed_m_s;
    const double shaft_rad_s = turns_a_minute * 2 * constants::pi / 60;
    return static_cast<double>(vehicle.mounts) *
           run(vehicle.thrusters[0], shaft_rad_s, around).thrust_n;
  });
}

/// The nth largest real part of the eigenvalues of the equations of one plane, as textbooks have
/// them: no other velocity answers, so that no inertia but that of the plane takes part.
double eigenvalue_per_s(const Vehicle& vehicle, const Inputs& in, const std::vector<int>& states) {
  constexpr int velocities = 3;  // u v w p q r are the last six states
  const OpenLoopMatrix all = open_loop_matrix(vehicle, in["speed_m_s"]);
  const SpatialMatrix sum = sum_of(vehicle.body.rigid_mass, vehicle.body.added_mass);
  Eigen::Matrix<double, 6, 6> mass;
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < 6; ++k)
      mass(i, k) = sum.entry[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
  const Eigen::MatrixXd forces = mass * all.bottomRows<6>();
  const auto size = static_cast<Eigen::Index>(states.size());
  Eigen::MatrixXd inertia = Eigen::MatrixXd::Identity(size, size), slopes(size, size);
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index k = 0; k < size; ++k) {
      const int of = states[static_cast<std::size_t>(i)], by = states[static_cast<std::size_t>(k)];
      slopes(i, k) = of < velocities ? all(of, by) : forces(of - velocities, by);
      if (of >= velocities && by >= velocities)
        inertia(i, k) = mass(of - velocities, by - velocities);
    }
  const Eigen::MatrixXd block = inertia.inverse() * slopes;
  const Eigen::VectorXcd values = Eigen::EigenSolver<Eigen::MatrixXd>(block).eigenvalues();
  std::vector<double> real;
  for (Eigen::Index i = 0; i < size; ++i) real.push_back(values[i].real());
  std::sort(real.rbegin(), real.rend());
  return real.at(static_cast<std::size_t>(in["nth"]) - 1);
}

/// Sway and turn come to rest at a speed ahead that is held, level.
Spatial<double> steady_turn(const Vehicle& vehicle, const Inputs& in) {
  const SpatialMatrix mass = sum_of(vehicle.body.rigid_mass, vehicle.body.added_mass);
  Spatial<double> nu{{in["speed_m_s"], 0, 0}, {}};
  constexpr double step_s = 0.01, lasts_s = 30;
  for (double t_s = 0; t_s < lasts_s; t_s += step_s) {
    const Spatial<double> force = force_of_water(vehicle, nu, in["rudder_deg"] * degree);
    nu.linear.y += step_s * force.linear.y / mass.entry[1][1];
    nu.angular.z += step_s * force.angular.z / mass.entry[5][5];
  }
  return nu;
}

LevelFlight level(const Vehicle& vehicle, const Inputs& in) {
  return level_flight(vehicle, in["speed_m_s"], balance_of(vehicle).net_buoyancy_n);
}

/// States of the open loop (open_loop.h): v r; w q and pitch.
const std::vector<int> yaw_states{4, 8}, pitch_states{5, 7, 2};

const std::map<std::string, std::function<double(const Vehicle&, const Inputs&)>>& figures() {
  static const std::map<std::string, std::function<double(const Vehicle&, const Inputs&)>> all{
      {"thrust_at_speed_n",
       [](const Vehicle& v, const Inputs& in) { return thrust_at_speed_n(v, in["speed_m_s"]); }},
      {"speed_at_thrust_m_s",
       [](const Vehicle& v, const Inputs& in) {
         return speed_of_push_m_s(v, [&](double) { return in["thrust_n"]; });
       }},
      {"speed_at_shaft_m_s",
       [](const Vehicle& v, const Inputs& in) {
         return speed_at_shaft_m_s(v, in["turns_a_minute"]);
       }},
      {"yaw_eigenvalue_per_s",
       [](const Vehicle& v, const Inputs& in) { return eigenvalue_per_s(v, in, yaw_states); }},
      {"pitch_eigenvalue_per_s",
       [](const Vehicle& v, const Inputs& in) { return eigenvalue_per_s(v, in, pitch_states); }},
      {"turn_rate_rad_s",
       [](const Vehicle& v, const Inputs& in) { return steady_turn(v, in).angular.z; }},
      {"turn_radius_m",
       [](const Vehicle& v, const Inputs& in) {
         const Spatial<double> nu = steady_turn(v, in);
         return std::hypot(nu.linear.x, nu.linear.y) / nu.angular.z;
       }},
      {"level_flight_elevator_deg",
       [](const Vehicle& v, const Inputs& in) { return level(v, in).elevator_rad / degree; }},
      {"level_flight_pitch_deg",
       [](const Vehicle& v, const Inputs& in) { return level(v, in).pitch_rad / degree; }},
      {"metacentric_height_m",
       [](const Vehicle& v, const Inputs&) { return balance_of(v).stability_m; }},
      {"draught_m", [](const Vehicle& v, const Inputs&) { return balance_of(v).draught_m; }},
  };
  return all;
}

struct Row {
  std::string vehicle, figure, source;
  Inputs inputs;
  double value = 0, tolerance = 0;
};

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(' ');
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

Row row_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, '|');) cells.push_back(trimmed(cell));
  if (cells.size() != 6) throw std::invalid_argument("expected six cells: " + line);
  Row row;
  row.vehicle = cells[0];
  row.figure = cells[1];
  row.source = cells[5];
  std::istringstream inputs(cells[2]);
  for (std::string input; inputs >> input;) {
    const std::size_t equals = input.find('=');
    row.inputs.value[input.substr(0, equals)] = std::stod(input.substr(equals + 1));
  }
  row.value = std::stod(cells[3]);
  const bool is_share = cells[4].back() == '%';
  row.tolerance = std::stod(cells[4]) * (is_share ? 0.01 * std::abs(row.value) : 1);
  return row;
}

std::vector<Row> rows_of(const fs::path& file) {
  std::ifstream in(file);
  std::vector<Row> rows;
  for (std::string line; std::getline(in, line);)
    if (!line.empty() && line.front() != '#') rows.push_back(row_of(line));
  return rows;
}

TEST(PublishedFigures, AreThoseOfTheVehicles) {
  std::size_t count = 0;
  for (const auto& entry :
       fs::directory_iterator(tests::source_folder() / "tests/golden/vehicles")) {
    if (entry.path().extension() != ".golden") continue;
    const std::string id = entry.path().stem().string();
    const Vehicle vehicle = tests::bundled_vehicle(id);
    const std::vector<Row> rows = rows_of(entry.path());
    EXPECT_GT(rows.size(), 3U) << id;
    for (const Row& row : rows) {
      EXPECT_EQ(row.vehicle, id) << entry.path();
      EXPECT_FALSE(row.source.empty()) << id << " " << row.figure;
      ASSERT_TRUE(figures().contains(row.figure)) << id << ": no figure " << row.figure;
      const double found = figures().at(row.figure)(vehicle, row.inputs);
      std::string inputs;
      for (const auto& [key, value] : row.inputs.value)
        inputs += " " + key + "=" + std::to_string(value);
      EXPECT_NEAR(found, row.value, row.tolerance) << id << " " << row.figure << inputs;
      ++count;
    }
  }
  EXPECT_GT(count, 10U) << "the figures were not found";
}

TEST(PublishedFigures, ARowIsReadAsItStands) {
  const Row row = row_of("lauv | turn_radius_m | speed_m_s=1.5 rudder_deg=-5 | -11.5 | 2 % | a, b");
  EXPECT_EQ(row.vehicle, "lauv");
  EXPECT_EQ(row.inputs["speed_m_s"], 1.5);
  EXPECT_EQ(row.inputs["rudder_deg"], -5);
  EXPECT_EQ(row.value, -11.5);
  EXPECT_NEAR(row.tolerance, 0.23, 1e-12);
  EXPECT_EQ(row.source, "a, b");
  EXPECT_EQ(row_of("x | draught_m | | 2 | 0.01 | a").tolerance, 0.01);
  EXPECT_THROW((void)row_of("x | draught_m | 2 | 0.01 | a"), std::invalid_argument);
}

}  // namespace
}  // namespace slackwater::twin::published_figures_test
