#include "twin/step/plane_modes.h"

#include <algorithm>
#include <array>
#include <span>

#include <Eigen/Dense>

#include "twin/step/open_loop.h"

namespace slackwater::twin {
namespace {

std::vector<std::complex<double>> modes_of(const OpenLoopMatrix& matrix,
                                           std::span<const int> states) {
  const auto size = static_cast<Eigen::Index>(states.size());
  Eigen::MatrixXd block(size, size);
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j < size; ++j)
      block(i, j) =
          matrix(states[static_cast<std::size_t>(i)], states[static_cast<std::size_t>(j)]);
  const Eigen::VectorXcd values = block.eigenvalues();
  std::vector<std::complex<double>> modes;
  for (const std::complex<double>& value : values)
    if (value.imag() >= 0) modes.push_back(value);
  std::sort(modes.begin(), modes.end(), [](const auto& a, const auto& b) {
    return a.real() != b.real() ? a.real() > b.real() : a.imag() < b.imag();
  });
  return modes;
}

}  // namespace

PlaneModes plane_modes(const Vehicle& vehicle, double speed_m_s) {
  const OpenLoopMatrix matrix = open_loop_matrix(vehicle, speed_m_s);
  // Places in the state: depth, roll, pitch, u, v, w, p, q, r.
  constexpr std::array<int, 5> vertical{0, 2, 3, 5, 7};
  constexpr std::array<int, 4> horizontal{1, 4, 6, 8};
  return {modes_of(matrix, vertical), modes_of(matrix, horizontal)};
}

}  // namespace slackwater::twin
