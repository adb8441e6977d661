#include "twin/vehicle/read_derivatives.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

constexpr std::string_view forces = "XYZKMN";
constexpr std::string_view motions = "uvwpqr";
constexpr Range any_derivative{-1e9, 1e9};

/// `Y_r` of row 1 and column 5.
std::string derivative_name(std::size_t row, std::size_t column, const char* after = "") {
  return std::string{forces[row], '_', motions[column]} + after;
}

/// Against its own motion: the positive of it, or 0 where the file does not say.
double read_resistance(const Config& config, const std::string& name) {
  const double value = config.optional_number(name, any_derivative).value_or(0);
  if (value > 0) {
    config.refuse(name, formatted("found {:g}, which would push the vehicle on its way; SNAME "
                                  "derivatives of resistance are negative: give {:g}",
                                  value, -value));
  }
  return value == 0 ? 0 : -value;
}

std::array<double, 6> read_diagonal(const Config& config, const char* after, bool is_quadratic) {
  std::array<double, 6> out{};
  for (std::size_t i = 0; i < 6; ++i) {
    std::string name = derivative_name(i, i, after);
    if (is_quadratic) name += std::string("_abs_") + motions[i];
    out[i] = read_resistance(config, name);
  }
  return out;
}

Spatial<double> spatial_diagonal(const std::array<double, 6>& d) {
  return {{d[0], d[1], d[2]}, {d[3], d[4], d[5]}};
}

/// One number of a symmetric pair, from either or both of its names.
double read_pair(const Config& config, const std::string& name, const std::string& mirrored) {
  const auto a = config.optional_number(name, any_derivative);
  const auto b = config.optional_number(mirrored, any_derivative);
  if (!a || !b) return a.value_or(b.value_or(0));
  constexpr double printed = 1e-3;  // of what tables print in three to four digits
  if (std::abs(*a - *b) > printed * std::max(std::abs(*a), std::abs(*b)))
    config.refuse(mirrored, formatted("found {:g} and {} {:g}; added mass is symmetric, so that "
                                      "the two are one number: give one of them",
                                      *b, name, *a));
  return 0.5 * (*a + *b);
}

void refuse_two_words_for_one_lift(const Config& config, const Body& body) {
  if (body.trailing_edge_kg_m == 0) return;
  for (const char* name : {"Y_uv", "Y_ur", "N_uv", "N_ur"})
    if (config.has(name))
      config.refuse(name,
                    "found it beside trailing_edge, which makes the same force of the shape of the "
                    "stern; give one of the two");
}

}  // namespace

SpatialMatrix read_added_mass(const Config& vehicle) {
  SpatialMatrix mass;
  const auto c = vehicle.optional_child("added_mass");
  if (!c) return mass;
  const std::array<double, 6> diagonal = read_diagonal(*c, "_dot", false);
  for (std::size_t i = 0; i < 6; ++i) {
    mass.entry[i][i] = diagonal[i];
    for (std::size_t j = i + 1; j < 6; ++j) {
      const double pair =
          read_pair(*c, derivative_name(i, j, "_dot"), derivative_name(j, i, "_dot"));
      mass.entry[i][j] = mass.entry[j][i] = pair == 0 ? 0 : -pair;
    }
  }
  return mass;
}

void read_damping(const Config& vehicle, Body& body) {
  const auto c = vehicle.optional_child("damping");
  if (!c) return;
  body.linear_damping = spatial_diagonal(read_diagonal(*c, "", false));
  body.quadratic_damping = spatial_diagonal(read_diagonal(*c, "", true));
  CrossDamping& cross = body.cross_damping;
  const auto resisting = [&](const std::string& name) {
    const double value = c->optional_number(name, any_derivative).value_or(0);
    cross.is_there = cross.is_there || value != 0;
    return value == 0 ? 0 : -value;
  };
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      if (i != j) cross.linear.entry[i][j] = resisting(derivative_name(i, j));
  cross.y_r = resisting("Y_r_abs_r");
  cross.n_v = resisting("N_v_abs_v");
  cross.z_q = resisting("Z_q_abs_q");
  cross.m_w = resisting("M_w_abs_w");
}

void read_lift(const Config& vehicle, Body& body) {
  const auto c = vehicle.optional_child("lift");
  if (!c) return;
  refuse_two_words_for_one_lift(*c, body);
  SpeedLift& lift = body.speed_lift;
  lift.is_there = true;
  const std::string munk = c->optional_text("munk").value_or("apart");
  if (munk != "apart" && munk != "included" && munk != "left_out")
    c->refuse("munk", "found " + munk +
                          ", expected apart (M_uw and N_uv are lift alone), included (they hold "
                          "the moment of the added mass) or left_out (their source has no such "
                          "moment, and none is to act)");
  if (munk == "included" && !c->has("M_uw") && !c->has("N_uv"))
    c->refuse("munk", "found included and neither M_uw nor N_uv, which would hold it; give them");
  lift.without_munk = munk == "left_out";
  // With what -C_A nu_r has of each for a vehicle that goes ahead.
  const auto& a = body.added_mass.entry;
  const auto read = [&](const char* name, double& derivative, double by_added_mass) {
    const auto value = c->optional_number(name, any_derivative);
    if (value) derivative = *value - (munk == "included" ? by_added_mass : 0);
  };
  read("Y_uv", lift.y_uv, 0);
  read("Y_ur", lift.y_ur, -a[0][0]);
  read("N_uv", lift.n_uv, a[0][0] - a[1][1]);
  read("N_ur", lift.n_ur, -a[1][5]);
  read("Z_uw", lift.z_uw, 0);
  read("Z_uq", lift.z_uq, a[0][0]);
  read("M_uw", lift.m_uw, a[2][2] - a[0][0]);
  read("M_uq", lift.m_uq, a[2][4]);
  read("K_up", lift.k_up, 0);
}

std::optional<std::string> motion_driven_by_damping(const Body& body) {
  if (!body.cross_damping.is_there) return std::nullopt;
  const Spatial<double>& d = body.linear_damping;
  const std::array<double, 6> diagonal{d.linear.x,  d.linear.y,  d.linear.z,
                                       d.angular.x, d.angular.y, d.angular.z};
  Eigen::Matrix<double, 6, 6> half;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      const auto row = static_cast<std::size_t>(i), column = static_cast<std::size_t>(j);
      half(i, j) = i == j ? diagonal[row]
                          : 0.5 * (body.cross_damping.linear.entry[row][column] +
                                   body.cross_damping.linear.entry[column][row]);
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solved(half);
  const double least = solved.eigenvalues()[0];
  if (least >= -1e-9 * solved.eigenvalues().cwiseAbs().maxCoeff()) return std::nullopt;
  std::string motion;
  for (int i = 0; i < 6; ++i) {
    const double part = solved.eigenvectors()(i, 0);
    if (std::abs(part) < 0.01) continue;
    motion += formatted("{}{} {:.2g}", motion.empty() ? "" : ", ",
                        motions[static_cast<std::size_t>(i)], part);
  }
  return formatted(
      "damping: found that its linear part drives the motion ({}) by {:.3g} W instead of resisting "
      "it; expected it to slow every motion. Check the signs off the diagonal (Y_r, N_v, Z_q, M_w)",
      motion, -least);
}

}  // namespace slackwater::twin
