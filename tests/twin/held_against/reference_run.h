#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "fields/base/constants.h"
#include "tests/support/shared_data.h"
#include "twin/step/vehicle_step.h"

namespace slackwater::tests {

/// A vehicle's way as rows of numbers, ours or somebody else's.
struct RunRows {
  std::map<std::string, std::vector<double>> column;

  [[nodiscard]] const std::vector<double>& operator[](const std::string& name) const {
    return column.at(name);
  }
  [[nodiscard]] double last(const std::string& name) const { return (*this)[name].back(); }
  /// At a time, straight between rows.
  [[nodiscard]] double at(const std::string& name, double t_s) const {
    const std::vector<double>&t = (*this)["t_s"], &value = (*this)[name];
    const auto after = std::lower_bound(t.begin() + 1, t.end() - 1, t_s - 1e-9);
    const auto i = static_cast<std::size_t>(after - t.begin());
    const double share = (t_s - t[i - 1]) / (t[i] - t[i - 1]);
    return value[i - 1] + share * (value[i] - value[i - 1]);
  }
  /// When a column first comes to a share of its last value.
  [[nodiscard]] double rise_s(const std::string& name, double share) const {
    const std::vector<double>&t = (*this)["t_s"], &value = (*this)[name];
    const double wanted = share * value.back();
    std::size_t i = 1;
    while (i + 1 < value.size() && value[i] < wanted) ++i;
    return t[i - 1] + (t[i] - t[i - 1]) * (wanted - value[i - 1]) / (value[i] - value[i - 1]);
  }
  void add(const std::vector<std::pair<std::string, double>>& row) {
    for (const auto& [name, value] : row) column[name].push_back(value);
  }
};

/// A run of ../shared/data/fossen; its README has the conditions of each.
inline RunRows reference_run(const std::filesystem::path& shared, const std::string& name) {
  std::ifstream in(shared / "data/fossen" / (name + ".csv"));
  EXPECT_TRUE(in.good()) << name;
  std::vector<std::string> names;
  std::string line, cell;
  std::getline(in, line);
  for (std::istringstream cells(line); std::getline(cells, cell, ',');) names.push_back(cell);
  RunRows rows;
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    for (const std::string& column : names) {
      std::getline(cells, cell, ',');
      rows.column[column].push_back(std::stod(cell));
    }
  }
  EXPECT_GT(rows["t_s"].size(), 100U) << name;
  return rows;
}

/// The columns that all these runs have, of a state of ours.
inline void add_row(RunRows& rows, double t_s, const twin::VehicleState<double>& state) {
  const twin::BodyState<double>& body = state.body;
  const twin::EulerAngles angles = twin::euler_angles(body.attitude);
  rows.add({{"t_s", t_s},
            {"north_m", body.position_m.x},
            {"east_m", body.position_m.y},
            {"down_m", body.position_m.z},
            {"roll_rad", angles.roll_rad},
            {"pitch_rad", angles.pitch_rad},
            {"yaw_rad", angles.yaw_rad},
            {"u_m_s", body.nu.linear.x},
            {"v_m_s", body.nu.linear.y},
            {"r_rad_s", body.nu.angular.z}});
}

/// Expects a figure of ours within a share of that of the reference, and prints both.
inline void expect_within(const std::string& what, double ours, double reference, double share) {
  std::printf("%-42s %10.5f, reference %10.5f: %+.2f %% of %g %%\n", what.c_str(), ours, reference,
              100 * (ours / reference - 1), 100 * share);
  EXPECT_NEAR(ours, reference, share * std::abs(reference)) << what;
}

}  // namespace slackwater::tests
