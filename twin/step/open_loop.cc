#include "twin/step/open_loop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Dense>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/step/vehicle_step.h"
#include "twin/vehicle/driven.h"
#include "twin/vehicle/own_autopilot.h"

namespace slackwater::twin {
namespace {

using State = Eigen::Matrix<double, open_loop_states, 1>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

Vector6 vector_of(const Spatial<double>& s) {
  Vector6 out;
  out << s.linear.x, s.linear.y, s.linear.z, s.angular.x, s.angular.y, s.angular.z;
  return out;
}

/// The way itself, and the forces that hold the vehicle on it.
class StraightAndLevel {
 public:
  StraightAndLevel(const Vehicle& vehicle, double speed_m_s) : vehicle_(vehicle) {
    const Body& body = vehicle.body;
    constexpr double deep_m = 1000;  // of the surface it feels nothing there
    way_.position_m.z = body.hull.strips > 0
                            ? floating_depth_m(body.hull, body.mass_kg, body.fluid_density_kg_m3)
                            : deep_m;
    way_.attitude = attitude_of({0, 0, 0});
    way_.nu.linear.x = speed_m_s;
    Eigen::Matrix<double, 6, 6> inverse_mass;
    for (int i = 0; i < 6; ++i)
      for (int k = 0; k < 6; ++k)
        inverse_mass(i, k) =
            body.inverse_mass.entry[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
    const Vector6 held = -inverse_mass.inverse() * vector_of(accelerated(way_));
    held_ = {{held[0], held[1], held[2]}, {held[3], held[4], held[5]}};
  }

  [[nodiscard]] const BodyState<double>& way() const noexcept { return way_; }
  [[nodiscard]] Forcing<double> forcing(const BodyState<double>& at) const {
    Forcing<double> forcing;
    forcing.tau = held_;
    if (has_fins(vehicle_)) forcing.tau = forcing.tau + fins_force(vehicle_, at.nu, 0.0, 0.0);
    return forcing;
  }
  [[nodiscard]] Spatial<double> accelerated(const BodyState<double>& at) const {
    return acceleration(vehicle_.body, at, forcing(at));
  }
  /// d/dt of the state at a state that differs from the way.
  [[nodiscard]] State rate(const State& off) const {
    BodyState<double> at = way_;
    at.position_m.z += off[0];
    at.attitude = attitude_of({off[1], off[2], 0});
    at.nu.linear = at.nu.linear + Triple<double>{off[3], off[4], off[5]};
    at.nu.angular = {off[6], off[7], off[8]};
    State out;
    out[0] = rotation_of(at.attitude).to_ned(at.nu.linear).z;
    // Roll and pitch of small angles.
    out[1] = off[6];
    out[2] = off[7];
    out.tail<6>() = vector_of(accelerated(at));
    return out;
  }

 private:
  const Vehicle& vehicle_;
  BodyState<double> way_;
  Spatial<double> held_;
};

constexpr double slowest_per_s = 1.0 / 600;

void note_modes(const OpenLoopMatrix& matrix, OpenLoop& out) {
  const Eigen::EigenSolver<OpenLoopMatrix> modes(matrix);
  const Eigen::EigenSolver<OpenLoopMatrix>::EigenvectorsType vectors = modes.eigenvectors();
  for (int i = 0; i < open_loop_states; ++i) {
    const double growth_per_s = modes.eigenvalues()[i].real();
    if (!(growth_per_s > slowest_per_s)) continue;
    const double p = std::abs(vectors(6, i)), q = std::abs(vectors(7, i)),
                 r = std::abs(vectors(8, i));
    double& of = q >= p && q >= r ? out.pitch_per_s : r >= p ? out.yaw_per_s : out.roll_per_s;
    of = std::max(of, growth_per_s);
  }
}

/// From a degree off, for long enough for that to grow to what it comes to.
void note_motion(const Vehicle& vehicle, const OpenLoopMatrix& matrix, OpenLoop& out) {
  constexpr double first_rad = constants::degree, grown_times = 12, longest_s = 300;
  constexpr double longest_step_s = 0.2, step_in_fastest = 0.5;
  double slowest_growth_per_s = std::numeric_limits<double>::infinity();
  for (const double grows : {out.pitch_per_s, out.yaw_per_s, out.roll_per_s})
    if (grows > 0) slowest_growth_per_s = std::min(slowest_growth_per_s, grows);
  const double lasts_s = std::min(grown_times / slowest_growth_per_s, longest_s);
  const double fastest_per_s = matrix.eigenvalues().cwiseAbs().maxCoeff();
  const double dt_s = std::min(longest_step_s, step_in_fastest / fastest_per_s);
  const StraightAndLevel level(vehicle, out.speed_m_s);
  BodyState<double> at = level.way();
  at.attitude = attitude_of({0, first_rad, 0});
  at.nu.linear.y = out.speed_m_s * std::sin(first_rad);
  for (double t_s = 0; t_s < lasts_s; t_s += dt_s) {
    at = stepped(vehicle.body, at, level.forcing(at), dt_s);
    const Rotation<double> r = rotation_of(at.attitude);
    if (!(r.down.z > 0)) {
      out.goes_over = true;
      return;
    }
    out.largest_pitch_rad =
        std::max(out.largest_pitch_rad, std::asin(std::min(std::abs(r.down.x), 1.0)));
    out.turn_rad_s = std::abs(at.nu.angular.z);
  }
}

OpenLoop open_loop_at(const Vehicle& vehicle, double speed_m_s) {
  OpenLoop out;
  out.speed_m_s = speed_m_s;
  const OpenLoopMatrix matrix = open_loop_matrix(vehicle, speed_m_s);
  note_modes(matrix, out);
  if (!out.is_stable()) note_motion(vehicle, matrix, out);
  return out;
}

/// Where all that pushes ahead meets its resistance.
double fastest_m_s(const Vehicle& vehicle) {
  const double voltage_v = usual_voltage_v(vehicle);
  const Body& body = vehicle.body;
  constexpr double faster_than_any_m_s = 40;
  return greatest(faster_than_any_m_s, [&](double speed_m_s) {
    const double drag_n =
        (body.linear_damping.linear.x + body.quadratic_damping.linear.x * speed_m_s) * speed_m_s;
    return driven(vehicle, voltage_v, speed_m_s, 1).push_n >= drag_n;
  });
}

}  // namespace

OpenLoopMatrix open_loop_matrix(const Vehicle& vehicle, double speed_m_s) {
  const StraightAndLevel level(vehicle, speed_m_s);
  // So small that what goes with the square of the speed has no part in it.
  constexpr double step = 1e-6;
  OpenLoopMatrix matrix;
  for (int i = 0; i < open_loop_states; ++i) {
    State off = State::Zero();
    off[i] = step;
    matrix.col(i) = (level.rate(off) - level.rate(-off)) / (2 * step);
  }
  return matrix;
}

OpenLoop open_loop_of(const Vehicle& vehicle) {
  if (vehicle.kind == VehicleKind::uav) return {};
  OpenLoop out = open_loop_at(vehicle, vehicle.cruise_speed_m_s);
  if (out.goes_over) return out;
  const double fastest = fastest_m_s(vehicle);
  if (fastest > out.speed_m_s && open_loop_at(vehicle, fastest).goes_over)
    out.over_at_m_s = fastest;
  return out;
}

std::string words_of(const OpenLoop& open_loop) {
  std::vector<std::string> does;
  const auto grows = [](const char* what, double per_s) {
    return formatted("{} grows e-fold in {:.2g} s", what, 1 / per_s);
  };
  if (open_loop.pitch_per_s > 0)
    does.push_back(grows("pitch", open_loop.pitch_per_s) +
                   (open_loop.goes_over
                        ? ", and it somersaults: keep a hold of depth or attitude on"
                        : formatted(", to {:.0f} degrees: keep a hold of depth or attitude on",
                                    open_loop.largest_pitch_rad / constants::degree)));
  if (open_loop.yaw_per_s > 0)
    does.push_back(
        grows("yaw", open_loop.yaw_per_s) +
        (open_loop.goes_over
             ? ": keep a hold of heading on"
             : formatted(", and it circles at {:.2g} degrees/s: keep a hold of heading on",
                         open_loop.turn_rad_s / constants::degree)));
  if (open_loop.roll_per_s > 0)
    does.push_back(grows("roll", open_loop.roll_per_s) +
                   (open_loop.goes_over ? ", and it rolls over" : ""));
  std::string text;
  if (!does.empty())
    text = formatted("without a controller it does not go straight at {:.3g} m/s: ",
                     open_loop.speed_m_s) +
           joined(does, "; ");
  if (open_loop.over_at_m_s)
    text += (text.empty() ? "without a controller " : "; ") +
            formatted("with all its thrust, at {:.2g} m/s, it somersaults", *open_loop.over_at_m_s);
  return text;
}

}  // namespace slackwater::twin
